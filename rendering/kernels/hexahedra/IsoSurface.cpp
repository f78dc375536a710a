#include "IsoSurface.h"

#include "../core/PlaceByNormals.h"
#include "detail/RaysOf.h"
#include "detail/ValuesAt.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote
{

namespace
{

constexpr double nothing = -std::numeric_limits<double>::infinity();

std::uint64_t slotOf(const IsoHit& hit)
{
  return std::uint64_t{hit.surface} << 32 | hit.cell;
}

std::uint32_t cellOf(std::uint64_t slot)
{
  return static_cast<std::uint32_t>(slot);
}

} // namespace

IsoSurface::IsoSurface(std::shared_ptr<const HexStructure> structure,
  std::shared_ptr<const HexField> field, const std::vector<double>& values,
  std::shared_ptr<const HiddenCells> hidden, std::shared_ptr<const HexField> colors)
  : structure_(std::move(structure))
  , field_(std::move(field))
  , hidden_(std::move(hidden))
  , colors_(std::move(colors))
{
  // An infinite value is never met, and unlike NaN equal to itself.
  for (const double value : values)
  {
    asked_.push_back(std::isfinite(value) ? value : nothing);
    values_.push_back(asked_.back() - field_->offset());
  }
}

double IsoSurface::rounding() const
{
  const Vec3d size = this->bounds().size();
  return surfaceError * std::max({size.x, size.y, size.z});
}

template <typename Counts>
std::optional<IsoHit> IsoSurface::first(const HexRay& ray, Counts&& counts) const
{
  std::optional<IsoHit> hit;
  withStructure(*structure_,
    [&](const auto& s)
    {
      IsoCrossing crossing(s.mesh(), *field_, values_, ray);
      s.forCellsAlong(
        ray,
        [&](const CellSpan& span) { return (hidden_ && (*hidden_)[span.cell]) || crossing(span); },
        [&](const ScalarRange& range)
        {
          return std::any_of(values_.begin(), values_.end(),
            [&](double v) { return v >= range.lower && v <= range.upper; });
        },
        counts);
      if (crossing.found())
        hit = crossing.hit();
    });
  return hit;
}

template <typename Rays>
void IsoSurface::castEach(Rays& rays, std::int32_t index) const
{
  for (int i = 0; i < rays.count; ++i)
  {
    const HexRay ray = rayOf(rays, i);
    if (!(ray.tMax > ray.tMin))
      continue;
    if (const auto hit = this->first(ray))
    {
      rays.t[i] = hit->t;
      rays.slot[i] = slotOf(*hit);
      rays.object[i] = index;
    }
  }
}

template <typename Rays>
void IsoSurface::occludeEach(Rays& rays) const
{
  for (int i = 0; i < rays.count; ++i)
  {
    const HexRay ray = rayOf(rays, i);
    if (ray.tMax > ray.tMin && this->first(ray))
      rays.t[i] = nothing;
  }
}

void IsoSurface::cast(RayBundle& rays, std::int32_t index) const
{
  this->castEach(rays, index);
}

void IsoSurface::cast(RayPacket& rays, std::int32_t index) const
{
  this->castEach(rays, index);
}

void IsoSurface::occlude(RayBundle& rays, std::int32_t) const
{
  this->occludeEach(rays);
}

void IsoSurface::occlude(RayPacket& rays, std::int32_t) const
{
  this->occludeEach(rays);
}

Vec3d IsoSurface::normalAt(std::uint64_t slot, const Vec3d& point) const
{
  CellSampler cell(meshOf(*structure_), *field_);
  cell.enter(cellOf(slot));
  return cell.gradient(point);
}

void IsoSurface::place(HitBlock& block, const HitPlacing& placing) const
{
  CellSampler cell(meshOf(*structure_), *field_);
  const RayBundle& rays = placing.local;
  for (int k = 0; k < block.count; ++k)
  {
    const int ray = block.ray[k];
    cell.enter(cellOf(block.slot[k]));
    const Vec3d normal = cell.gradient(rays.originOf(ray) + block.t[k] * rays.directionOf(ray));
    // Gradients may be any numbers: only where they point to counts.
    const double largest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
    for (int axis = 0; axis < 3; ++axis)
      block.own[axis][k] = largest > 0.0 ? normal[axis] / largest : 0.0;
  }
  placeByNormals(block, placing);
}

void IsoSurface::colorIndices(const std::uint64_t* slots, int count, std::uint64_t* indices) const
{
  for (int k = 0; k < count; ++k)
    indices[k] = slots[k] >> 32;
}

void IsoSurface::values(
  const std::uint64_t* slots, const Vec3d* points, int count, double* values) const
{
  if (colors_)
    return valuesAt(meshOf(*structure_), *colors_, slots, points, count, values);
  for (int k = 0; k < count; ++k)
    values[k] = asked_[slots[k] >> 32];
}

void IsoSurface::inputIds(const std::uint64_t* slots, int count, std::uint64_t* ids) const
{
  const HexMesh& mesh = meshOf(*structure_);
  for (int k = 0; k < count; ++k)
    ids[k] = mesh.inputCell(cellOf(slots[k]));
}

IsoSurface IsoSurface::unowned() const
{
  IsoSurface copy;
  copy.structure_ = mote::unowned(structure_);
  copy.field_ = mote::unowned(field_);
  copy.hidden_ = mote::unowned(hidden_);
  copy.colors_ = mote::unowned(colors_);
  copy.values_ = values_;
  copy.asked_ = asked_;
  return copy;
}

template std::optional<IsoHit> IsoSurface::first(const HexRay&, NoCounts&&) const;
template std::optional<IsoHit> IsoSurface::first(const HexRay&, WalkCounts&) const;

} // namespace mote
