#include "../particles/HitImage.h"
#include "TreePicture.h"
#include "TriangleMethod.h"

#include <kernels/meshes/RlodTree.h>

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

  std::vector<std::string> occlusionModes() const override { return {"packet 64"}; }

  void occlude(
    std::size_t /*mode*/, const OcclusionRays& rays, OcclusionAnswers& answers) const override
  {
    occludePackets(rays, answers, [&](RayPacket& packet) { tree_.occlude(packet, 0); });
  }

private:
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
