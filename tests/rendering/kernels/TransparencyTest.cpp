// What lies behind surfaces that are not opaque.

#include "MeshParts.h"
#include "ShadowParts.h"

#include <kernels/tracing/Picking.h>

#include <support/CastOracle.h>
#include <support/Volumes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

/// Spheres with a colour each, lit evenly, along z from the eye at z = 20.
struct Row
{
  Scene scene;
  std::vector<std::uint8_t> colors;
  Camera camera = lookAt({0.0, 0.0, 20.0}, Vec3d(0.0), 20.0);

  Row(const std::vector<std::pair<double, Vec4f>>& spheres, double radius = 0.5)
  {
    Particles particles;
    for (const auto& [z, color] : spheres)
    {
      particles.add({0.0, 0.0, z}, radius);
      for (int c = 0; c < 4; ++c)
        colors.push_back(static_cast<std::uint8_t>(std::lround(255.0f * color[c])));
    }
    addTo(scene, objectOf(particles));
    scene.surfaces[0].coloring.direct =
      ArrayView(colors.data(), ArrayView::Type::UInt8, spheres.size(), 4);
    this->lightEvenly();
  }
  void lightEvenly()
  {
    scene.lights.clear();
    for (SurfaceObject& object : scene.surfaces)
    {
      object.material.ambient = 1.0f;
      object.material.diffuse = 0.0f;
    }
  }
  Film traced(int samples = 1, unsigned more = 0) const
  {
    Film film;
    film.resize(9, 9, Film::Id | Film::Normal | more);
    for (int k = 0; k < samples; ++k)
      EXPECT_TRUE(RayCaster(scene).addSample(camera, film));
    return film;
  }
};

constexpr std::size_t middle = 4 * 9 + 4;
const Vec4f red(1, 0, 0, 1), green(0, 1, 0, 1), clear(0, 0, 1, 0);
const Vec4f halfRed(1, 0, 0, 0.6f), thirdBlue(0, 0, 1, 0.2f); // alphas that 8 bits have

void expectColor(const Film& film, double r, double g, double b, double a)
{
  const float* c = film.color() + 4 * middle;
  EXPECT_NEAR(c[0], r, 1e-6);
  EXPECT_NEAR(c[1], g, 1e-6);
  EXPECT_NEAR(c[2], b, 1e-6);
  EXPECT_NEAR(c[3], a, 1e-6);
}

} // namespace

TEST(Transparency, WhatIsWhollyTransparentIsNotThere)
{
  const Row with({{3.0, clear}, {0.0, red}, {1.5, clear}}), without({{0.0, red}});
  const Film a = with.traced(3), b = without.traced(3);
  for (std::size_t i = 0; i < 4 * a.pixels(); ++i)
    EXPECT_EQ(a.color()[i], b.color()[i]);
  EXPECT_NEAR(a.depth()[middle], 19.5, 1e-5);
  EXPECT_EQ(a.id()[middle], 1U);
  EXPECT_NEAR(a.normal()[3 * middle + 2], 1.0, 1e-6);
  const auto picked = pick(with.scene, {0.0, 0.0, 20.0}, {0.0, 0.0, -1.0});
  ASSERT_TRUE(picked);
  EXPECT_EQ(picked->id, 1U);
  EXPECT_NEAR(picked->t, 19.5, 1e-5);
  const Film nothing = Row({{3.0, clear}, {0.0, clear}}).traced();
  expectColor(nothing, 0, 0, 0, 0);
  EXPECT_EQ(nothing.depth()[middle], INFINITY);
  EXPECT_EQ(nothing.id()[middle], Film::noId);
  EXPECT_EQ(nothing.object()[middle], -1);
  EXPECT_EQ(nothing.normal()[3 * middle + 2], 0.0f);
}

