#include "../EmbreeCaster.h"
#include "EmbreeOcclusion.h"
#include "EmbreeSpheres.h"
#include "ParticleMethod.h"

namespace mote::bench
{

namespace
{

/// Keeps what Embree's rays have hit.
struct EmbreeImage
{
  HitImage& image;

  int width() const { return image.width(); }
  int height() const { return image.height(); }
  void put(int x, int y, const RTCRayHit& hit) { image.put(x, y, hit.ray.tfar, hit.hit.primID); }
  template <typename Rays>
  void putBlock(int x, int y, const Rays& rays, int i)
  {
    image.putBlock(x, y, &rays.ray.tfar[i], &rays.hit.primID[i]);
  }
};

class EmbreeMethod : public ParticleMethod
{
public:
  explicit EmbreeMethod(int threads)
    : spheres_(threads)
  {
  }

  void build(const ParticleInput& input) override { spheres_.build(input); }
  std::size_t bytes() const override { return spheres_.bytes(); }

  std::vector<std::string> modes() const override { return EmbreeCaster<EmbreeImage>::modes(); }

  void cast(std::size_t mode, const CameraRays& rays, HitImage& image) const override
  {
    EmbreeImage hits{image};
    EmbreeCaster<EmbreeImage>(spheres_.scene()).cast(mode, rays, spheres_.middle(), hits);
  }

  std::vector<std::string> occlusionModes() const override { return embreeOcclusionModes(); }

  void occlude(
    std::size_t mode, const OcclusionRays& rays, OcclusionAnswers& answers) const override
  {
    embreeOccluded(mode, spheres_.scene(), RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT, rays, answers);
  }

private:
  EmbreeSpheres spheres_;
};

} // namespace

std::unique_ptr<ParticleMethod> makeEmbreeMethod(const MethodOptions& options)
{
  return std::make_unique<EmbreeMethod>(options.threads);
}

} // namespace mote::bench
