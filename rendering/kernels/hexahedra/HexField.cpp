#include "HexField.h"

#include "../core/Error.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

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
    if (!ofCells_)
      this->addMiddles(mesh);
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

/// Values of the middles of cells in parts, which come after those of the input's points.
void HexField::addMiddles(const HexMesh& mesh)
{
  for (std::size_t m = 0; m < mesh.middleCount(); ++m)
  {
    double sum = 0.0;
    for (const std::uint32_t p : mesh.aroundMiddle(m))
      sum += values_[p];
    values_.push_back(static_cast<float>(sum / double(mesh.aroundMiddle(m).size())));
  }
}

HexField HexField::atPoints(const HexMesh& mesh, const HexField& ofCells)
{
  // Whole numbers add up to the same sum in any order.
  const double half = std::max(ofCells.upper_ - ofCells.offset_, ofCells.offset_ - ofCells.lower_);
  const double unit = half > 0.0 ? std::ldexp(half, -36) : 1.0;
  std::vector<std::int64_t> sums(mesh.pointCount(), 0);
  std::vector<std::uint32_t> counts(mesh.pointCount(), 0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.cellCount(), grain),
    [&](const tbb::blocked_range<std::size_t>& block)
    {
      std::vector<std::uint32_t> points; // of a cell of the input, in one part or in several
      for (std::size_t first = block.begin(); first < block.end(); ++first)
      {
        const std::size_t input = mesh.inputCell(first);
        const float value = ofCells.ofCell(first);
        if (std::isnan(value) || (first > 0 && mesh.inputCell(first - 1) == input))
          continue;
        points.clear();
        for (std::size_t c = first; c < mesh.cellCount() && mesh.inputCell(c) == input; ++c)
          points.insert(points.end(), mesh.cell(c).begin(), mesh.cell(c).end());
        std::sort(points.begin(), points.end());
        points.erase(std::unique(points.begin(), points.end()), points.end());
        for (const std::uint32_t p : points)
          if (p < mesh.pointCount())
          {
            std::atomic_ref(sums[p]).fetch_add(
              std::llround(double(value) / unit), std::memory_order_relaxed);
            std::atomic_ref(counts[p]).fetch_add(1, std::memory_order_relaxed);
          }
      }
    });
  HexField field;
  field.offset_ = ofCells.offset_;
  field.values_.reserve(mesh.allPointCount());
  field.values_.resize(mesh.pointCount());
  copy(
    field.values_,
    [&](std::size_t p)
    {
      return counts[p] > 0 ? static_cast<double>(sums[p]) * unit / double(counts[p])
                           : std::numeric_limits<double>::quiet_NaN();
    },
    0.0);
  const Extent extent = extentOf(
    field.values_.size(), [&](std::size_t p) { return field.offset_ + double(field.values_[p]); });
  field.lower_ = extent.lower;
  field.upper_ = extent.upper;
  field.addMiddles(mesh);
  return field;
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