TEST(Transparency, LayersAreBlendedFromFrontToBack)
{
  // Each sphere counts once, not at its far side again; in whatever order they come.
  for (const auto& order : {std::vector<int>{0, 1, 2}, {2, 0, 1}, {1, 2, 0}})
  {
    const std::pair<double, Vec4f> all[] = {{3.0, halfRed}, {1.0, thirdBlue}, {-1.0, green}};
    std::vector<std::pair<double, Vec4f>> spheres;
    for (const int k : order)
      spheres.push_back(all[k]);
    const Film film = Row(spheres).traced();
    expectColor(film, 0.6, 0.4 * 0.8, 0.4 * 0.2, 1.0);
    EXPECT_NEAR(film.depth()[middle], 16.5, 1e-5) << "depth is that of the nearest";
  }
  expectColor(Row({{3.0, halfRed}, {1.0, thirdBlue}}).traced(), 0.6, 0, 0.4 * 0.2, 0.68);
}

TEST(Transparency, SpheresWithinOneAnotherCountOnceEach)
{
  Row row({{0.0, halfRed}, {0.1, thirdBlue}, {-0.1, thirdBlue}});
  expectColor(row.traced(), 0.6 * 0.8, 0, 0.2 + 0.8 * 0.4 * 0.2, 1.0 - 0.8 * 0.4 * 0.8);
}

TEST(Transparency, OpacityOfTheMaterialCountsTheSame)
{
  Row row({{3.0, red}, {0.0, green}});
  row.scene.surfaces[0].material.opacity = 0.25f;
  expectColor(row.traced(), 0.25, 0.75 * 0.25, 0, 1.0 - 0.75 * 0.75);
}

TEST(Transparency, BetweenObjectsAndKinds)
{
  // A red sphere seen through a clear iso-surface and half a blue one.
  Row row({{0.0, red}});
  HexCells cells = hexBlock(2, 2, 2);
  cells.move([](const Vec3d& p) { return p + Vec3d(-1.0, -1.0, 4.0); });
  const auto mesh = cells.mesh();
  const CloudObject volume =
    volumeOf(mesh, pointValues(*mesh, [](const Vec3d& p) { return p.z; }), evenTransfer(0.5F));
  addTo(row.scene, isoSurfacesOf(volume, {5.5, 4.5}));
  ColorMap& map = row.scene.surfaces[1].coloring.map;
  map.knots = {4.5, 5.5};
  map.table = {{0, 0, 1, 0.5f}, {0, 1, 0, 0}};
  row.lightEvenly();
  const Film film = row.traced(2);
  expectColor(film, 0.5, 0, 0.5, 1);
  EXPECT_EQ(film.object()[middle], 1);
  EXPECT_NEAR(film.depth()[middle], 15.5, 1e-5);
  // Half of each surface of the one volume.
  map.table = {{0, 0, 1, 0.5f}, {0, 1, 0, 0.5f}};
  expectColor(row.traced(), 0.25, 0.5, 0.25, 1);
}

TEST(Transparency, CloudsLieBetweenLayers)
{
  // A cloud from z = 4 to 6 behind half a sphere and in front of a whole one.
  Row row({{9.0, halfRed}, {0.0, red}});
  HexCells cells = hexBlock(2, 2, 2);
  cells.move([](const Vec3d& p) { return p + Vec3d(-1.0, -1.0, 4.0); });
  const auto mesh = cells.mesh();
  TransferFunction green;
  green.knots = {{0.0, Vec4f(0, 1, 0, 0.5f)}};
  row.scene.clouds = {volumeOf(mesh, std::vector<double>(mesh->pointCount(), 0.0), green)};
  const double covered = 1.0 - 0.25;
  expectColor(row.traced(), 0.6 + 0.4 * (1.0 - covered), 0.4 * covered, 0, 1);
  // In front of both, then behind both.
  row.scene.clouds[0].toWorld[3].z = 8.0;
  expectColor(row.traced(), (1.0 - covered) * 1.0, covered, 0, 1);
  row.scene.clouds[0].toWorld[3].z = -12.0;
  expectColor(row.traced(), 1, 0, 0, 1);
  row.colors[7] = 0; // nothing but the cloud behind it
  expectColor(row.traced(), 0.6, 0.4 * covered, 0, 1.0 - 0.4 * (1.0 - covered));
}

