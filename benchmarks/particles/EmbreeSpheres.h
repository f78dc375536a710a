#pragma once

#include "../EmbreeDevice.h"
#include "ParticleInput.h"

#include <kernels/core/RawVector.h>

namespace mote::bench
{

/// Embree's sphere points over an input.
class EmbreeSpheres
{
public:
  /// Builds with so many threads. Throws Error where Embree cannot start.
  explicit EmbreeSpheres(int threads);
  ~EmbreeSpheres();
  EmbreeSpheres(const EmbreeSpheres&) = delete;
  EmbreeSpheres& operator=(const EmbreeSpheres&) = delete;

  /// Builds over all particles of the input, anew where that was done before: sphere i is particle
  /// i. Throws Error where Embree fails.
  void build(const ParticleInput& input);

  RTCScene scene() const { return scene_; }
  /// What the spheres' coordinates in float are relative to.
  const Vec3d& middle() const { return middle_; }
  std::size_t bytes() const { return device_.bytes() + spheres_.capacity() * sizeof(Vec4f); }

private:
  void makeScene();

  EmbreeDevice device_;
  RTCScene scene_ = nullptr;
  RTCGeometry geometry_ = nullptr; ///< all spheres
  Vec3d middle_{0.0};
  RawVector<Vec4f> spheres_;
};

} // namespace mote::bench
