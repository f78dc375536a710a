#include "CellRuns.h"

#include "CellCrossings.h"
#include "detail/Blocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace mote
{

namespace
{

constexpr std::size_t runLength = 64;

/// Bounds grow by this share of the mesh's size, against rounding.
constexpr double margin = 1e-9;

bool meets(const HexRay& ray, const Box& box)
{
  double from = ray.tMin, to = ray.tMax;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double o = ray.origin[axis], d = ray.direction[axis];
    if (d == 0.0)
    {
      if (o < box.lower[axis] || o > box.upper[axis])
        return false;
      continue;
    }
    const double one = (box.lower[axis] - o) / d, other = (box.upper[axis] - o) / d;
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
  }
  return from <= to;
}

} // namespace

CellRuns::CellRuns(const HexMesh& mesh)
  : bounds_((mesh.cellCount() + runLength - 1) / runLength)
{
  const double around = margin * glm::length(mesh.bounds().size());
  forBlocks(bounds_.size(),
    [&](std::size_t run)
    {
      Box box;
      const std::size_t end = std::min(mesh.cellCount(), (run + 1) * runLength);
      for (std::size_t c = run * runLength; c < end; ++c)
        for (const std::uint32_t point : mesh.cell(c))
          box.add(mesh.point(point));
      bounds_[run] = box.expanded(around);
    });
}

std::vector<CellSpan> CellRuns::spansOf(const HexMesh& mesh, const HexRay& ray) const
{
  const CrossingLine line(ray.origin, ray.direction);
  std::vector<CellSpan> spans;
  std::array<std::uint32_t, runLength> cells;
  SpanBatch batch;
  for (std::size_t run = 0; run < bounds_.size(); ++run)
  {
    if (!meets(ray, bounds_[run]))
      continue;
    const std::size_t first = run * runLength;
    const std::size_t count = std::min(runLength, mesh.cellCount() - first);
    std::iota(cells.begin(), cells.end(), static_cast<std::uint32_t>(first));
    for (std::size_t done = 0; done < count;)
    {
      batch.clear();
      done += line.addSpans(mesh, cells.data() + done, count - done, ray.tMin, ray.tMax, batch);
      spans.insert(spans.end(), batch.begin(), batch.end());
    }
  }
  std::sort(spans.begin(), spans.end(),
    [](const CellSpan& a, const CellSpan& b)
    { return a.tIn != b.tIn ? a.tIn < b.tIn : a.cell < b.cell; });
  return spans;
}

} // namespace mote
