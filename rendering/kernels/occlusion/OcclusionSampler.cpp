#include "detail/OcclusionSampler.h"

#include "../core/SurfaceRounding.h"
#include "../shading/SampleSequence.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace mote
{

namespace
{

constexpr int lanes = OcclusionDirections::lanes;

/// Rays a texel of the few and the many together, as a share of the options' samples: of two
/// spheres that touch, about half of the texels take the many.
constexpr double allShare = 1.7;
/// One in so many directions is of the few. Every sixth point of Fibonacci's spiral is spread well,
/// too; not so every fifth, seventh or eighth.
constexpr int period = 6;

/// Spheres that rays are tested against before they are cast.
constexpr std::size_t mostNear = 64;

/// Directions over the whole sphere; half of them lie above the horizon.
int directionsFor(int samples)
{
  return std::max(2, static_cast<int>(std::lround(2.0 * allShare * samples)));
}

} // namespace

OcclusionDirectionSets::OcclusionDirectionSets(int samples)
  : few(directionsFor(samples), period, false)
  , many(directionsFor(samples), period, true)
{
}

OcclusionSampler::OcclusionSampler(const ParticleStructure& structure,
  const OcclusionBakeOptions& options, const OcclusionDirectionSets& directions)
  : structure_(structure)
  , options_(options)
  , directions_(directions)
  , reach_(occlusionReach(structure, options))
  , turned_(0)
{
  const Vec3d size =
    withStructure(structure, [](const auto& s) { return s.statistics().bounds.size(); });
  rounding_ = surfaceRounding(size);
  spacing_ = std::cbrt(size.x * size.y * size.z /
                       withStructure(structure, [](const auto& s) { return double(s.size()); }));
  packet_.count = 0;
}

void OcclusionSampler::begin(std::size_t slot)
{
  slot_ = slot;
  found_.clear();
  withStructure(structure_,
    [&](const auto& s)
    {
      center_ = s.center(slot);
      radius_ = s.radius(slot);
      const std::uint64_t input = s.inputIndex(slot);
      seed_ = mixedBits(static_cast<std::uint32_t>(input), static_cast<std::uint32_t>(input >> 32));
      // About as many as are tested, and whatever stands between the surface and its tangents.
      ball_ = std::min(radius_ + reach_,
        std::max(1.5 * radius_, std::min(4.0 * radius_, radius_ + 1.25 * spacing_)));
      s.findNear(center_, ball_, found_);
    });
  swallowed_ = false;
  overlaps_.clear();
  for (const NearParticle& other : found_)
  {
    const Vec3d way = other.center - center_;
    const double distance = glm::length(way), radius = other.radius - rounding_;
    if (other.slot == slot_ || radius <= 0.0 || distance + radius <= radius_ ||
        distance >= radius + radius_)
      continue;
    swallowed_ = swallowed_ || distance + radius_ < radius;
    overlaps_.push_back({way, radius * radius});
  }
  if (options_.occlude)
    found_.clear();
  near_.place(found_, center_, radius_, slot_, reach_, mostNear);
}

bool OcclusionSampler::isInside(const Vec3f& place) const
{
  const Vec3d at = radius_ * Vec3d(place);
  return std::any_of(overlaps_.begin(), overlaps_.end(),
    [&](const Overlap& other)
    {
      const Vec3d way = other.center - at;
      return glm::dot(way, way) < other.square;
    });
}

void OcclusionSampler::placeAskers()
{
  const std::size_t count = map_->middles.size();
  askers_.assign(count, {});
  texels_.clear();
  for (const std::uint32_t texel : map_->order)
  {
    Asker& asker = askers_[texel];
    asker.place = map_->middles[texel];
    if (!overlaps_.empty())
    {
      int outside = 0;
      bool isPlaced = !isInside(asker.place);
      for (std::size_t k = 0; k < OcclusionPlaces::jitters; ++k)
      {
        const Vec3f& place = map_->jittered[texel * OcclusionPlaces::jitters + k];
        if (isInside(place))
          continue;
        ++outside;
        if (!isPlaced)
          asker.place = place;
        isPlaced = true;
      }
      asker.outside =
        isPlaced ? static_cast<float>(std::max(outside, 1)) / OcclusionPlaces::jitters : 0.0f;
    }
    if (asker.outside > 0.0f)
      texels_.push_back(texel);
  }
}

void OcclusionSampler::ask(const OcclusionDirections& directions)
{
  directions.turn(seed_, turned_);
  light_.resize(turned_.x.size());
  for (std::size_t k = 0; k < light_.size(); ++k)
    light_[k] = options_.sky.towards({turned_.x[k], turned_.y[k], turned_.z[k]});
  places_.clear();
  for (const std::uint32_t texel : texels_)
    places_.push_back(askers_[texel].place);
  facing_.resize(texels_.size() * static_cast<std::size_t>(turned_.blocks));
  unmet_.resize(facing_.size());
  near_.ask(turned_, places_.data(), places_.size(), facing_.data(), unmet_.data());
  if (options_.occlude || !near_.hasTouching)
    castPackets();
  else if (!near_.hasAll || ball_ < radius_ + reach_)
    castBundles();
  addUp();
}

void OcclusionSampler::answer()
{
  if (packet_.count == 0)
    return;
  if (options_.occlude)
    options_.occlude(packet_);
  else
    withStructure(structure_, [this](const auto& s) { s.occlude(packet_, 0); });
  for (std::size_t k = 0; k < static_cast<std::size_t>(packet_.count); ++k)
    if (!(packet_.t[k] > 0.0))
      unmet_[asker_[k] / lanes] &= static_cast<Bits>(~(1u << asker_[k] % lanes));
  packet_.count = 0;
}

void OcclusionSampler::castPackets()
{
  const auto blocks = static_cast<std::size_t>(turned_.blocks);
  for (std::size_t direction = 0; direction < turned_.x.size(); ++direction)
  {
    const Vec3d way(turned_.x[direction], turned_.y[direction], turned_.z[direction]);
    const std::size_t block = direction / lanes, lane = direction % lanes;
    for (std::size_t i = 0; i < texels_.size(); ++i)
    {
      const std::size_t entry = i * blocks + block;
      if ((unmet_[entry] >> lane & 1) == 0)
        continue;
      const Vec3d place(places_[i]);
      const Vec3d origin = center_ + radius_ * place;
      const int k = packet_.count++;
      for (int axis = 0; axis < 3; ++axis)
      {
        packet_.origin[axis][k] = origin[axis];
        packet_.direction[axis][k] = way[axis];
      }
      packet_.tMin[k] = rounding_ / glm::dot(place, way);
      packet_.t[k] = reach_;
      packet_.slot[k] = slot_;
      packet_.object[k] = 0;
      asker_[static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(entry * lanes + lane);
      if (packet_.count == RayPacket::capacity)
        answer();
    }
  }
  answer();
}

/// Casts the rays of one direction that have met nothing so far. What stands before the plane that
/// touches the particle across the direction is known.
void OcclusionSampler::castBundles()
{
  const auto blocks = static_cast<std::size_t>(turned_.blocks);
  bundle_.kind = RayBundle::Kind::CommonDirection;
  bundle_.count = 0;
  bundle_.origin = center_;
  bundle_.tMin = radius_;
  for (std::size_t block = 0; block < blocks; ++block)
    for (std::size_t lane = 0; lane < lanes; ++lane)
    {
      const std::size_t k = block * lanes + lane;
      const Vec3f way(turned_.x[k], turned_.y[k], turned_.z[k]);
      Vec3f u(0.0f), v(0.0f);
      for (std::size_t i = 0; i < places_.size(); ++i)
      {
        const std::size_t entry = i * blocks + block;
        if ((unmet_[entry] >> lane & 1) == 0)
          continue;
        if (bundle_.count == 0)
        {
          bundle_.direction = Vec3d(way);
          acrossAxes(bundle_.direction, bundle_.dx, bundle_.dy);
          u = Vec3f(bundle_.dx);
          v = Vec3f(bundle_.dy);
          bundle_.dx *= radius_;
          bundle_.dy *= radius_;
        }
        const double end = radius_ * double(glm::dot(places_[i], way)) + reach_;
        if (end <= radius_)
          continue;
        const int ray = bundle_.count++;
        bundle_.x[ray] = glm::dot(places_[i], u);
        bundle_.y[ray] = glm::dot(places_[i], v);
        bundle_.t[ray] = end;
        asker_[static_cast<std::size_t>(ray)] = static_cast<std::uint32_t>(entry * lanes + lane);
        if (bundle_.count == RayBundle::capacity)
          castBundle();
      }
      castBundle();
    }
}

void OcclusionSampler::castBundle()
{
  if (bundle_.count == 0)
    return;
  std::fill_n(bundle_.slot, bundle_.count, slot_);
  std::fill_n(bundle_.object, bundle_.count, 0);
  bundle_.side = 0;
  withStructure(structure_, [this](const auto& s) { s.occlude(bundle_, 0); });
  for (std::size_t k = 0; k < static_cast<std::size_t>(bundle_.count); ++k)
    if (!(bundle_.t[k] > 0.0))
      unmet_[asker_[k] / lanes] &= static_cast<Bits>(~(1u << asker_[k] % lanes));
  bundle_.count = 0;
}

void OcclusionSampler::addUp()
{
  const auto blocks = static_cast<std::size_t>(turned_.blocks);
  for (std::size_t i = 0; i < texels_.size(); ++i)
  {
    Asker& asker = askers_[texels_[i]];
    addOcclusionRays(turned_, light_.data(), asker.place, &facing_[i * blocks], &unmet_[i * blocks],
      asker.open, asker.all);
  }
  for (const Bits bits : facing_)
    asked_ += static_cast<std::size_t>(std::popcount(bits));
  for (const Bits bits : unmet_)
    open_ += static_cast<std::size_t>(std::popcount(bits));
}

/// Whether the few rays of a texel and of those around all met something, or all nothing.
bool OcclusionSampler::isSettled(int texel) const
{
  const int side = map_->side, row = texel / side, column = texel % side;
  bool allOpen = true, noneOpen = true;
  for (int k = 0; k < 9; ++k)
  {
    const Asker& asker = askers_[static_cast<std::size_t>(
      OcclusionTexels::texelAt(side, row + k / 3 - 1, column + k % 3 - 1))];
    allOpen &= asker.open == asker.all;
    noneOpen &= asker.open == 0.0f;
  }
  return allOpen || noneOpen;
}

void OcclusionSampler::askFew(const OcclusionPlaces& places)
{
  map_ = &places;
  asked_ = open_ = 0;
  placeAskers();
  ask(directions_.few);
  rays_ += asked_;
}

void OcclusionSampler::askMany(bool everywhere, OcclusionTexels& texels)
{
  rays_ -= asked_;
  if (!everywhere)
    std::erase_if(
      texels_, [this](std::uint32_t texel) { return isSettled(static_cast<int>(texel)); });
  ask(directions_.many);
  rays_ += asked_;
  texels.side = map_->side;
  for (std::size_t texel = 0; texel < askers_.size(); ++texel)
  {
    const Asker& asker = askers_[texel];
    const float share = asker.all > 0.0f ? asker.open / asker.all : 0.0f;
    const float known = options_.dilate ? asker.outside : 1.0f; // or known to be dark
    texels.weight[texel] =
      known * OcclusionTexels::area(texels.side, static_cast<int>(texel) / texels.side);
    texels.value[texel] =
      options_.sky.onOpen(map_->middles[texel]) * share * (options_.dilate ? 1.0f : asker.outside);
  }
}

} // namespace mote
