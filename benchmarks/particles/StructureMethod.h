#pragma once

#include "ParticleMethod.h"

#include <glm/geometric.hpp>
#include <kernels/particles/ParticleStructure.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <type_traits>
#include <vector>

namespace mote::bench
{

/// Casts the rays of a camera through a structure of Mote's in bundles of `side` x `side` pixels:
/// 2, 4, 8 or 16, or 0 for the structure's own choice tile by tile. `poe` are pixels of error, of
/// structures with levels of detail.
template <typename Structure>
void castBundles(
  const Structure& structure, int side, const CameraRays& rays, HitImage& image, double poe = 0.0)
{
  const auto ownSide = [&](int x0, int y0)
  {
    if constexpr (std::is_same_v<Structure, PkdTree>)
      return structure.bundleSide(rays, x0, y0, tileSide, poe);
    else
      return structure.bundleSide(rays, x0, y0, tileSide);
  };
  forTiles(image.width(), image.height(),
    [&](int x0, int y0)
    {
      RayBundle bundle;
      const int chosen = side > 0 ? side : ownSide(x0, y0);
      forBlocksOfTile(x0, y0, image.width(), image.height(), chosen,
        [&](int x, int y)
        {
          rays.fillBundle(bundle, chosen, x, y, 0.0, 0.0);
          if constexpr (std::is_same_v<Structure, PkdTree>)
            structure.cast(bundle, 0, poe);
          else
            structure.cast(bundle, 0);
          image.putBundle(bundle, chosen, x, y);
        });
    });
}

/// For every ray the slot of the particle that it leaves, found by a ray back to it.
template <typename Structure>
std::vector<std::uint64_t> slotsLeft(const Structure& structure, const OcclusionRays& rays)
{
  std::vector<std::uint64_t> slots(rays.packets.size() * RayPacket::capacity, RayPacket::noHit);
  for (std::size_t p = 0; p < rays.packets.size(); ++p)
  {
    const OcclusionRays::Packet& from = rays.packets[p];
    RayPacket packet;
    packet.count = from.count;
    std::memcpy(packet.origin, from.origin, sizeof(from.origin));
    for (int i = 0; i < from.count; ++i)
    {
      for (int k = 0; k < 3; ++k)
        packet.direction[k][i] = from.left[k][i] - from.origin[k][i];
      packet.tMin[i] = 0.0;
      packet.t[i] = 1.0;
      packet.slot[i] = RayPacket::noHit;
      packet.object[i] = -1;
    }
    structure.cast(packet, 0);
    for (int i = 0; i < from.count; ++i)
    {
      // Where spheres overlap, the way back may meet another one first.
      const Vec3d left(from.left[0][i], from.left[1][i], from.left[2][i]);
      const Vec3d origin(from.origin[0][i], from.origin[1][i], from.origin[2][i]);
      if (packet.slot[i] != RayPacket::noHit && glm::distance(structure.center(packet.slot[i]),
                                                  left) < 1e-3 * glm::distance(origin, left))
        slots[p * RayPacket::capacity + static_cast<std::size_t>(i)] = packet.slot[i];
    }
  }
  return slots;
}

/// Asks a structure of Mote's for whatever is in the way of the rays, packet by packet. `slots` are
/// of the particles that the rays leave, or null.
template <typename Structure>
void occludePackets(const Structure& structure, const OcclusionRays& rays,
  const std::uint64_t* slots, OcclusionAnswers& answers)
{
  forPackets(rays, answers,
    [&](const OcclusionRays::Packet& from)
    {
      RayPacket packet;
      packet.count = from.count;
      std::memcpy(packet.origin, from.origin, sizeof(from.origin));
      std::memcpy(packet.direction, from.direction, sizeof(from.direction));
      std::fill_n(packet.tMin, from.count, 0.0);
      std::fill_n(packet.t, from.count, rays.reach);
      std::fill_n(packet.object, from.count, slots == nullptr ? -1 : 0);
      if (slots == nullptr)
        std::fill_n(packet.slot, from.count, RayPacket::noHit);
      else
        std::copy_n(
          slots + (&from - rays.packets.data()) * RayPacket::capacity, from.count, packet.slot);
      structure.occlude(packet, 0);
      std::uint64_t bits = 0;
      for (int i = 0; i < from.count; ++i)
        bits |= std::uint64_t{packet.t[i] < 0.0} << i;
      return bits;
    });
}

/// Any structure of Mote's.
template <IsParticleStructure Structure>
class StructureMethod : public ParticleMethod
{
public:
  StructureMethod(const typename Structure::Options& build, int side)
    : build_(build)
    , side_(side)
  {
  }

  void build(const ParticleInput& input) override { structure().build(input.set, build_); }

  std::size_t bytes() const override { return structure().bytes(); }

  bool makeLods() override
  {
    if constexpr (std::is_same_v<Structure, PkdTree>)
      structure().makeLods();
    return std::is_same_v<Structure, PkdTree>;
  }

  void setPoe(double poe) override { poe_ = poe; }

  ParticleLodErrors lodErrors(
    const Camera& camera, int width, int height, double poe) const override
  {
    return measureParticleLods(held_, camera, width, height, poe);
  }

  std::vector<std::string> modes() const override
  {
    const std::string side = std::to_string(side_);
    return {side_ == 0 ? "auto" : "packet " + side + "x" + side};
  }

  void cast(std::size_t, const CameraRays& rays, HitImage& image) const override
  {
    castBundles(structure(), side_, rays, image, poe_);
  }

  std::vector<std::string> occlusionModes() const override
  {
    return {"from hits", "from anywhere"};
  }

  void prepareOcclusion(const OcclusionRays& rays) override
  {
    slots_[&rays] = slotsLeft(structure(), rays);
  }

  void occlude(
    std::size_t mode, const OcclusionRays& rays, OcclusionAnswers& answers) const override
  {
    occludePackets(structure(), rays, mode == 0 ? slots_.at(&rays).data() : nullptr, answers);
  }

private:
  Structure& structure() { return std::get<Structure>(*held_); }
  const Structure& structure() const { return std::get<Structure>(*held_); }

  std::shared_ptr<ParticleStructure> held_ =
    std::make_shared<ParticleStructure>(std::in_place_type<Structure>);
  typename Structure::Options build_;
  int side_;
  double poe_ = 0.0;
  std::map<const OcclusionRays*, std::vector<std::uint64_t>> slots_; ///< that the rays leave
};

} // namespace mote::bench
