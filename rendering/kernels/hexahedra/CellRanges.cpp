#include "CellRanges.h"

#include "../core/Error.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>

namespace mote
{

namespace
{

constexpr ScalarRange everything{
  -std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity()};

void add(ScalarRange& range, double value)
{
  // Rounded outwards.
  const float f = static_cast<float>(value);
  const float low = f > value ? std::nextafter(f, everything.lower) : f;
  const float high = f < value ? std::nextafter(f, everything.upper) : f;
  range.add(std::isnan(value) ? everything : ScalarRange{low, high});
}

template <typename Value>
void fill(const HexMesh& mesh, bool ofCells, const Value& value, RawVector<ScalarRange>& ranges)
{
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, ranges.size(), 1 << 12),
    [&](const tbb::blocked_range<std::size_t>& block)
    {
      for (std::size_t c = block.begin(); c < block.end(); ++c)
      {
        ScalarRange range;
        if (ofCells)
          add(range, value(mesh.inputCell(c)));
        else
          for (const std::uint32_t p : mesh.cell(c))
            add(range, value(p));
        ranges[c] = range;
      }
    });
}

} // namespace

RawVector<ScalarRange> cellRanges(const HexMesh& mesh, const HexScalar& scalar)
{
  const std::size_t wanted = scalar.ofCells ? mesh.report().cells : mesh.pointCount();
  if (scalar.values.count() != wanted)
    throw Error("There are " + std::to_string(scalar.values.count()) + " scalars for " +
                std::to_string(wanted) + (scalar.ofCells ? " cells." : " points."));
  if (wanted > 0 &&
      (scalar.component < ArrayView::magnitude || scalar.component >= scalar.values.components()))
    throw Error("The scalars have no component " + std::to_string(scalar.component) + ".");
  RawVector<ScalarRange> ranges(mesh.cellCount());
  const ArrayView& v = scalar.values;
  if (v.type() == ArrayView::Type::Float32 && v.components() == 1)
    fill(
      mesh, scalar.ofCells,
      [f = static_cast<const float*>(v.data())](std::size_t i) { return f[i]; }, ranges);
  else
    fill(
      mesh, scalar.ofCells, [&](std::size_t i) { return v.value(i, scalar.component); }, ranges);
  return ranges;
}

} // namespace mote
