#ifndef MoteMeridionalCell_h
#define MoteMeridionalCell_h

#include "MeridionalBins.h"

#include <array>
#include <vector>

namespace mote
{

/// What a cell brings: its shape and its corners' values.
struct Sampled
{
  CollapsedCell cell;
  double side;                   ///< -1 for a cell that is inside out
  std::array<Vec3d, 8> values{}; ///< scalars in x
  double middle = 0.0;           ///< that squares of scalars are taken from
};

/// Adds the cell's volume and values to the bins that it reaches into. Cells that reach over few
/// bins are cut into pieces of a third of a bin; those that reach over many into lines, which are
/// cut where bins end.
void addCell(std::vector<Bin>& bins, const BinGrid& grid, const Axis& axis, const Sampled& from,
  bool isVector);

} // namespace mote

#endif
