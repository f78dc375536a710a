#pragma once

#include "HexMesh.h"
#include "HexRay.h"

#include <cstddef>
#include <vector>

namespace mote
{

/// Bounds of runs of cells, which follow one another in the mesh: enough for single rays, such as
/// those of picks, where no structure is there. Takes less than a byte a cell. A ray looks at all
/// bounds, and at the cells of those that it meets: few where cells that follow one another lie
/// side by side, as those of meshers do.
class CellRuns
{
public:
  /// In parallel.
  explicit CellRuns(const HexMesh& mesh);

  /// The parts of a ray in the cells of the same mesh, by where they begin.
  std::vector<CellSpan> spansOf(const HexMesh& mesh, const HexRay& ray) const;

  std::size_t bytes() const { return bounds_.size() * sizeof(Box); }

private:
  std::vector<Box> bounds_;
};

} // namespace mote
