// Levels of detail of the P-k-d tree in scenes: light, shadows, colours.

#include "PkdTreeLodParts.h"

#include <kernels/scene/ColorMeans.h>
#include <kernels/tracing/SeenParticles.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace mote;
using namespace mote::testing;

TEST(PkdTreeLodScene, IdsAreOfParticlesAndColoursAreMeans)
{
  const Particles particles = denseParticles(40, 19);
  const auto structure = treeOver(particles, true);
  std::vector<float> values;
  for (std::size_t k = 0; k < particles.size(); ++k)
    values.push_back(k % 2 == 0 ? 0.0f : 1.0f);
  Scene scene;
  SurfaceObject object;
  object.surface = ParticleSurface(structure, 3.0);
  object.coloring.values = ArrayView(values.data(), values.size(), 1);
  object.coloring.map.table = {Vec4f(0.0f, 0.0f, 0.0f, 1.0f), Vec4f(1.0f)};
  object.material.ambient = 1.0f; // the colour itself
  object.material.diffuse = 0.0f;
  scene.lights.clear();
  addTo(scene, object);
  const auto spreadOf = [&]
  {
    const Film film = tracedFilm(scene, lookAt({4.0, 3.0, 6.0}, Vec3d(0.0), 25.0), 96);
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < film.pixels(); ++i)
      if (film.object()[i] == 0)
      {
        EXPECT_LT(film.id()[i], particles.size());
        sum += std::pow(film.color()[4 * i] - 0.5, 2.0);
        ++count;
      }
    return std::sqrt(sum / count);
  };
  EXPECT_NEAR(spreadOf(), 0.5, 1e-6) << "colours of the particles that speak";
  const ColorMeans means = meansOf(treeOf(structure), scene.surfaces[0].coloring);
  scene.surfaces[0].coloring.means = means.view();
  EXPECT_LT(spreadOf(), 0.3);
  scene.surfaces[0].surface = ParticleSurface(structure);
  EXPECT_NEAR(spreadOf(), 0.5, 1e-6) << "without error nothing is a mean";
}

TEST(PkdTreeLodScene, BoxesAreAsBrightAsTheirParticles)
{
  const auto structure = treeOver(denseParticles(40, 20), true);
  Scene scene;
  SurfaceObject object;
  object.material.ambient = 0.0f;
  addTo(scene, object);
  const auto brightness = [&](double poe)
  {
    scene.surfaces[0].surface = ParticleSurface(structure, poe);
    const Camera camera = lookAt({4.0, 3.0, 6.0}, Vec3d(0.0), 25.0);
    return meanOf(tracedFilm(scene, camera, 96, 96, {16, 0, 0}), 0);
  };
  EXPECT_NEAR(brightness(3.0) / brightness(0.0), 1.0, 0.1) << "lit from the eye";
  for (const Vec3d towards : {Vec3d(1.0, 4.0, 1.0), Vec3d(4.0, 1.0, 1.0), Vec3d(-1.0, 3.0, 4.0)})
    for (const bool shadows : {false, true})
    {
      SCOPED_TRACE(towards.x + 10.0 * shadows);
      scene.lights = {shadowLight(Light::Kind::Directional, -glm::normalize(towards))};
      scene.lights[0].shadows = shadows;
      EXPECT_NEAR(brightness(3.0) / brightness(0.0), 1.0, 0.25);
    }
  scene.lights.clear();
  scene.occlusion = {64, 0.2};
  scene.surfaces[0].material.ambient = 1.0f;
  EXPECT_NEAR(brightness(3.0) / brightness(0.0), 1.0, 0.25) << "the sky";
}

