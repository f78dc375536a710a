#include "HexField.h"

#include "../core/Error.h"
#include "HangingPoints.h"

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

namespace
{

/// The cells at each point, ascending: those of point p are from begins[p] on in `cells`.
struct CellsAtPoints
{
  std::vector<std::size_t> begins;
  RawVector<std::uint32_t> cells;

  explicit CellsAtPoints(const HexMesh& mesh)
    : begins(mesh.pointCount() + 1, 0)
  {
    const auto each = [&](const auto& visit)
    {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.cellCount(), grain),
        [&](const tbb::blocked_range<std::size_t>& block)
        {
          for (std::size_t c = block.begin(); c < block.end(); ++c)
            for (const std::uint32_t p : mesh.cell(c))
              if (p < mesh.pointCount())
                visit(p, c);
        });
    };
    each([&](std::uint32_t p, std::size_t)
      { std::atomic_ref(begins[p]).fetch_add(1, std::memory_order_relaxed); });
    std::size_t sum = 0;
    for (std::size_t& begin : begins)
      begin = sum += begin;
    cells.resize(sum);
    each(
      [&](std::uint32_t p, std::size_t c)
      {
        cells[std::atomic_ref(begins[p]).fetch_sub(1, std::memory_order_relaxed) - 1] =
          static_cast<std::uint32_t>(c);
      });
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.pointCount(), grain),
      [&](const tbb::blocked_range<std::size_t>& block)
      {
        for (std::size_t p = block.begin(); p < block.end(); ++p)
          std::sort(cells.begin() + begins[p], cells.begin() + begins[p + 1]);
      });
  }
};

/// Of a cell, or of all parts of the cell that it is one of: the point in the middle of those.
Vec3d middleOf(const HexMesh& mesh, std::size_t cell)
{
  for (const std::uint32_t p : mesh.cell(cell))
    if (p >= mesh.pointCount())
      return mesh.point(p);
  return cellCenter(mesh.corners(cell));
}

/// The mean of the cells' values about a point; NaN where none has one.
double meanAt(
  const HexMesh& mesh, const HexField& ofCells, const CellsAtPoints& around, std::size_t point)
{
  double sum = 0.0, weights = 0.0;
  std::size_t last = mesh.report().cells; // of the input, of which parts count once
  for (std::size_t i = around.begins[point]; i < around.begins[point + 1]; ++i)
  {
    const std::size_t cell = around.cells[i];
    const double value = ofCells.ofCell(cell);
    if (mesh.inputCell(cell) == last || std::isnan(value))
      continue;
    last = mesh.inputCell(cell);
    const double distance = glm::length(middleOf(mesh, cell) - mesh.point(point));
    const double weight = distance > 0.0 ? 1.0 / distance : 0.0;
    sum += weight * value;
    weights += weight;
  }
  return sum / weights;
}

} // namespace

HexField HexField::atPoints(
  const HexMesh& mesh, const HexField& ofCells, std::span<const HangingPoint> hanging)
{
  const CellsAtPoints around(mesh);
  HexField field;
  field.offset_ = ofCells.offset_;
  field.values_.reserve(mesh.allPointCount());
  field.values_.resize(mesh.pointCount());
  copy(
    field.values_, [&](std::size_t p) { return meanAt(mesh, ofCells, around, p); }, 0.0);
  for (const HangingPoint& point : hanging)
    if (point.point < mesh.pointCount())
    {
      float sum = 0.0F;
      for (std::size_t k = 0; k < 4; ++k)
        sum += point.weights[k] * field.values_[point.corners[k]];
      field.values_[point.point] = sum;
    }
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
