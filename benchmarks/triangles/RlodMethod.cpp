#include "../particles/HitImage.h"
#include "TriangleMethod.h"

#include <kernels/core/RayBundle.h>
#include <kernels/core/RayPacket.h>
#include <kernels/meshes/RlodTree.h>

#include <limits>

namespace mote::bench
{

namespace
{

constexpr float infinity = std::numeric_limits<float>::infinity();

class RlodMethod : public TriangleMethod
{
public:
  void build(const TriangleInput& input) override { tree_.build(input.mesh()); }
  bool makeLods() override
  {
    tree_.makeLods();
    return true;
  }
  std::size_t bytes() const override { return tree_.bytes(); }
  LodErrors lodErrors(const CameraRays& rays, int width, int height) const override
  {
    return measureLods(tree_, rays, width, height, poe());
  }

  std::vector<std::string> modes() const override
  {
    return {"bundle 16x16", "bundle 8x8", "bundle 4x4"};
  }

  void cast(std::size_t mode, const CameraRays& rays, TriangleImage& image) const override
  {
    const int side = 16 >> mode;
    forBlocks(image.width(), image.height(), side,
      [&](int x0, int y0)
      {
        RayBundle bundle;
        rays.fillBundle(bundle, side, x0, y0, 0.0, 0.0);
        tree_.cast(bundle, 0, poe());
        keep(bundle, side, x0, y0, image);
      });
  }

  TriangleVisits visits(
    std::size_t mode, const CameraRays& rays, int width, int height) const override
  {
    const int side = 16 >> mode;
    RlodTree::Counts counts;
    counts.seenNodes.resize(tree_.nodeCount());
    counts.seenPlanes.resize(tree_.nodeCount());
    counts.seenClusters.resize(tree_.clusterCount());
    for (int y = 0; y < height; y += side)
      for (int x = 0; x < width; x += side)
      {
        RayBundle bundle;
        rays.fillBundle(bundle, side, x, y, 0.0, 0.0);
        tree_.cast(bundle, 0, poe(), counts);
      }
    const double pixels = static_cast<double>(width) * height;
    const auto seen = [](const std::vector<bool>& things)
    { return static_cast<double>(std::count(things.begin(), things.end(), true)); };
    const double bytes = seen(counts.seenNodes) * RlodTree::bytesPerNode +
                         seen(counts.seenClusters) * RlodTree::bytesPerCluster +
                         (poe() > 0.0 ? seen(counts.seenNodes) * RlodTree::bytesPerWords : 0.0) +
                         seen(counts.seenPlanes) * RlodTree::bytesPerPlanes;
    return {static_cast<double>(counts.nodes) / pixels,
      static_cast<double>(counts.clusters) / pixels, bytes};
  }

  std::vector<std::string> occlusionModes() const override { return {"packet 64"}; }

  void occlude(
    std::size_t /*mode*/, const OcclusionRays& rays, OcclusionAnswers& answers) const override
  {
    forPackets(rays, answers,
      [&](const OcclusionRays::Packet& asked)
      {
        RayPacket packet;
        packet.count = asked.count;
        for (int axis = 0; axis < 3; ++axis)
        {
          std::copy_n(asked.origin[axis], asked.count, packet.origin[axis]);
          std::copy_n(asked.direction[axis], asked.count, packet.direction[axis]);
        }
        std::fill_n(packet.tMin, asked.count, 0.0);
        std::fill_n(packet.t, asked.count, rays.reach);
        std::fill_n(packet.object, asked.count, -1);
        tree_.occlude(packet, 0);
        std::uint64_t bits = 0;
        for (int i = 0; i < asked.count; ++i)
          bits |= std::uint64_t{packet.t[i] < 0.0} << i;
        return bits;
      });
  }

private:
  void keep(const RayBundle& bundle, int side, int x0, int y0, TriangleImage& image) const
  {
    for (int i = 0; i < bundle.count; i += 16)
    {
      int x = 0, y = 0;
      bundleOffset(side, i, x, y);
      TriangleImage::Block& block = image.blockAt(x0 + x, y0 + y);
      int hits = 0;
      for (int k = 0; k < 16; ++k)
      {
        hits += bundle.object[i + k] >= 0;
        block.t[k] = bundle.object[i + k] < 0 ? infinity : static_cast<float>(bundle.t[i + k]);
      }
      if (hits == 16)
        describe(bundle.slot + i, 16, block);
      else if (hits > 0)
        describeSome(bundle, i, block);
    }
  }

  /// Triangles and normals of hits that stand side by side.
  void describe(const std::uint64_t* slots, int count, TriangleImage::Block& block) const
  {
    float* const normals[3] = {block.normal[0], block.normal[1], block.normal[2]};
    std::uint64_t ids[16];
    tree_.normals(slots, count, normals);
    tree_.inputIndices(slots, count, ids);
    for (int k = 0; k < count; ++k)
      block.triangle[k] = static_cast<std::uint32_t>(ids[k]);
  }

  void describeSome(const RayBundle& bundle, int first, TriangleImage::Block& block) const
  {
    std::uint64_t slots[16];
    int count = 0;
    for (int k = 0; k < 16; ++k)
      if (bundle.object[first + k] >= 0)
        slots[count++] = bundle.slot[first + k];
    describe(slots, count, block);
    for (int k = 15; k >= 0; --k) // from the last: none is written over before it is moved
      if (bundle.object[first + k] >= 0)
      {
        --count;
        block.triangle[k] = block.triangle[count];
        for (auto& normal : block.normal)
          normal[k] = normal[count];
      }
  }

  RlodTree tree_;
};

} // namespace

std::unique_ptr<TriangleMethod> makeRlodMethod(int /*threads*/)
{
  return std::make_unique<RlodMethod>();
}

} // namespace mote::bench
