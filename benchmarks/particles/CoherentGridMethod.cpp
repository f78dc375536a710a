#include "ParticleMethod.h"

#include <kernels/particles/CoherentGrid.h>

namespace mote::bench
{

namespace
{

/// Where in a packet the ray of a block's pixel lies: hits are written row by row.
struct Places
{
  int ray[8][8];
  Places()
  {
    for (int i = 0; i < RayPacket::capacity; ++i)
    {
      int x = 0, y = 0;
      packetOffset(i, x, y);
      ray[y][x] = i;
    }
  }
};
const Places places;

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
        const int columns = std::min(8, image.width - x0), rows = std::min(8, image.height - y0);
        for (int y = 0; y < rows; ++y)
          for (int x = 0; x < columns; ++x)
          {
            const auto i = static_cast<std::size_t>(places.ray[y][x]);
            image.put(x0 + x, y0 + y, static_cast<float>(packet.t[i]),
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
