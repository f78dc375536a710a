#include "../EmbreeCaster.h"
#include "../particles/EmbreeOcclusion.h"
#include "EmbreeNearest.h"
#include "TriangleMethod.h"

namespace mote::bench
{

namespace
{

/// Keeps what Embree's rays have hit.
struct EmbreeTriangleImage
{
  TriangleImage& image;

  int width() const { return image.width(); }
  int height() const { return image.height(); }
  void put(int x, int y, const RTCRayHit& hit)
  {
    TriangleImage::Block& block = image.blockAt(x, y);
    const int k = TriangleImage::place(x, y);
    block.t[k] = hit.ray.tfar;
    block.triangle[k] = hit.hit.primID;
    block.normal[0][k] = hit.hit.Ng_x;
    block.normal[1][k] = hit.hit.Ng_y;
    block.normal[2][k] = hit.hit.Ng_z;
  }
  template <typename Rays>
  void putBlock(int x, int y, const Rays& rays, int i)
  {
    TriangleImage::Block& block = image.blockAt(x, y);
    std::copy_n(&rays.ray.tfar[i], 16, block.t);
    std::copy_n(&rays.hit.primID[i], 16, block.triangle);
    std::copy_n(&rays.hit.Ng_x[i], 16, block.normal[0]);
    std::copy_n(&rays.hit.Ng_y[i], 16, block.normal[1]);
    std::copy_n(&rays.hit.Ng_z[i], 16, block.normal[2]);
  }
};

class EmbreeTriangles : public TriangleMethod
{
public:
  EmbreeTriangles(int threads, RTCBuildQuality quality)
    : device_(threads)
    , quality_(quality)
  {
  }
  ~EmbreeTriangles() override { release(); }

  void build(const TriangleInput& input) override
  {
    release();
    scene_ = rtcNewScene(device_);
    rtcSetSceneBuildQuality(scene_, quality_);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(geometry, quality_);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
      input.points.data(), 0, sizeof(Vec3f), input.pointCount());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
      input.triangles.data(), 0, sizeof(TriangleMesh::Corners), input.triangles.size());
    shared_ =
      input.points.size() * sizeof(Vec3f) + input.triangles.size() * sizeof(TriangleMesh::Corners);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
    device_.check();
  }

  std::size_t bytes() const override { return device_.bytes() + shared_; }
  std::vector<std::string> modes(TriangleTask task) const override
  {
    if (task == TriangleTask::Primary)
      return EmbreeCaster<EmbreeTriangleImage>::modes();
    if (task == TriangleTask::Reflection)
      return {"single", "packet 16", "stream 64"};
    return embreeOcclusionModes();
  }

  void cast(std::size_t mode, const CameraRays& rays, TriangleImage& image) const override
  {
    EmbreeTriangleImage hits{image};
    EmbreeCaster<EmbreeTriangleImage>(scene_).cast(mode, rays, Vec3d(0.0), hits);
  }

  void occlude(TriangleTask task, std::size_t mode, const SecondaryRays& rays,
    OcclusionAnswers& answers) const override
  {
    embreeOccluded(mode, scene_, contextOf(task), rays.rays, answers);
  }

  void castRays(
    std::size_t mode, const SecondaryRays& rays, std::vector<PacketHits>& hits) const override
  {
    embreeNearest(mode, scene_, contextOf(TriangleTask::Reflection), rays.rays, hits);
  }

private:
  /// Mirrored rays of neighbouring pixels run alike, and so do those to a light.
  static RTCIntersectContextFlags contextOf(TriangleTask task)
  {
    return task == TriangleTask::Occlusion ? RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT
                                           : RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  }

  void release()
  {
    if (scene_ != nullptr)
      rtcReleaseScene(scene_);
    scene_ = nullptr;
  }

  EmbreeDevice device_;
  RTCBuildQuality quality_;
  RTCScene scene_ = nullptr;
  std::size_t shared_ = 0; ///< bytes of the input, which it reads
};

} // namespace

std::unique_ptr<TriangleMethod> makeEmbreeTriangles(int threads)
{
  return std::make_unique<EmbreeTriangles>(threads, RTC_BUILD_QUALITY_HIGH);
}

std::unique_ptr<TriangleMethod> makeEmbreeMediumTriangles(int threads)
{
  return std::make_unique<EmbreeTriangles>(threads, RTC_BUILD_QUALITY_MEDIUM);
}

} // namespace mote::bench
