// What is seen of a mesh with hidden cells is what is seen of the mesh without them.

#include <kernels/hexahedra/IsoSurface.h>
#include <kernels/tracing/CloudPicking.h>
#include <kernels/tracing/RayCaster.h>

#include <support/CastOracle.h>
#include <support/Structure.h>
#include <support/Volumes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

/// A mesh, which of its cells are seen, and the mesh of those alone.
struct Pair
{
  std::shared_ptr<const HexMesh> whole, rest;
  std::vector<unsigned char> isVisible;
  std::vector<std::size_t> kept; ///< cells of the whole that the rest has
  std::shared_ptr<const HiddenCells> hidden;
};

template <typename IsVisible>
Pair pairOf(const HexCells& cells, const IsVisible& isVisible)
{
  Pair pair;
  pair.whole = cells.mesh();
  HexCells rest;
  rest.points = cells.points;
  for (std::size_t c = 0; c < cells.types.size(); ++c)
  {
    pair.isVisible.push_back(isVisible(c) ? 1 : 0);
    if (!isVisible(c))
      continue;
    pair.kept.push_back(c);
    rest.addCell(HexCellType(cells.types[c]),
      std::vector<std::int64_t>(cells.connectivity.begin() + cells.offsets[c],
        cells.connectivity.begin() + cells.offsets[c + 1]));
  }
  pair.rest = rest.mesh();
  pair.hidden = std::make_shared<HiddenCells>(*pair.whole, pair.isVisible.data());
  return pair;
}

/// Every third cell hidden at random; a layer; and nearly all.
std::vector<Pair> pairs()
{
  const auto atRandom = [](std::size_t c) { return (c * 2654435761U >> 7) % 3 != 0; };
  const auto inLayers = [](std::size_t c) { return c / 36 % 2 == 0; };
  const auto few = [](std::size_t c) { return c % 23 == 5; };
  HexCells ring = hexRing({6, 24, 6, 1.0, 2.0, 1.5, 0.4, 0.3, 3});
  const HexCells block = hexBlock(6, 6, 5, 0.25, 3);
  std::vector<Pair> all = {pairOf(block, atRandom), pairOf(block, inLayers), pairOf(block, few),
    pairOf(ring, atRandom), pairOf(ring, few)};
  for (const Pair& pair : all)
    EXPECT_GT(pair.kept.size(), 3U);
  return all;
}

CloudObject cloudOf(
  const std::shared_ptr<const HexMesh>& mesh, HexStructureKind kind, VolumeIntegrator integrator)
{
  CloudObject cloud = volumeOf(mesh, pointValues(*mesh, wave), colorful(), kind);
  cloud.sampling.integrator = integrator;
  cloud.sampling.step = 0.05; // else by the mean cell
  cloud.sampling.tolerance = 1e-6;
  return cloud;
}

std::vector<float> filmOf(const CloudObject& cloud, const Camera& camera)
{
  Scene scene;
  scene.clouds = {cloud};
  Film film;
  film.resize(48, 36);
  EXPECT_TRUE(RayCaster(scene).addSample(camera, film));
  return {film.color(), film.color() + 4 * film.pixels()};
}

double mostBetween(const std::vector<float>& a, const std::vector<float>& b)
{
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    most = std::max(most, std::abs(double(a[i]) - double(b[i])));
  return most;
}

/// Rays through a mesh from all sides.
std::vector<HexRay> raysFor(const HexMesh& mesh)
{
  const Vec3d size = mesh.bounds().size();
  const auto from = randomPoints(200, mesh.bounds().lower - size, mesh.bounds().upper + size, 4);
  const auto to = randomPoints(200, mesh.bounds().lower, mesh.bounds().upper, 5);
  std::vector<HexRay> rays;
  for (std::size_t i = 0; i < from.size(); ++i)
    rays.push_back({from[i], 3.0 * (to[i] - from[i])});
  return rays;
}

Camera cameraFor(const HexMesh& mesh)
{
  const Box box = mesh.bounds();
  return lookAt(box.center() + 1.2 * glm::length(box.size()) * glm::normalize(Vec3d(1.1, 0.7, 1.5)),
    box.center(), 45.0);
}

} // namespace

TEST(HiddenCells, IntegralsAreThoseOfTheMeshWithoutThem)
{
  for (const Pair& pair : pairs())
    for (const HexStructureKind kind : hexKinds)
      for (const auto integrator : {VolumeIntegrator::InverseDistance, VolumeIntegrator::Trilinear,
             VolumeIntegrator::CellByCell})
      {
        CloudObject masked = cloudOf(pair.whole, kind, integrator);
        const CloudObject rest = cloudOf(pair.rest, kind, integrator), whole = masked;
        masked.hidden = pair.hidden;
        double seen = 0.0, other = 0.0;
        for (const HexRay& ray : raysFor(*pair.whole))
        {
          const RayColor found = gathered(masked, ray.origin, ray.direction);
          const RayColor expected = gathered(rest, ray.origin, ray.direction);
          ASSERT_NEAR(found.transmittance, expected.transmittance, 1e-5);
          for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(found.color[c], expected.color[c], 1e-5);
          seen += 1.0 - expected.transmittance;
          other += 1.0 - gathered(whole, ray.origin, ray.direction).transmittance;
        }
        EXPECT_GT(seen, 0.1);
        EXPECT_LT(seen, 0.95 * other);
      }
}

