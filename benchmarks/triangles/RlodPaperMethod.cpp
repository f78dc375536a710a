#include "../particles/HitImage.h"
#include "TreePicture.h"
#include "TriangleMethod.h"
#include "paper/RlodPaperTree.h"

#include <algorithm>

namespace mote::bench
{

namespace
{

class RlodPaperMethod : public TriangleMethod
{
public:
  explicit RlodPaperMethod(RlodPaperTree::Rule rule) { tree_.setRule(rule); }

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

  std::vector<std::string> modes(TriangleTask task) const override
  {
    if (task == TriangleTask::Reflection)
      return {};
    return {"packet 16", "single"};
  }

  void cast(std::size_t mode, const CameraRays& rays, TriangleImage& image) const override
  {
    forBlocks(image.width(), image.height(), side,
      [&](int x0, int y0)
      {
        RayBundle bundle;
        rays.fillBundle(bundle, side, x0, y0, 0.0, 0.0);
        tree_.cast(bundle, 0, poe(), together(mode));
        keepHits(tree_, bundle, side, x0, y0, image);
      });
  }

  TriangleVisits visits(
    std::size_t mode, const CameraRays& rays, int width, int height) const override
  {
    const RlodPaperArrays& arrays = tree_.arrays();
    RlodPaperTree::Counts counts;
    counts.seenNodes.resize(arrays.nodes.size());
    counts.seenPlanes.resize(arrays.planes.size());
    counts.seenTriangles.resize(arrays.triangles.size());
    for (int y = 0; y < height; y += side)
      for (int x = 0; x < width; x += side)
      {
        RayBundle bundle;
        rays.fillBundle(bundle, side, x, y, 0.0, 0.0);
        tree_.cast(bundle, 0, poe(), together(mode), counts);
      }
    const double pixels = static_cast<double>(width) * height;
    const auto bytes = [](const std::vector<bool>& seen, std::size_t each)
    { return static_cast<double>(std::count(seen.begin(), seen.end(), true)) * double(each); };
    const std::size_t perNode = sizeof(RlodPaperNode) + (poe() > 0.0 ? sizeof(std::uint32_t) : 0);
    std::size_t references = 0;
    for (std::size_t k = 0; k < arrays.nodes.size(); ++k)
      if (counts.seenNodes[k] && arrays.nodes[k].isLeaf())
        references += arrays.nodes[k].value;
    return {static_cast<double>(counts.nodes) / pixels, TriangleVisits::unknown,
      bytes(counts.seenNodes, perNode) + bytes(counts.seenPlanes, sizeof(RlodPaperPlane)) +
        bytes(counts.seenTriangles, sizeof(arrays.triangles[0])) +
        double(references * sizeof(arrays.references[0]))};
  }

  void occlude(TriangleTask /*task*/, std::size_t mode, const SecondaryRays& rays,
    OcclusionAnswers& answers) const override
  {
    occludePackets(
      rays, answers, [&](RayPacket& packet) { tree_.occlude(packet, 0, together(mode)); });
  }

private:
  static constexpr int side = 16;

  /// How many rays go together.
  static int together(std::size_t mode) { return mode == 0 ? RlodPaperTree::packetRays : 1; }

  RlodPaperTree tree_;
};

} // namespace

std::unique_ptr<TriangleMethod> makeRlodPaperMethod(int /*threads*/)
{
  return std::make_unique<RlodPaperMethod>(RlodPaperTree::Rule::Published);
}

std::unique_ptr<TriangleMethod> makeRlodPaperClampedMethod(int /*threads*/)
{
  return std::make_unique<RlodPaperMethod>(RlodPaperTree::Rule::Clamped);
}

} // namespace mote::bench
