// Rays of a particle against the spheres around it, compiled once for every SIMD instruction set.

#include "detail/OcclusionNear.h"

#include <algorithm>
#include <bit>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "occlusion/OcclusionNear.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, 16>;
using VF = hn::Vec<DF>;
constexpr std::size_t lanes = OcclusionDirections::lanes;
constexpr std::size_t groupBlocks = 16; ///< so that 16 bits name a group's blocks
/// Rays nearer to the horizon than this cosine weigh nothing, and rounding would have much to say.
constexpr float leastCosine = 1e-3f;

HWY_INLINE unsigned bitsOf(hn::Mask<DF> mask)
{
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(DF(), mask, bits);
  return bits[0] | unsigned(bits[1]) << 8;
}

/// x a.x + y a.y + z a.z of the numbers at i and following.
HWY_INLINE VF dotWith(const Vec3f& a, const float* x, const float* y, const float* z)
{
  const DF d;
  return hn::MulAdd(hn::Set(d, a.x), hn::LoadU(d, x),
    hn::MulAdd(hn::Set(d, a.y), hn::LoadU(d, y), hn::Mul(hn::Set(d, a.z), hn::LoadU(d, z))));
}

/// One group of blocks of directions.
struct Group
{
  const OcclusionDirections& directions;
  std::size_t first; ///< block
  std::size_t blocks;
};

/// Fills c w of each sphere and direction, and the blocks that a sphere may stop rays of.
void prepare(const OcclusionNear& near, const Group& group, float* along, std::uint16_t* mayMeet)
{
  const DF d;
  const std::size_t first = group.first * lanes, width = group.blocks * lanes;
  for (std::size_t j = 0; j < near.count; ++j)
  {
    const Vec3f c(near.x[j], near.y[j], near.z[j]);
    unsigned blocks = 0;
    for (std::size_t k = 0; k < width; k += hn::Lanes(d))
    {
      const OcclusionDirections& w = group.directions;
      const VF cw = dotWith(c, &w.x[first + k], &w.y[first + k], &w.z[first + k]);
      hn::StoreU(cw, d, along + j * width + k);
      if (!hn::AllFalse(d, hn::Gt(cw, hn::Set(d, near.nearest[j]))))
        blocks |= 1u << (k / lanes);
    }
    mayMeet[j] = static_cast<std::uint16_t>(blocks);
  }
}

/// Lengths of the tangents from P to spheres j and following, as far as rays go; returns the bits
/// of those spheres that rise above the plane that touches the particle at P.
HWY_INLINE unsigned tangents(
  const OcclusionNear& near, const Vec3f& place, std::size_t j, float* tangent)
{
  const DF d;
  unsigned risen = 0;
  const VF reach = hn::Set(d, near.reach);
  for (std::size_t lane = 0; lane < lanes; lane += hn::Lanes(d))
  {
    const std::size_t i = j + lane;
    const VF cp = dotWith(place, &near.x[i], &near.y[i], &near.z[i]);
    const VF k = hn::LoadU(d, &near.k[i]);
    const VF square = hn::Max(hn::NegMulAdd(hn::Set(d, 2.0f), cp, k), hn::Zero(d));
    const VF t = hn::Sqrt(square);
    const VF far = hn::Div(hn::MulAdd(reach, reach, square), hn::Add(reach, reach));
    hn::StoreU(hn::IfThenElse(hn::Le(t, reach), t, far), d, tangent + lane);
    const VF height = hn::Add(cp, hn::LoadU(d, &near.r[i]));
    risen |= bitsOf(hn::Gt(height, hn::Set(d, 1.0f))) << lane;
  }
  return risen;
}

/// Tests the rays of one place in the directions of a group.
void askPlace(const OcclusionNear& near, const Group& group, const float* along,
  const std::uint16_t* mayMeet, const Vec3f& place, std::uint16_t* facing, std::uint16_t* unmet)
{
  const DF d;
  alignas(64) float up[groupBlocks * lanes], tangent[lanes];
  const OcclusionDirections& w = group.directions;
  const std::size_t first = group.first * lanes, width = group.blocks * lanes;
  unsigned active = 0;
  std::fill_n(facing, group.blocks, std::uint16_t{0});
  for (std::size_t k = 0; k < width; k += hn::Lanes(d))
  {
    const VF pw = dotWith(place, &w.x[first + k], &w.y[first + k], &w.z[first + k]);
    hn::Store(pw, d, up + k);
    const unsigned bits = bitsOf(hn::Gt(pw, hn::Set(d, leastCosine))) << (k % lanes);
    facing[k / lanes] = static_cast<std::uint16_t>(facing[k / lanes] | bits);
    active |= unsigned(bits != 0) << (k / lanes);
  }
  std::copy_n(facing, group.blocks, unmet);
  for (std::size_t j = 0; j < near.count && active != 0; j += lanes)
    for (unsigned risen = tangents(near, place, j, tangent); risen != 0; risen &= risen - 1)
    {
      const auto lane = static_cast<std::size_t>(std::countr_zero(risen));
      const VF t = hn::Set(d, tangent[lane]);
      const float* cw = along + (j + lane) * width;
      for (unsigned blocks = mayMeet[j + lane] & active; blocks != 0; blocks &= blocks - 1)
      {
        const auto block = static_cast<std::size_t>(std::countr_zero(blocks));
        unsigned met = 0;
        for (std::size_t k = 0; k < lanes; k += hn::Lanes(d))
          met |= bitsOf(hn::Gt(hn::LoadU(d, cw + block * lanes + k),
                   hn::Add(hn::Load(d, up + block * lanes + k), t)))
                 << k;
        unmet[block] = static_cast<std::uint16_t>(unmet[block] & ~met);
        active &= ~(unsigned(unmet[block] == 0) << block);
      }
    }
}

