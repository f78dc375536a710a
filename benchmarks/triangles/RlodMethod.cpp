#include "../particles/HitImage.h"
#include "TreePicture.h"
#include "TriangleMethod.h"

#include <kernels/meshes/RlodTree.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace mote::bench
{

namespace
{

/// Which R-LODs a tree has, and takes.
enum class Lods
{
  None,
  OfNodes,
  OfAll ///< those of clusters too, which spares memory
};

class RlodMethod : public TriangleMethod
{
public:
  explicit RlodMethod(Lods lods)
    : lods_(lods)
  {
  }

  void build(const TriangleInput& input) override
  {
    tree_.build(input.mesh());
    tree_.setSparesMemory(lods_ == Lods::OfAll);
  }
  bool makeLods() override
  {
    if (lods_ != Lods::None)
      tree_.makeLods();
    return lods_ != Lods::None;
  }
  std::size_t bytes() const override { return tree_.bytes(); }
  LodErrors lodErrors(const CameraRays& rays, int width, int height) const override
  {
    return measureLods(tree_, rays, width, height, poe());
  }

  std::vector<std::string> modes(TriangleTask task) const override
  {
    if (task == TriangleTask::Primary)
      return {"bundle 16x16", "bundle 8x8", "bundle 4x4"};
    if (task == TriangleTask::Shadow)
      return {"packet 64", "bundle 64"};
    return {"packet 64"};
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
        keepHits(tree_, bundle, side, x0, y0, image);
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

  void occlude(TriangleTask /*task*/, std::size_t mode, const SecondaryRays& rays,
    OcclusionAnswers& answers) const override
  {
    if (mode == 0)
      occludePackets(rays, answers, [&](RayPacket& packet) { tree_.occlude(packet, 0, poe()); });
    else
      forPackets(rays.rays, answers,
        [&](const OcclusionRays::Packet& packet) { return inBundle(rays, packet); });
  }

  void castRays(
    std::size_t /*mode*/, const SecondaryRays& rays, std::vector<PacketHits>& hits) const override
  {
    castPackets(tree_, rays, hits, [&](RayPacket& packet) { tree_.cast(packet, 0, poe()); });
  }

private:
  /// Rays of one direction as a bundle that comes from where they go, as shadows are cast.
  std::uint64_t inBundle(const SecondaryRays& rays, const OcclusionRays::Packet& packet) const
  {
    const auto at = [&](const double(&v)[3][OcclusionRays::packetRays], int i)
    { return Vec3d(v[0][i], v[1][i], v[2][i]); };
    RayBundle bundle;
    bundle.kind = RayBundle::Kind::CommonDirection;
    bundle.count = packet.count;
    bundle.direction = -at(packet.direction, 0);
    acrossAxes(bundle.direction, bundle.dx, bundle.dy);
    const Vec3d middle = at(packet.origin, packet.count / 2);
    const double reach = rays.rays.reach;
    bundle.origin = middle - reach * bundle.direction;
    bundle.footprint = rays.widthOf(packet);
    double spread = 0.0;
    double places[2][OcclusionRays::packetRays];
    for (int i = 0; i < packet.count; ++i)
    {
      const Vec3d aside = at(packet.origin, i) - middle;
      places[0][i] = glm::dot(aside, bundle.dx);
      places[1][i] = glm::dot(aside, bundle.dy);
      spread = std::max({spread, std::abs(places[0][i]), std::abs(places[1][i])});
      bundle.t[i] = reach + glm::dot(aside, bundle.direction);
    }
    spread = spread > 0.0 ? spread : reach;
    for (int i = 0; i < packet.count; ++i)
    {
      bundle.x[i] = static_cast<float>(places[0][i] / spread);
      bundle.y[i] = static_cast<float>(places[1][i] / spread);
    }
    bundle.dx *= spread;
    bundle.dy *= spread;
    tree_.occlude(bundle, 0, poe());
    std::uint64_t bits = 0;
    for (int i = 0; i < packet.count; ++i)
      bits |= std::uint64_t{bundle.t[i] < 0.0} << i;
    return bits;
  }

  RlodTree tree_;
  Lods lods_;
};

} // namespace

std::unique_ptr<TriangleMethod> makeRlodMethod(int /*threads*/)
{
  return std::make_unique<RlodMethod>(Lods::OfNodes);
}

std::unique_ptr<TriangleMethod> makePlainRlodMethod(int /*threads*/)
{
  return std::make_unique<RlodMethod>(Lods::None);
}

std::unique_ptr<TriangleMethod> makeSparingRlodMethod(int /*threads*/)
{
  return std::make_unique<RlodMethod>(Lods::OfAll);
}

} // namespace mote::bench
