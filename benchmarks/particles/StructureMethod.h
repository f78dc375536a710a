#pragma once

#include "ParticleMethod.h"

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

private:
  Structure structure_;
  BuildOptions build_;
  int side_;
};

} // namespace mote::bench
