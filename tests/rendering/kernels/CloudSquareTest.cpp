// Squares of pixels of which only some are traced.

#include "SceneParts.h"

#include <kernels/tracing/RayCaster.h>
#include <kernels/tracing/detail/CloudSquare.h>

#include <support/CastOracle.h>
#include <support/Volumes.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

RayColor grey(double value)
{
  return {Vec3d(value), 1.0 - value};
}

template <typename Image>
CloudSquare::Trace oneByOne(const Image& image)
{
  return [image](const CloudSquare::Pixel* pixels, int count, RayColor* colors)
  {
    EXPECT_GE(count, 1);
    EXPECT_LE(count, CloudSquare::mostPixels);
    for (int i = 0; i < count; ++i)
      colors[i] = image(pixels[i].x, pixels[i].y);
  };
}

} // namespace

TEST(CloudSquare, OfABilinearImageIsExactFromFewRays)
{
  for (const int side : {8, 16, 32})
  {
    int traced = 0;
    const auto image = [](int x, int y) { return 0.1 + 0.02 * x + 0.01 * y + 0.001 * x * y; };
    const CloudSquare square(side, 1e-9,
      oneByOne(
        [&](int x, int y)
        {
          ++traced;
          return grey(image(x, y));
        }));
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
        EXPECT_NEAR(square(x, y).color.x, image(x, y), 1e-12);
    EXPECT_EQ(traced, side == 8 ? 5 : side == 16 ? 9 : 25); // neighbours share what lies between
  }
}

TEST(CloudSquare, WhatIsTracedIsKeptAndAnEdgeIsFollowed)
{
  for (const int side : {16, 32})
  {
    int traced = 0;
    bool at[33][33] = {};
    const auto image = [](int x, int y) { return x + 2 * y > 21 ? 1.0 : 0.0; };
    const CloudSquare square(side, 0.01,
      oneByOne(
        [&](int x, int y)
        {
          ++traced;
          EXPECT_FALSE(at[y][x]); // none twice
          at[y][x] = true;
          return grey(image(x, y));
        }));
    int wrong = 0;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
      {
        const double off = std::abs(square(x, y).color.x - image(x, y));
        if (at[y][x])
        {
          EXPECT_EQ(off, 0.0);
        }
        wrong += off > 0.01;
      }
    EXPECT_LT(traced, 250);
    EXPECT_LE(wrong, 15);
  }
}

TEST(CloudSquare, RaysAreAskedForTogether)
{
  int asked = 0, traced = 0;
  const CloudSquare square(32, 1e-9,
    [&](const CloudSquare::Pixel* pixels, int count, RayColor* colors)
    {
      ++asked;
      traced += count;
      for (int i = 0; i < count; ++i)
        colors[i] = grey(
          std::pow(pixels[i].x / 32.0, 2.3) + std::pow(pixels[i].y / 32.0, 1.7)); // nowhere even
    });
  EXPECT_EQ(traced, 33 * 33);
  EXPECT_LE(asked, 9);
}

TEST(CloudSquare, InAFilmKeepsToTheToleranceWhereItIsSmooth)
{
  HexCells cells = hexBlock(6, 6, 6);
  cells.move([](const Vec3d& p) { return p - Vec3d(3.0); });
  const auto mesh = cells.mesh();
  TransferFunction f;
  f.knots = {{-3.0, Vec4f(1, 0, 0, 0.05F)}, {3.0, Vec4f(0, 1, 1, 0.4F)}};
  Scene scene;
  scene.clouds.push_back(
    volumeOf(mesh, pointValues(*mesh, [](const Vec3d& p) { return p.x - 0.3 * p.y; }), f));
  scene.clouds[0].sampling.integrator = VolumeIntegrator::CellByCell;
  const Camera camera = lookAt({3, 2, 14}, Vec3d(0.0), 15.0); // within its outline
  const auto traced = [&](double tolerance)
  {
    scene.cloudTolerance = tolerance;
    Film film;
    film.resize(90, 75); // no whole number of squares
    EXPECT_TRUE(RayCaster(scene).addSample(camera, film));
    return film;
  };
  const Film exact = traced(0.0);
  for (const double tolerance : {1e-3, 1e-2})
  {
    const Film film = traced(tolerance);
    double worst = 0.0;
    for (std::size_t i = 0; i < 4 * film.pixels(); ++i)
      worst = std::max(worst, std::abs(double(film.color()[i]) - double(exact.color()[i])));
    EXPECT_GT(worst, 0.0);
    EXPECT_LT(worst, 2.0 * tolerance);
  }
}

TEST(CloudSquare, SurfacesAreTracedRayByRay)
{
  HexCells cells = hexBlock(6, 6, 6);
  cells.move([](const Vec3d& p) { return p - Vec3d(3.0); });
  const auto mesh = cells.mesh();
  Scene scene;
  scene.clouds.push_back(
    volumeOf(mesh, std::vector<double>(mesh->pointCount(), 1.0), evenTransfer(0.2F)));
  Particles particles;
  particles.add(Vec3d(0.0), 1.0);
  addTo(scene, objectOf(particles));
  const Camera camera = lookAt({0, 0, 30}, Vec3d(0.0), 6.0);
  Film film[2];
  for (int k = 0; k < 2; ++k)
  {
    scene.cloudTolerance = 0.5 * k;
    film[k].resize(16, 16);
    EXPECT_TRUE(RayCaster(scene).addSample(camera, film[k]));
  }
  for (std::size_t i = 0; i < 4 * film[0].pixels(); ++i)
    EXPECT_EQ(film[0].color()[i], film[1].color()[i]);
}
