#pragma once

#include "ParticleMethod.h"

#include <algorithm>
#include <cstring>

namespace mote::bench
{

/// Casts the rays of a camera through a structure of Mote's in bundles of `side` x `side` pixels:
/// 2, 4, 8 or 16, or 0 for the structure's own choice tile by tile.
template <typename Structure>
void castBundles(const Structure& structure, int side, const CameraRays& rays, HitImage& image)
{
  forTiles(image.width(), image.height(),
    [&](int x0, int y0)
    {
      RayBundle bundle;
      const int chosen = side > 0 ? side : structure.bundleSide(rays, x0, y0, tileSide);
      forBlocksOfTile(x0, y0, image.width(), image.height(), chosen,
        [&](int x, int y)
        {
          rays.fillBundle(bundle, chosen, x, y, 0.0, 0.0);
          structure.cast(bundle, 0);
          image.putBundle(bundle, chosen, x, y);
        });
    });
}

/// Asks a structure of Mote's for whatever is in the way of the rays, packet by packet.
template <typename Structure>
void occludePackets(
  const Structure& structure, const OcclusionRays& rays, OcclusionAnswers& answers)
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
      std::fill_n(packet.slot, from.count, RayPacket::noHit);
      std::fill_n(packet.object, from.count, -1);
      structure.occlude(packet, 0);
      std::uint64_t bits = 0;
      for (int i = 0; i < from.count; ++i)
        bits |= std::uint64_t{packet.t[i] < 0.0} << i;
      return bits;
    });
}

/// Any structure of Mote's that is built and cast as a CoherentGrid is.
template <typename Structure, typename BuildOptions>
class StructureMethod : public ParticleMethod
{
public:
  StructureMethod(const BuildOptions& build, int side)
    : build_(build)
    , side_(side)
  {
  }

  void build(const ParticleInput& input) override { structure_.build(input.set, build_); }

  std::size_t bytes() const override { return structure_.bytes(); }

  std::vector<std::string> modes() const override
  {
    const std::string side = std::to_string(side_);
    return {side_ == 0 ? "auto" : "packet " + side + "x" + side};
  }

  void cast(std::size_t, const CameraRays& rays, HitImage& image) const override
  {
    castBundles(structure_, side_, rays, image);
  }

  std::vector<std::string> occlusionModes() const override { return {"packet 64"}; }

  void occlude(std::size_t, const OcclusionRays& rays, OcclusionAnswers& answers) const override
  {
    occludePackets(structure_, rays, answers);
  }

private:
  Structure structure_;
  BuildOptions build_;
  int side_;
};

} // namespace mote::bench