TEST(PkdTreeLodScene, SparseSetsShadowThemselvesAsTheirParticlesDo)
{
  for (const double radius : {0.0025, 0.005, 0.01})
    for (const Vec3d towards : {Vec3d(1.0, 4.0, 1.0), Vec3d(-1.0, 3.0, 4.0)})
    {
      SCOPED_TRACE(radius);
      const auto structure = treeOver(randomParticles(60000, 25, radius, radius), true);
      Scene scene;
      SurfaceObject object;
      object.material.ambient = 0.0f;
      addTo(scene, object);
      scene.lights = {shadowLight(Light::Kind::Directional, -glm::normalize(towards))};
      const auto brightness = [&](double poe)
      {
        scene.surfaces[0].surface = ParticleSurface(structure, poe);
        const Camera camera = lookAt({4.0, 3.0, 6.0}, Vec3d(0.0), 25.0);
        return meanOf(tracedFilm(scene, camera, 96, 96, {16, 0, 0}), 0);
      };
      EXPECT_NEAR(brightness(2.5) / brightness(0.0), 1.0, 0.32);
    }
}

TEST(PkdTreeLodScene, PicksAndSetsWithoutLodsAreExact)
{
  const Particles particles = denseParticles(20, 21);
  const auto structure = treeOver(particles, true);
  Scene scene;
  SurfaceObject object;
  object.surface = ParticleSurface(structure, 64.0);
  addTo(scene, object);
  EXPECT_EQ(pixelsOfError(scene), 64.0);
  Scene exact = scene;
  exact.surfaces[0].surface = ParticleSurface(structure);
  const Vec3d eye(4.0, 3.0, 6.0);
  const auto rough = pick(scene, eye, Vec3d(0.1) - eye), right = pick(exact, eye, Vec3d(0.1) - eye);
  ASSERT_TRUE(rough && right);
  EXPECT_EQ(rough->id, right->id);
  EXPECT_EQ(rough->position, right->position);
  scene.surfaces[0].surface = ParticleSurface(treeOver(particles, false), 64.0);
  EXPECT_EQ(pixelsOfError(scene), 0.0);
}

TEST(PkdTreeLodScene, WhatIsSeenIsInThePicture)
{
  // Of sides that no bundle of rays ends at, in the middle of many particles.
  const Particles particles = denseParticles(30, 23);
  const std::vector<reference::Sphere> spheres = reference::validSpheres(particles.set());
  const auto structure = treeOver(particles, false);
  const Camera camera = lookAt({0.0, 0.0, 6.0}, Vec3d(0.0), 8.0);
  Scene scene;
  addTo(scene, SurfaceObject());
  scene.surfaces[0].surface = ParticleSurface(structure);
  constexpr int width = 37, height = 21;
  SeenParticles seen;
  ASSERT_TRUE(findSeenParticles(scene, camera, {width, height}, seen));
  const CameraRays rays(camera, width, height);
  int count = 0;
  for (std::size_t slot = 0; slot < particles.size(); ++slot)
  {
    if ((seen[0][slot / 64] >> slot % 64 & 1U) == 0)
      continue;
    ++count;
    reference::Sphere sphere = spheres[treeOf(structure).inputIndex(slot)];
    sphere.radius *= 1.001;
    reference::Hit hit;
    for (int pixel = 0; pixel < width * height; ++pixel)
      reference::meet(
        reference::cameraRay(rays, pixel % width + 0.5, pixel / width + 0.5), sphere, hit);
    EXPECT_TRUE(hit) << slot;
  }
  EXPECT_GT(count, 100);
}

TEST(PkdTreeLodScene, WhatIsSeenAreParticlesAndNoBoxes)
{
  const auto structure = treeOver(denseParticles(40, 22), true);
  const Camera camera = lookAt({4.0, 3.0, 6.0}, Vec3d(0.0), 25.0);
  Scene scene;
  addTo(scene, SurfaceObject());
  const auto seenWith = [&](double poe)
  {
    scene.surfaces[0].surface = ParticleSurface(structure, poe);
    SeenParticles seen;
    EXPECT_TRUE(findSeenParticles(scene, camera, {96, 96}, seen));
    return seen;
  };
  EXPECT_EQ(seenWith(3.0), seenWith(0.0));
}
