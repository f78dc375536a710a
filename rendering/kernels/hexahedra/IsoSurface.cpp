#include "IsoSurface.h"

#include "../core/PlaceByNormals.h"
#include "../core/SurfaceRounding.h"
#include "HexBvhBundle.h"
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

/// Fewer rays are as soon done one at a time.
constexpr int leastTogether = 4;

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

/// Whether a region with these values may hold a surface.
bool IsoSurface::isMet(const ScalarRange& range) const
{
  return std::any_of(
    values_.begin(), values_.end(), [&](double v) { return v >= range.lower && v <= range.upper; });
}

double IsoSurface::rounding() const
{
  return surfaceRounding(this->bounds().size());
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
        [&](const ScalarRange& range) { return isMet(range); }, counts);
      if (crossing.found())
        hit = crossing.hit();
    });
  return hit;
}

/// Rays one at a time: calls found(i, hit) for those that meet a surface.
template <typename Rays, typename Found>
void IsoSurface::meetEach(const Rays& rays, int first, int last, const Found& found) const
{
  for (int i = first; i < last; ++i)
  {
    const HexRay ray = rayOf(rays, i);
    if (!(ray.tMax > ray.tMin))
      continue;
    if (const auto hit = this->first(ray))
      found(i, *hit);
  }
}

/// The same for rays that go through the hierarchy together, at most as many as it takes at once.
/// False where they must go one at a time; then nothing was found.
template <typename Found>
bool IsoSurface::meetTogether(const RayBundle& rays, int first, int last, const Found& found) const
{
  const auto* bvh = std::get_if<CartesianBvh>(structure_.get());
  if (!bvh || last - first < leastTogether || field_->isOfCells())
    return false;
  std::array<HexRay, BundleSpans::rays> local;
  std::array<std::optional<IsoCrossing>, BundleSpans::rays> crossings;
  for (int i = first; i < last; ++i)
    local[static_cast<std::size_t>(i - first)] = rayOf(rays, i);
  thread_local BundleSpans spans; // keeps its memory
  return bvh->forCellsAlongBundle(
    local.data(), last - first, {rays.dx, rays.dy}, field_.get(), spans,
    [&](std::size_t ray, const ValuedSpan& span)
    {
      if (hidden_ && (*hidden_)[span.span.cell])
        return true;
      std::optional<IsoCrossing>& crossing = crossings[ray];
      if (!crossing)
        crossing.emplace(bvh->mesh(), *field_, values_, local[ray]);
      if ((*crossing)(span))
        return true;
      found(first + static_cast<int>(ray), crossing->hit());
      return false;
    },
    [&](const ScalarRange& range) { return isMet(range); });
}

template <typename Found>
void IsoSurface::meetAll(const RayBundle& rays, const Found& found) const
{
  constexpr int step = BundleSpans::rays;
  for (int first = 0; first < rays.count; first += step)
    if (const int last = std::min(first + step, rays.count);
        !this->meetTogether(rays, first, last, found))
      this->meetEach(rays, first, last, found);
}

template <typename Found>
void IsoSurface::meetAll(const RayPacket& rays, const Found& found) const
{
  this->meetEach(rays, 0, rays.count, found);
}

template <typename Rays>
void IsoSurface::castAll(Rays& rays, std::int32_t index) const
{
  this->meetAll(rays,
    [&](int i, const IsoHit& hit)
    {
      rays.t[i] = hit.t;
      rays.slot[i] = slotOf(hit);
      rays.object[i] = index;
    });
}

template <typename Rays>
void IsoSurface::occludeAll(Rays& rays) const
{
  this->meetAll(rays, [&](int i, const IsoHit&) { rays.t[i] = nothing; });
}

void IsoSurface::cast(RayBundle& rays, std::int32_t index) const
{
  this->castAll(rays, index);
}

void IsoSurface::cast(RayPacket& rays, std::int32_t index) const
{
  this->castAll(rays, index);
}

void IsoSurface::occlude(RayBundle& rays, std::int32_t) const
{
  this->occludeAll(rays);
}

void IsoSurface::occlude(RayPacket& rays, std::int32_t) const
{
  this->occludeAll(rays);
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
