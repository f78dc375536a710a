#include "ParticleMethod.h"

#include <kernels/particles/CoherentGrid.h>

namespace mote::bench
{

namespace
{

class CoherentGridMethod : public ParticleMethod
{
public:
  void build(const ParticleInput& input) override
  {
    CoherentGridOptions options;
    options.keepIndices = false;
    grid_.build(input.set, options);
  }

  std::size_t bytes() const override { return grid_.bytes(); }

  std::vector<std::string> modes() const override { return {"packet 8x8"}; }

  void cast(std::size_t, const CameraRays& rays, HitImage& image) const override
  {
    forBlocks(image.width, image.height, 8,
              [&](int x0, int y0)
              {
                RayPacket packet;
                rays.fillBlock(packet, x0, y0, 0.0, 0.0);
                grid_.cast(packet, 0);
                for (int i = 0; i < RayPacket::capacity; ++i)
                {
                  int dx = 0, dy = 0;
                  packetOffset(i, dx, dy);
                  const int x = x0 + dx, y = y0 + dy;
                  if (x < image.width && y < image.height)
                    image.put(x, y, static_cast<float>(packet.t[i]),
                              static_cast<std::uint32_t>(packet.slot[i]));
                }
              });
  }

private:
  CoherentGrid grid_;
};

} // namespace

std::unique_ptr<ParticleMethod> makeCoherentGridMethod(int)
{
  return std::make_unique<CoherentGridMethod>();
}

} // namespace mote::bench
