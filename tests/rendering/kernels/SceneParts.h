#pragma once

#include <kernels/scene/Scene.h>

#include <support/Particles.h>

namespace mote::testing
{

/// An object over the particles; they must outlive nothing, the structure copies them.
inline ParticleObject objectOf(const Particles& particles, const Mat4d& toWorld = Mat4d(1.0))
{
  ParticleObject object;
  object.structure = makeParticleStructure(particles.set());
  object.toWorld = toWorld;
  return object;
}

/// A scene of one sphere of radius `radius` about the origin.
inline Scene oneSphere(double radius = 1.0)
{
  Particles particles;
  particles.add(Vec3d(0.0), radius);
  Scene scene;
  scene.particles.push_back(objectOf(particles));
  return scene;
}

} // namespace mote::testing
