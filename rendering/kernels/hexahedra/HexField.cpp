#include "HexField.h"

#include "../core/Error.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>

namespace mote
{

namespace
{

constexpr std::size_t grain = 1 << 14;

struct Extent
{
  double lower = std::numeric_limits<double>::infinity();
  double upper = -std::numeric_limits<double>::infinity();
};

template <typename Value>
Extent extentOf(std::size_t count, const Value& value)
{
  return tbb::parallel_reduce(
    tbb::blocked_range<std::size_t>(0, count, grain), Extent{},
    [&](const tbb::blocked_range<std::size_t>& block, Extent extent)
    {
      for (std::size_t i = block.begin(); i < block.end(); ++i)
        if (const double v = value(i); std::isfinite(v))
        {
          extent.lower = std::min(extent.lower, v);
          extent.upper = std::max(extent.upper, v);
        }
      return extent;
    },
    [](const Extent& a, const Extent& b) {
      return Extent{std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
    });
}

template <typename Value>
void copy(RawVector<float>& to, const Value& value, double offset)
{
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, to.size(), grain),
    [&](const tbb::blocked_range<std::size_t>& block)
    {
      for (std::size_t i = block.begin(); i < block.end(); ++i)
      {
        const double v = value(i) - offset;
        to[i] = std::isfinite(v) ? static_cast<float>(v) : std::numeric_limits<float>::quiet_NaN();
      }
    });
}

} // namespace

HexField::HexField(const HexMesh& mesh, const HexScalar& scalar)
  : ofCells_(scalar.ofCells)
{
  const std::size_t wanted = ofCells_ ? mesh.report().cells : mesh.pointCount();
  const ArrayView& v = scalar.values;
  if (v.count() != wanted)
    throw Error("There are " + std::to_string(v.count()) + " scalars for " +
                std::to_string(wanted) + (ofCells_ ? " cells." : " points."));
  if (wanted > 0 && (scalar.component < ArrayView::magnitude || scalar.component >= v.components()))
    throw Error("The scalars have no component " + std::to_string(scalar.component) + ".");
  values_.reserve(ofCells_ ? 0 : mesh.allPointCount());
  values_.resize(ofCells_ ? mesh.cellCount() : mesh.pointCount());
  const auto take = [&](const auto& value)
  {
    const Extent extent = extentOf(values_.size(), value);
    lower_ = extent.lower;
    upper_ = extent.upper;
    if (0.5 * upper_ - 0.5 * lower_ > std::numeric_limits<float>::max())
      throw Error("The scalars reach from " + std::to_string(lower_) + " to " +
                  std::to_string(upper_) + ", and a range above 6.8e38 cannot be shown.");
    offset_ = lower_ <= upper_ ? lower_ + 0.5 * (upper_ - lower_) : 0.0;
    copy(values_, value, offset_);
    for (std::size_t m = 0; m < (ofCells_ ? 0 : mesh.middleCount()); ++m)
    {
      double sum = 0.0;
      for (const std::uint32_t p : mesh.aroundMiddle(m))
        sum += values_[p];
      values_.push_back(static_cast<float>(sum / double(mesh.aroundMiddle(m).size())));
    }
  };
  const bool isAlong = scalar.along != Vec3d(0.0);
  if (isAlong && wanted > 0 && v.components() != 3)
    throw Error("Only vectors of three components have a part along a direction.");
  const auto partAlong = [&](std::size_t i)
  {
    return scalar.along.x * v.value(i, 0) + scalar.along.y * v.value(i, 1) +
           scalar.along.z * v.value(i, 2);
  };
  // The usual array is read without asking for each value what type it has.
  if (v.type() == ArrayView::Type::Float32 && v.components() == 1 && !ofCells_)
    take([f = static_cast<const float*>(v.data())](std::size_t i) { return double(f[i]); });
  else if (isAlong && ofCells_)
    take([&](std::size_t c) { return partAlong(mesh.inputCell(c)); });
  else if (isAlong)
    take(partAlong);
  else if (ofCells_)
    take([&](std::size_t c) { return v.value(mesh.inputCell(c), scalar.component); });
  else
    take([&](std::size_t i) { return v.value(i, scalar.component); });
}

RawVector<ScalarRange> cellRanges(const HexMesh& mesh, const HexField& field)
{
  constexpr ScalarRange everything{
    -std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity()};
  RawVector<ScalarRange> ranges(mesh.cellCount());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, ranges.size(), grain),
    [&](const tbb::blocked_range<std::size_t>& block)
    {
      for (std::size_t c = block.begin(); c < block.end(); ++c)
      {
        ScalarRange range;
        const auto add = [&](float v) {
          range.add(std::isnan(v) ? everything : ScalarRange{v, v});
        };
        if (field.isOfCells())
          add(field.ofCell(c));
        else
          for (const std::uint32_t p : mesh.cell(c))
            add(field.ofPoint(p));
        ranges[c] = range;
      }
    });
  return ranges;
}

} // namespace mote