TEST(HiddenCells, BundlesAndWalksAgree)
{
  for (const Pair& pair : pairs())
  {
    const Camera camera = cameraFor(*pair.whole);
    const auto kind = HexStructureKind::CartesianBvh;
    CloudObject masked = cloudOf(pair.whole, kind, VolumeIntegrator::CellByCell);
    const CloudObject rest = cloudOf(pair.rest, kind, VolumeIntegrator::CellByCell);
    const auto whole = filmOf(masked, camera), expected = filmOf(rest, camera);
    masked.hidden = pair.hidden;
    EXPECT_LT(mostBetween(filmOf(masked, camera), expected), 1e-5);
    EXPECT_GT(mostBetween(whole, expected), 0.05);

    // The walk goes through the hidden, lit or not, solid or not.
    masked.sampling.tolerance = 1e-4;
    addWalk(masked);
    EXPECT_LT(mostBetween(filmOf(masked, camera), expected), 3e-4);
    CloudObject reference = rest; // which walks, too: lit edges are where both are least exact
    reference.sampling.tolerance = 1e-4;
    addWalk(reference);
    for (CloudObject* cloud : {&masked, &reference})
      cloud->shade = true;
    EXPECT_LT(mostBetween(filmOf(masked, camera), filmOf(reference, camera)), 2e-4);
    for (CloudObject* cloud : {&masked, &reference})
    {
      auto& knots = cloud->transfer.knots;
      knots[5].color.w = 1.0f; // solid from 0.5 to 0.8
      knots.insert(knots.begin() + 6, {0.8, Vec4f(1, 0.5f, 0, 1)});
    }
    EXPECT_LT(mostBetween(filmOf(masked, camera), filmOf(reference, camera)), 2e-4);
  }
}

TEST(HiddenCells, NumbersThatAreNoneAndValuesOfCellsMayBeHidden)
{
  const HexCells cells = hexBlock(6, 6, 5, 0.25, 3);
  const Pair pair = pairOf(cells, [](std::size_t c) { return c % 4 != 1; });
  std::vector<double> values;
  for (std::size_t c = 0; c < cells.types.size(); ++c)
    values.push_back(c % 4 == 1 ? NAN : wave(cellCenter(pair.whole->corners(c))));
  std::vector<double> kept;
  for (const std::size_t c : pair.kept)
    kept.push_back(values[c]);
  TransferFunction look = colorful();
  look.nan = Vec4f(1, 0, 1, 0.9f);
  const auto kind = HexStructureKind::CartesianBvh;
  CloudObject masked = volumeOf(pair.whole, values, look, kind, true);
  CloudObject rest = volumeOf(pair.rest, kept, look, kind, true);
  masked.hidden = pair.hidden;
  addWalk(masked);
  addWalk(rest);
  const Camera camera = cameraFor(*pair.whole);
  EXPECT_LT(mostBetween(filmOf(masked, camera), filmOf(rest, camera)), 1e-4);
}

TEST(HiddenCells, HaveNoIsoSurfacesAndAreNotPicked)
{
  for (const Pair& pair : pairs())
  {
    const auto kind = HexStructureKind::CartesianBvh;
    CloudObject masked = cloudOf(pair.whole, kind, VolumeIntegrator::CellByCell);
    const CloudObject rest = cloudOf(pair.rest, kind, VolumeIntegrator::CellByCell);
    masked.hidden = pair.hidden;
    const std::vector<double> values = {0.1, -0.3};
    const IsoSurface found(masked.structure, masked.field, values, masked.hidden);
    const IsoSurface expected(rest.structure, rest.field, values);
    Scene maskedScene, restScene;
    maskedScene.clouds = {masked};
    restScene.clouds = {rest};
    int hits = 0, picks = 0;
    for (const HexRay& ray : raysFor(*pair.whole))
    {
      const auto a = found.first(ray), b = expected.first(ray);
      ASSERT_EQ(a.has_value(), b.has_value());
      if (a)
      {
        ++hits;
        EXPECT_NEAR(a->t, b->t, 1e-9);
        EXPECT_EQ(pair.isVisible[pair.whole->inputCell(a->cell)], 1);
      }
      const auto p = pickCloud(maskedScene, ray.origin, ray.direction, 0.0, INFINITY);
      const auto q = pickCloud(restScene, ray.origin, ray.direction, 0.0, INFINITY);
      ASSERT_EQ(p.has_value(), q.has_value());
      if (p)
      {
        ++picks;
        EXPECT_EQ(p->cell, pair.kept[q->cell]);
      }
    }
    EXPECT_GT(hits, 3);
    EXPECT_GT(picks, 10);
  }
}
