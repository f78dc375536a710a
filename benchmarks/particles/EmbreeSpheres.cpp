#include "EmbreeSpheres.h"

#include <tbb/parallel_for.h>

#include <limits>

namespace mote::bench
{

EmbreeSpheres::EmbreeSpheres(int threads)
  : device_(threads)
{
}

EmbreeSpheres::~EmbreeSpheres()
{
  if (scene_ != nullptr)
  {
    rtcReleaseGeometry(geometry_);
    rtcReleaseScene(scene_);
  }
}

void EmbreeSpheres::makeScene()
{
  scene_ = rtcNewScene(device_);
  // Measured: HIGH gives points the same tree as MEDIUM does.
  rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_MEDIUM);
  geometry_ = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  rtcAttachGeometry(scene_, geometry_);
}

void EmbreeSpheres::build(const ParticleInput& input)
{
  const ParticleSet& set = input.set;
  middle_ = middleOf(input);
  spheres_.resize(set.count());
  tbb::parallel_for(std::size_t{0}, set.count(),
    [&](std::size_t i)
    {
      const double r = set.radiusOf(i);
      const bool valid = isValidParticle(set.position(i), r);
      spheres_[i] = valid ? Vec4f(Vec3f(set.position(i) - middle_), static_cast<float>(r))
                          : Vec4f(Vec3f(std::numeric_limits<float>::quiet_NaN()), 0.0f);
    });
  if (scene_ == nullptr)
    makeScene();
  rtcSetSharedGeometryBuffer(geometry_, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
    spheres_.data(), 0, sizeof(Vec4f), spheres_.size());
  rtcCommitGeometry(geometry_);
  rtcCommitScene(scene_);
  device_.check();
}

} // namespace mote::bench
