// The grids that Mote's is compared with.

#include "ParticleMethod.h"
#include "ReferenceGrid.h"
#include "SingleRayGrid.h"

namespace mote::bench
{

namespace
{

class ReferenceGridMethod : public ParticleMethod
{
public:
  explicit ReferenceGridMethod(double lambda)
    : lambda_(lambda)
  {
  }

  void build(const ParticleInput& input) override { grid_.build(input.set, lambda_); }

  std::size_t bytes() const override { return grid_.bytes(); }

  std::vector<std::string> modes() const override { return {"packet 8x8"}; }

  void cast(std::size_t, const CameraRays& rays, HitImage& image) const override
  {
    constexpr int side = 8;
    forTiles(image.width(), image.height(),
      [&](int x0, int y0)
      {
        RayBundle bundle;
        forBlocksOfTile(x0, y0, image.width(), image.height(), side,
          [&](int x, int y)
          {
            rays.fillBundle(bundle, side, x, y, 0.0, 0.0);
            grid_.cast(bundle);
            image.putBundle(bundle, side, x, y);
          });
      });
  }

private:
  ReferenceGrid grid_;
  double lambda_;
};

class SingleRayMethod : public ParticleMethod
{
public:
  explicit SingleRayMethod(double lambda)
    : lambda_(lambda)
  {
  }

  void build(const ParticleInput& input) override { grid_.build(input.set, lambda_); }

  std::size_t bytes() const override { return grid_.bytes(); }

  std::vector<std::string> modes() const override { return {"single"}; }

  void cast(std::size_t, const CameraRays& rays, HitImage& image) const override
  {
    forBlocks(image.width(), image.height(), 8,
      [&](int x, int y) { castSingleRays(grid_, rays, x, y, image); });
  }

private:
  CellGrid grid_;
  double lambda_;
};

} // namespace

std::unique_ptr<ParticleMethod> makeReferenceGridMethod(const MethodOptions& options)
{
  return std::make_unique<ReferenceGridMethod>(options.lambda);
}

std::unique_ptr<ParticleMethod> makeSingleRayMethod(const MethodOptions& options)
{
  return std::make_unique<SingleRayMethod>(options.lambda);
}

} // namespace mote::bench
