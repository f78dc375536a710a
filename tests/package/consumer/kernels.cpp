// The installed kernels without VTK: every header, and a picture of one sphere.
#include <kernels/core/ArrayView.h>
#include <kernels/core/Box.h>
#include <kernels/core/Camera.h>
#include <kernels/core/Error.h>
#include <kernels/core/Film.h>
#include <kernels/core/Progress.h>
#include <kernels/core/RawVector.h>
#include <kernels/core/RayPacket.h>
#include <kernels/core/Vec.h>
#include <kernels/particles/CoherentGrid.h>
#include <kernels/particles/ParticleSet.h>
#include <kernels/particles/ParticleStructure.h>
#include <kernels/scene/Scene.h>
#include <kernels/shading/ColorMap.h>
#include <kernels/shading/Light.h>
#include <kernels/tracing/Picking.h>
#include <kernels/tracing/RayCaster.h>
#include <kernels/tracing/SilhouetteFilm.h>

#include <cmath>
#include <cstdio>

int main()
{
  const double center[3] = {0, 0, 0};
  mote::ParticleSet particles;
  particles.positions = mote::ArrayView(center, 1, 3);
  particles.radius = 0.5;
  mote::Scene scene;
  scene.surfaces.emplace_back();
  scene.surfaces[0].surface = mote::ParticleSurface(mote::makeParticleStructure(particles));
  mote::Camera camera;
  camera.position = {0, 0, 5};
  mote::Film film;
  film.resize(65, 65, mote::Film::Id);
  mote::RayCaster(scene).addSample(camera, film);
  const float depth = film.depth()[32 * 65 + 32];
  if (std::abs(depth - 4.5f) > 1e-3f || film.id()[0] != mote::Film::noId)
  {
    std::printf("The sphere is not where it should be: %g\n", depth);
    return 1;
  }
  return 0;
}
