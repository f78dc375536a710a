#pragma once

#include "ArrayColors.h"
#include "MapperClip.h"
#include "MapperSlices.h"
#include "RendererImage.h"
#include "VisibleCells.h"
#include "VolumeInput.h"
#include "vtkMoteShading.h"
#include "vtkMoteVolumeMapper.h"

#include "vtkNew.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <list>
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

  /// The same for copies in which vectors have turned, so that a component of theirs is another
  /// field.
  struct Turned : mote::BuiltVolume
  {
    mote::Vec3d along{0.0}; ///< HexScalar::along
    bool isSeen = false;    ///< in the scene that is described
    std::weak_ptr<const mote::HexStructure> from;

    bool isOf(const mote::BuiltVolume& whole) const
    {
      return field && fieldKey == whole.fieldKey && geometry.mesh() == whole.geometry.mesh() &&
             from.lock() == whole.geometry.structure();
    }
    void take(const mote::BuiltVolume& whole, std::shared_ptr<const mote::HexField> own)
    {
      geometry = whole.geometry;
      from = whole.geometry.structure();
      fieldKey = whole.fieldKey;
      field = std::move(own);
      walk = nullptr;
      geometry.setRanges(*field);
    }
  };
  std::list<Turned> turned;

  Turned& turnedAlong(const mote::Vec3d& along)
  {
    auto found = std::find_if(
      turned.begin(), turned.end(), [&](const Turned& one) { return one.along == along; });
    if (found == turned.end())
      found = turned.emplace(turned.end());
    found->along = along;
    found->isSeen = true;
    return *found;
  }
  /// Forgets those that were not asked for since the last time.
  void dropTurned()
  {
    turned.remove_if([](Turned& one) { return !std::exchange(one.isSeen, false); });
  }

  vtkMTimeType failedAt = 0; ///< of the picture that could not be made: not tried again

  // The last of each kind of message, so that it is told once and not every frame.
  std::string reported;
  std::string reportedLook;
  std::string reportedUnused;

  mote::RendererImages images;    ///< for renderers that have no vtkMoteRayCastPass
  vtkNew<vtkMoteShading> shading; ///< the same

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