void askAll(const OcclusionNear& near, const OcclusionDirections& directions, float* along,
  std::uint16_t* mayMeet, const Vec3f* places, std::size_t count, std::uint16_t* facing,
  std::uint16_t* unmet)
{
  const auto blocks = static_cast<std::size_t>(directions.blocks);
  for (std::size_t first = 0; first < blocks; first += groupBlocks)
  {
    const Group group{directions, first, std::min(groupBlocks, blocks - first)};
    prepare(near, group, along, mayMeet);
    for (std::size_t i = 0; i < count; ++i)
      askPlace(near, group, along, mayMeet, places[i], facing + i * blocks + first,
        unmet + i * blocks + first);
  }
}

void addRays(const OcclusionDirections& directions, const float* light, const Vec3f& place,
  const std::uint16_t* facing, const std::uint16_t* unmet, float& open, float& all)
{
  const DF d;
  VF openSum = hn::Zero(d), allSum = hn::Zero(d);
  const auto width = static_cast<std::size_t>(directions.blocks) * lanes;
  for (std::size_t k = 0; k < width; k += hn::Lanes(d))
  {
    const std::size_t block = k / lanes;
    const unsigned bits = unsigned(facing[block]) >> (k % lanes);
    const unsigned openBits = unsigned(unmet[block]) >> (k % lanes);
    if (bits == 0)
      continue;
    const VF weight = hn::Mul(hn::LoadU(d, light + k),
      dotWith(place, &directions.x[k], &directions.y[k], &directions.z[k]));
    const std::uint8_t allBytes[8] = {
      static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8)};
    const std::uint8_t openBytes[8] = {
      static_cast<std::uint8_t>(openBits), static_cast<std::uint8_t>(openBits >> 8)};
    allSum = hn::Add(allSum, hn::IfThenElseZero(hn::LoadMaskBits(d, allBytes), weight));
    openSum = hn::Add(openSum, hn::IfThenElseZero(hn::LoadMaskBits(d, openBytes), weight));
  }
  all += hn::GetLane(hn::SumOfLanes(d, allSum));
  open += hn::GetLane(hn::SumOfLanes(d, openSum));
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace mote
{

HWY_EXPORT(askAll);
HWY_EXPORT(addRays);

namespace
{

/// Smaller spheres than this, and those that look smaller, are lost in float's rounding.
constexpr double smallest = 1.0 / 32.0, farthest = 256.0;
/// Spheres that come so near to the centre may stand between the surface and a plane that touches
/// it: the root of two, and something for rounding.
constexpr double touching = 1.42;

} // namespace

void OcclusionNear::place(const std::vector<NearParticle>& found, const Vec3d& center,
  double radius, std::uint64_t self, double rayReach, std::size_t most)
{
  order_.clear();
  hasAll = hasTouching = true;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    if (found[i].slot == self)
      continue;
    const double distance = glm::length(found[i].center - center);
    const bool mayTouch = distance - found[i].radius < touching * radius;
    if (found[i].radius < smallest * radius || distance > farthest * found[i].radius)
    {
      hasAll = false;
      hasTouching = hasTouching && !mayTouch;
      continue;
    }
    // Those that may touch come first: none of them is left out.
    const double gap = std::max(0.0, distance - radius) / found[i].radius;
    order_.push_back({mayTouch ? gap * 1e-9 : gap, i});
  }
  std::sort(order_.begin(), order_.end(),
    [](const Looks& a, const Looks& b)
    { return a.distance < b.distance || (a.distance == b.distance && a.found < b.found); });
  while (order_.size() > most && found[order_.back().found].radius + touching * radius <
                                   glm::length(found[order_.back().found].center - center))
  {
    order_.pop_back();
    hasAll = false;
  }
  count = order_.size();
  const std::size_t padded = (count + lanes - 1) / lanes * lanes;
  for (RawVector<float>* all : {&x, &y, &z, &r, &k, &nearest})
    all->assign(padded, 0.0f);
  for (std::size_t j = 0; j < count; ++j)
  {
    const NearParticle& other = found[order_[j].found];
    const Vec3d c = (other.center - center) / radius;
    const double otherRadius = other.radius / radius, distance = glm::length(c);
    x[j] = static_cast<float>(c.x);
    y[j] = static_cast<float>(c.y);
    z[j] = static_cast<float>(c.z);
    r[j] = static_cast<float>(otherRadius);
    const double beyond = distance - otherRadius;
    k[j] = static_cast<float>(1.0 + beyond * (distance + otherRadius));
    const double least = 1.0 - 2.0 * distance + beyond * (distance + otherRadius);
    nearest[j] = static_cast<float>(std::sqrt(std::max(0.0, least)) * (1.0 - 1e-5));
  }
  reach = static_cast<float>(rayReach / radius);
}

void OcclusionNear::ask(const OcclusionDirections& directions, const Vec3f* places,
  std::size_t placeCount, std::uint16_t* facing, std::uint16_t* unmet)
{
  along_.resize(count * 256);
  mayMeet_.resize(count);
  HWY_DYNAMIC_DISPATCH(askAll)
  (*this, directions, along_.data(), mayMeet_.data(), places, placeCount, facing, unmet);
}

void addOcclusionRays(const OcclusionDirections& directions, const float* light, const Vec3f& place,
  const std::uint16_t* facing, const std::uint16_t* unmet, float& open, float& all)
{
  HWY_DYNAMIC_DISPATCH(addRays)(directions, light, place, facing, unmet, open, all);
}

} // namespace mote

#endif
