#pragma once

#include "ArrayColors.h"
#include "MapperClip.h"
#include "MapperSlices.h"
#include "RendererImage.h"
#include "VisibleCells.h"
#include "VolumeInput.h"
#include "vtkMoteVolumeMapper.h"

#include "vtkTimeStamp.h"

#include <memory>
#include <string>
#include <utility>

/// What the mapper keeps between frames.
class vtkMoteVolumeMapper::Internals : public mote::BuiltVolume
{
public:
  std::shared_ptr<const mote::BuiltVolume> offered; ///< by another mapper
  vtkTimeStamp changedAt;                           ///< when geometry or field last did
  int builds = 0;
  int fieldUpdates = 0;

  mote::VisibleCells visible;
  mote::MapperClip clip;
  mote::MapperSlices slices;
  mote::HiddenOfMesh hidden;

  mote::ArrayColors colors;

  vtkMTimeType failedAt = 0; ///< of the picture that could not be made: not tried again

  // The last of each kind of message, so that it is told once and not every frame.
  std::string reported;
  std::string reportedLook;
  std::string reportedUnused;

  mote::RendererImages images; ///< for renderers that have no vtkMoteRayCastPass

  /// Whether what was made of the grid's cells can be drawn. `options`: of the structure that is
  /// needed; null: none is.
  static bool fits(
    mote::VolumeGeometry& made, vtkUnstructuredGrid* grid, const mote::HexStructureOptions* options)
  {
    return made.hasCellsOf(grid) && (!options || made.hasStructure(*options));
  }

  /// Takes what was offered, where it fits.
  void takeOffer(vtkUnstructuredGrid* grid, const mote::HexStructureOptions* options)
  {
    const auto from = std::exchange(offered, nullptr);
    mote::BuiltVolume taken = from ? *from : mote::BuiltVolume();
    if (!from || !fits(taken.geometry, grid, options))
      return;
    static_cast<mote::BuiltVolume&>(*this) = std::move(taken);
    changedAt.Modified();
  }
};