TEST(Transparency, IsTheSameForAllBundlesAndEndsAtLimits)
{
  Scene scene;
  addTo(scene, objectOf(randomParticles(400, 5, 0.1, 0.4)));
  scene.surfaces[0].material.opacity = 0.3f;
  const Camera camera = lookAt({3.0, 2.0, 5.0}, Vec3d(0.0), 40.0);
  const Film wanted = tracedFilm(scene, camera, 40, 40, {1, 1, 2});
  for (const int side : {4, 8, 16})
    EXPECT_EQ(differenceOf(wanted, tracedFilm(scene, camera, 40, 40, {1, 2, side})).pixels, 0);
  // Behind the limit nothing is seen.
  Row row({{3.0, halfRed}, {0.0, green}});
  std::vector<float> limits(81, 18.0f);
  Film film;
  film.resize(9, 9);
  RayCaster caster(row.scene);
  caster.setLimits(limits.data());
  EXPECT_TRUE(caster.addSample(row.camera, film));
  expectColor(film, 0.6, 0, 0, 0.6);
}

TEST(Transparency, WhatBeginsAmongManyFarSidesIsMet)
{
  // Far sides of many overlapping spheres, none of which counts again, one close to another; and
  // right behind them small spheres that must not be lost.
  for (const int shells : {4, 16, 27})
  {
    std::vector<std::pair<double, Vec4f>> spheres;
    for (int k = 0; k < shells; ++k)
      spheres.emplace_back(-0.001 * k, Vec4f(1, 1, 1, 0.2f));
    spheres.emplace_back(-1.1, green);
    const Film film = Row(spheres).traced();
    const double through = std::pow(0.8, shells);
    expectColor(film, 1.0 - through, 1.0, 1.0 - through, 1.0);
  }
}

TEST(Transparency, AThinFogOfParticlesIsItsProduct)
{
  std::vector<std::pair<double, Vec4f>> spheres;
  for (int k = 0; k < 60; ++k)
    spheres.emplace_back(-0.2 * k, Vec4f(1, 1, 1, 0.2f)); // they overlap
  const Film film = Row(spheres).traced();
  EXPECT_NEAR(film.color()[4 * middle + 3], 1.0, 1.0 / 512.0 + 1e-6);
  spheres.resize(12);
  const double alpha = 1.0 - std::pow(0.8, 12);
  expectColor(Row(spheres).traced(), alpha, alpha, alpha, alpha);
}

TEST(Transparency, SidesMayDiffer)
{
  // Two squares one behind the other, seen from the side that they look to, then from behind.
  Triangles squares;
  for (const double z : {0.0, -1.0})
  {
    squares.add({-1.0, -1.0, z}, {1.0, -1.0, z}, {1.0, 1.0, z});
    squares.add({-1.0, -1.0, z}, {1.0, 1.0, z}, {-1.0, 1.0, z});
  }
  Scene scene;
  addTo(scene, objectOf(squares));
  SurfaceObject& object = scene.surfaces[0];
  object.material = {.ambient = 1.0f, .diffuse = 0.0f, .opacity = 0.25f};
  object.coloring.constant = Vec4f(1.0f, 1.0f, 1.0f, 1.0f);
  object.backOpacity = 0.6f;
  const auto alphaFrom = [&](double z)
  {
    const Camera camera = lookAt({0.2, 0.1, z}, Vec3d(0.2, 0.1, 0.0), 5.0);
    return tracedFilm(scene, camera, 5, 5).color()[4 * 12 + 3];
  };
  EXPECT_NEAR(alphaFrom(9.0), 1.0 - 0.75 * 0.75, 1e-6);
  EXPECT_NEAR(alphaFrom(-9.0), 1.0 - 0.4 * 0.4, 1e-6);
  object.material.opacity = 0.0f;
  EXPECT_EQ(alphaFrom(9.0), 0.0f);
  EXPECT_FALSE(pick(scene, {0.2, 0.1, 9.0}, {0.0, 0.0, -1.0}, 0.0, 99.0));
  EXPECT_TRUE(pick(scene, {0.2, 0.1, -9.0}, {0.0, 0.0, 1.0}, 0.0, 99.0));
}
