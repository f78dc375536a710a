#include "CoherentGridMethod.h"

#include "ParticleMethod.h"

namespace mote::bench
{

namespace
{

class CoherentGridMethod : public ParticleMethod
{
public:
  explicit CoherentGridMethod(const MethodOptions& options)
    : side_(options.packet)
  {
    build_.keepIndices = false;
    build_.cellsPerParticle = options.lambda;
  }

  void build(const ParticleInput& input) override { grid_.build(input.set, build_); }

  std::size_t bytes() const override { return grid_.bytes(); }

  std::vector<std::string> modes() const override
  {
    const std::string side = std::to_string(side_);
    return {side_ == 0 ? "auto" : "packet " + side + "x" + side};
  }

  void cast(std::size_t, const CameraRays& rays, HitImage& image) const override
  {
    castBundles(grid_, side_, rays, image);
  }

private:
  CoherentGrid grid_;
  CoherentGridOptions build_;
  int side_;
};

} // namespace

void castBundles(const CoherentGrid& grid, int side, const CameraRays& rays, HitImage& image)
{
  forTiles(image.width(), image.height(),
    [&](int x0, int y0)
    {
      RayBundle bundle;
      const int chosen = side > 0 ? side : grid.bundleSide(rays, x0, y0, tileSide);
      forBlocksOfTile(x0, y0, image.width(), image.height(), chosen,
        [&](int x, int y)
        {
          rays.fillBundle(bundle, chosen, x, y, 0.0, 0.0);
          grid.cast(bundle, 0);
          image.putBundle(bundle, chosen, x, y);
        });
    });
}

std::unique_ptr<ParticleMethod> makeCoherentGridMethod(const MethodOptions& options)
{
  return std::make_unique<CoherentGridMethod>(options);
}

} // namespace mote::bench
