// Sums over images against integrals: coverage, and the light that a sphere sends back.

#include "SceneParts.h"

#include <kernels/tracing/RayCaster.h>

#include <support/CastOracle.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

/// Mean colour of an image, summed in double.
glm::dvec4 meanColor(const Scene& scene, const Camera& camera, int size, int samples)
{
  Film film;
  film.resize(size, size);
  const RayCaster caster(scene);
  for (int k = 0; k < samples; ++k)
    caster.addSample(camera, film);
  glm::dvec4 sum(0.0);
  for (std::size_t i = 0; i < film.pixels(); ++i)
    for (int c = 0; c < 4; ++c)
      sum[c] += film.color()[4 * i + std::size_t(c)];
  return sum / double(film.pixels());
}

/// Looks at the unit sphere so that it covers `share` = pi / (2 scale)^2 of the image.
Camera orthographic(double scale = 1.25)
{
  Camera camera = lookAt({3.0, 4.0, 5.0}, Vec3d(0.0));
  camera.projection = Camera::Projection::Orthographic;
  camera.parallelScale = scale;
  return camera;
}

const double share = M_PI / (2.5 * 2.5);

} // namespace

TEST(RayCasterEnergy, CoverageTendsToTheProjectedArea)
{
  const Scene scene = oneSphere();
  EXPECT_NEAR(meanColor(scene, orthographic(), 64, 1).a, share, 4e-3);
  EXPECT_NEAR(meanColor(scene, orthographic(), 64, 16).a, share, 4e-4);
  EXPECT_NEAR(meanColor(scene, orthographic(), 64, 64).a, share, 1e-4);
}

TEST(RayCasterEnergy, PerspectiveCoverageIsThatOfTheTangentCone)
{
  const Scene scene = oneSphere();
  const double distance = 3.0, angle = 60.0;
  const double radius = std::tan(std::asin(1.0 / distance)) / std::tan(angle * M_PI / 360.0);
  const Camera camera = lookAt({0.0, 0.0, distance}, Vec3d(0.0), angle);
  EXPECT_NEAR(meanColor(scene, camera, 64, 32).a, M_PI * radius * radius / 4.0, 2e-4);
}

TEST(RayCasterEnergy, LambertUnderAHeadlightSendsBackTwoThirds)
{
  Scene scene = oneSphere();
  scene.surfaces[0].coloring.constant = {1.0f, 0.5f, 0.25f, 1.0f};
  const glm::dvec4 mean = meanColor(scene, orthographic(), 64, 32);
  EXPECT_NEAR(mean.r, share * 2.0 / 3.0, 2e-4);
  EXPECT_NEAR(mean.g, share / 3.0, 1e-4);
  EXPECT_NEAR(mean.b, share / 6.0, 1e-4);
}

TEST(RayCasterEnergy, LambertUnderADirectionalLightFollowsThePhaseLaw)
{
  // Mean over the disc of a sphere lit from the phase angle a: 2/(3 pi) (sin a + (pi - a) cos a).
  const Vec3d toEye = glm::normalize(Vec3d(3.0, 4.0, 5.0));
  const Vec3d aside = glm::normalize(glm::cross(toEye, Vec3d(0.0, 1.0, 0.0)));
  for (const double phase : {0.0, 0.5, 1.0, M_PI / 2.0, 2.5, M_PI})
  {
    Scene scene = oneSphere();
    const Vec3d toLight = std::cos(phase) * toEye + std::sin(phase) * aside;
    const double wanted =
      share * 2.0 / (3.0 * M_PI) * (std::sin(phase) + (M_PI - phase) * std::cos(phase));
    scene.lights = {{Light::Kind::Directional, -3.0 * toLight, Vec3f(0.5f)}};
    EXPECT_NEAR(meanColor(scene, orthographic(), 64, 32).r, 0.5 * wanted, 2e-4) << phase;
    // A point far away is a direction.
    scene.lights = {{Light::Kind::Point, 1e6 * toLight, Vec3f(1.0f)}};
    EXPECT_NEAR(meanColor(scene, orthographic(), 64, 32).r, wanted, 2e-4) << phase;
  }
}

TEST(RayCasterEnergy, LightsAddUp)
{
  Scene scene = oneSphere();
  scene.lights = {{Light::Kind::Headlight, Vec3d(0.0), Vec3f(0.3f)},
    {Light::Kind::Headlight, Vec3d(0.0), Vec3f(0.2f)}};
  EXPECT_NEAR(meanColor(scene, orthographic(), 64, 32).r, 0.5 * share * 2.0 / 3.0, 2e-4);
}

TEST(RayCasterEnergy, AmbientAndSpecularParts)
{
  Scene scene = oneSphere();
  Material& material = scene.surfaces[0].material;
  material.diffuse = 0.0f;
  material.ambient = 0.25f;
  EXPECT_NEAR(meanColor(scene, orthographic(), 64, 32).r, 0.25 * share, 1e-4);
  material.ambient = 0.0f;
  material.specular = 0.5f;
  for (const double power : {1.0, 5.0})
  {
    // Under a headlight the cosine to the mirrored ray is 1 - 2 rho^2, rho from the disc's middle;
    // the mean of its p-th power over the disc, where it is positive, is 1 / (2 (p + 1)).
    material.specularPower = static_cast<float>(power);
    EXPECT_NEAR(
      meanColor(scene, orthographic(), 64, 32).r, 0.5 * share / (2.0 * (power + 1.0)), 2e-4);
  }
}

TEST(RayCasterEnergy, OpacityAndAlphaArePremultipliedMeans)
{
  Scene scene = oneSphere();
  Material& material = scene.surfaces[0].material;
  material.ambient = 1.0f;
  material.diffuse = 0.0f;
  material.opacity = 0.5f;
  scene.surfaces[0].coloring.constant = {0.8f, 0.8f, 0.8f, 0.5f};
  for (const int samples : {1, 4, 32})
  {
    const glm::dvec4 mean = meanColor(scene, orthographic(), 64, samples);
    EXPECT_NEAR(mean.a, 0.25 * share, 2e-3 / samples);
    EXPECT_NEAR(mean.r, 0.8 * mean.a, 1e-6);
  }
}
