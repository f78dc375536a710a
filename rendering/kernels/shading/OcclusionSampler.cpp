#include "OcclusionSampler.h"

#include "SampleSequence.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace mote
{

namespace
{

constexpr int lanes = OcclusionDirections::lanes;
/// Rays nearer to the horizon than this cosine weigh nothing, and rounding would have much to say.
constexpr float leastCosine = 1e-3f;

/// Rays a texel of the few and of the many, as shares of the options' samples: of two spheres that
/// touch, about half of the texels take the many.
constexpr double fewShare = 0.25, manyShare = 1.45;

OcclusionDirections directionsFor(double rays)
{
  // Half of them lie above the horizon.
  return OcclusionDirections(std::max(2, static_cast<int>(std::lround(2.0 * rays))));
}

} // namespace

OcclusionDirectionSets::OcclusionDirectionSets(int samples)
  : few(directionsFor(fewShare * samples))
  , many(directionsFor(manyShare * samples))
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
  rounding_ = surfaceError * std::max({size.x, size.y, size.z});
  asker_.resize(RayPacket::capacity);
  packet_.count = 0;
}

void OcclusionSampler::begin(std::size_t slot)
{
  slot_ = slot;
  near_.clear();
  withStructure(structure_,
    [&](const auto& s)
    {
      center_ = s.center(slot);
      radius_ = s.radius(slot);
      const std::uint64_t input = s.inputIndex(slot);
      seed_ = mixedBits(static_cast<std::uint32_t>(input), static_cast<std::uint32_t>(input >> 32));
      s.findNear(center_, radius_, near_);
    });
  swallowed_ = false;
  overlaps_.clear();
  for (const NearParticle& other : near_)
  {
    const Vec3d way = other.center - center_;
    const double distance = glm::length(way), radius = other.radius - rounding_;
    if (other.slot == slot_ || radius <= 0.0 || distance + radius <= radius_ ||
        distance >= radius + radius_)
      continue;
    swallowed_ = swallowed_ || distance + radius_ < radius;
    overlaps_.push_back({way, radius * radius});
  }
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
  const std::size_t count = places_->middles.size();
  askers_.assign(count, {});
  texels_.clear();
  for (std::size_t texel = 0; texel < count; ++texel)
  {
    Asker& asker = askers_[texel];
    asker.place = places_->middles[texel];
    if (!overlaps_.empty())
    {
      int outside = 0;
      bool isPlaced = !isInside(asker.place);
      for (std::size_t k = 0; k < OcclusionPlaces::jitters; ++k)
      {
        const Vec3f& place = places_->jittered[texel * OcclusionPlaces::jitters + k];
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
      texels_.push_back(static_cast<std::uint32_t>(texel));
  }
}

void OcclusionSampler::ask(const OcclusionDirections& directions)
{
  directions.turn(seed_, turned_);
  const auto blocks = static_cast<std::size_t>(turned_.blocks);
  facing_.resize(texels_.size() * blocks);
  for (std::size_t i = 0; i < texels_.size(); ++i)
  {
    const Vec3f& place = askers_[texels_[i]].place;
    for (std::size_t block = 0; block < blocks; ++block)
    {
      unsigned bits = 0;
      for (std::size_t lane = 0; lane < lanes; ++lane)
      {
        const std::size_t k = block * lanes + lane;
        const float cosine =
          place.x * turned_.x[k] + place.y * turned_.y[k] + place.z * turned_.z[k];
        bits |= unsigned(cosine > leastCosine) << lane;
      }
      facing_[i * blocks + block] = static_cast<Bits>(bits);
    }
  }
  unmet_ = facing_;
  cast();
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

void OcclusionSampler::cast()
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
      const Vec3d place(askers_[texels_[i]].place);
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

void OcclusionSampler::addUp()
{
  const auto blocks = static_cast<std::size_t>(turned_.blocks);
  for (std::size_t i = 0; i < texels_.size(); ++i)
  {
    Asker& asker = askers_[texels_[i]];
    const Vec3f& place = asker.place;
    for (std::size_t block = 0; block < blocks; ++block)
    {
      const std::size_t entry = i * blocks + block;
      asked_ += static_cast<std::size_t>(std::popcount(facing_[entry]));
      open_ += static_cast<std::size_t>(std::popcount(unmet_[entry]));
      for (unsigned bits = facing_[entry]; bits != 0; bits &= bits - 1)
      {
        const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
        const std::size_t k = block * lanes + lane;
        const Vec3f way(turned_.x[k], turned_.y[k], turned_.z[k]);
        const float weight = glm::dot(place, way) * options_.sky.towards(way);
        asker.all += weight;
        if ((unmet_[entry] >> lane & 1) != 0)
          asker.open += weight;
      }
    }
  }
}

/// Whether the few rays of a texel and of those around all met something, or all nothing.
bool OcclusionSampler::isSettled(int texel) const
{
  const int side = places_->side, row = texel / side, column = texel % side;
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
  places_ = &places;
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
  texels.side = places_->side;
  for (std::size_t texel = 0; texel < askers_.size(); ++texel)
  {
    const Asker& asker = askers_[texel];
    const float share = asker.all > 0.0f ? asker.open / asker.all : 0.0f;
    texels.weight[texel] =
      asker.outside * OcclusionTexels::area(texels.side, static_cast<int>(texel) / texels.side);
    texels.value[texel] = options_.sky.onOpen(places_->middles[texel]) * share *
                          (options_.dilate ? 1.0f : asker.outside);
  }
}

} // namespace mote
