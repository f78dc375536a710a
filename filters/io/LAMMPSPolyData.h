#ifndef MoteLAMMPSPolyData_h
#define MoteLAMMPSPolyData_h

#include "LAMMPSColumns.h"
#include "LAMMPSDump.h"
#include "Piece.h"

#include <functional>
#include <memory>
#include <string>

class vtkPolyData;

namespace mote
{

class ScratchSpace;

/// How a frame becomes a vtkPolyData.
struct LAMMPSReadOptions
{
  bool combine = true;          ///< see layoutOf
  bool singlePrecision = false; ///< Float32 for what would be Float64, save positions
  std::function<bool(const std::string& array)> wanted; ///< arrays to make; empty means all
  std::shared_ptr<ScratchSpace> space;                  ///< see PointRows
  Piece piece;                                          ///< of the atoms
};

/// Reads one frame into `output`, which should be empty: points, one vertex cell an atom, point
/// data (with a "type" numbered from words where no column is so named), and the frame's header as
/// field data. Throws FileError, and then `output` must be dropped.
void readLAMMPSFrame(const std::string& path, const LAMMPSFrame& frame,
  const LAMMPSReadOptions& options, const Progress& progress, vtkPolyData* output);

} // namespace mote

#endif
