// Camera rays that go from cell to cell find what rays through structures find.

#include <kernels/hexahedra/CellRuns.h>
#include <kernels/tracing/CloudPicking.h>
#include <kernels/tracing/RayCaster.h>
#include <kernels/tracing/detail/CloudTracer.h>

#include <support/CastOracle.h>
#include <support/Targets.h>
#include <support/Volumes.h>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

constexpr int width = 48, height = 36;

/// Differences of two films' colours.
struct Difference
{
  double most = 0.0, rms = 0.0;
  std::size_t many = 0; ///< pixels that differ by more than asked
  double covered = 0.0; ///< of the expected film, mean opacity
};

std::vector<float> filmOf(const Scene& scene, const Camera& camera, int samples = 1)
{
  Film film;
  film.resize(width, height);
  for (int k = 0; k < samples; ++k)
    EXPECT_TRUE(RayCaster(scene).addSample(camera, film));
  return {film.color(), film.color() + 4 * film.pixels()};
}

Difference difference(
  const std::vector<float>& found, const std::vector<float>& expected, double asked)
{
  Difference d;
  for (std::size_t i = 0; i < found.size(); i += 4)
  {
    double most = 0.0;
    for (std::size_t c = i; c < i + 4; ++c)
    {
      const double off = std::abs(double(found[c]) - double(expected[c]));
      most = off <= most ? most : off; // NaN counts
      d.rms += off * off;
    }
    d.most = most <= d.most ? d.most : most;
    d.many += !(most <= asked);
    d.covered += expected[i + 3];
  }
  d.rms = std::sqrt(d.rms / static_cast<double>(found.size()));
  d.covered /= static_cast<double>(found.size() / 4);
  return d;
}

/// The walk's film against that of rays through the structure.
Difference compared(CloudObject volume, const Camera& camera, double asked, int samples = 1)
{
  Scene scene;
  addWalk(volume);
  scene.clouds = {volume};
  const auto found = filmOf(scene, camera, samples);
  scene.clouds[0].walk = nullptr;
  return difference(found, filmOf(scene, camera, samples), asked);
}

/// An even cloud that lets a fifth through of a ray across its flattest side: what it looks like is
/// how long rays are in it.
CloudObject evenCloud(const std::shared_ptr<const HexMesh>& mesh)
{
  CloudObject volume =
    volumeOf(mesh, std::vector<double>(mesh->pointCount(), 0.0), evenTransfer(0.8f));
  const Vec3d size = mesh->bounds().size();
  volume.transfer.unitDistance = std::min({size.x, size.y, size.z});
  return volume;
}

Camera parallel(Camera camera, double scale)
{
  camera.projection = Camera::Projection::Orthographic;
  camera.parallelScale = scale;
  return camera;
}

/// From outside, perspective and parallel, along axes and aslant; from near by; and from within.
std::vector<Camera> camerasFor(const Box& box)
{
  const Vec3d middle = box.center();
  const double size = glm::length(box.size());
  std::vector<Camera> cameras;
  for (const Vec3d& way : {Vec3d(0, 0, 1), Vec3d(0, -1, 0), Vec3d(1, 0, 0), Vec3d(1.1, 0.7, 1.5),
         Vec3d(-0.3, 1.2, -0.8), Vec3d(-1.5, -0.1, 0.3)})
  {
    Camera camera = lookAt(middle + 1.3 * size * glm::normalize(way), middle, 45.0);
    if (std::abs(glm::normalize(way).y) > 0.99)
      camera.up = Vec3d(0, 0, 1);
    cameras.push_back(camera);
    cameras.push_back(parallel(camera, 0.5 * size));
  }
  cameras.push_back(lookAt(middle + Vec3d(0.3, 0.2, 0.35) * box.size(), middle, 100.0));
  cameras.push_back(lookAt(middle, middle + box.size(), 130.0));
  return cameras;
}

} // namespace

TEST(CellWalk, PathsInTheMeshAreAsLongAsThroughStructures)
{
  auto meshes = unevenMeshes();
  meshes.erase(meshes.begin() + 2); // cells that cross themselves, below
  HexCells thin = hexBlock(5, 5, 5, 0.3);
  thin.move([](const Vec3d& p) { return p * Vec3d(1.0, 1.0, 1e-5); });
  meshes.push_back(thin);
  meshes.push_back(hexBlock(1, 1, 1));
  for (const std::int64_t target : everyTarget())
  {
    SCOPED_TRACE(hwy::TargetName(target));
    const OnlyTargets only(target);
    for (std::size_t m = 0; m < meshes.size(); ++m)
    {
      const auto mesh = meshes[m].mesh();
      const CloudObject volume = evenCloud(mesh);
      const auto cameras = camerasFor(mesh->bounds());
      double covered = 0.0;
      for (std::size_t k = 0; k < cameras.size(); ++k)
      {
        const Difference d = compared(volume, cameras[k], 1e-5);
        EXPECT_EQ(d.many, 0U) << "mesh " << m << " camera " << k << " most " << d.most;
        covered += d.covered;
      }
      EXPECT_GT(covered, 0.5) << "mesh " << m;
    }
  }
}

TEST(CellWalk, CellsInPartsAreAsLongAsTheyAreWhole)
{
  const HexCells block = hexBlock(4, 4, 4, 0.25, 6);
  const std::vector<std::vector<std::size_t>> groups = {
    {0}, {5, 21}, {22, 23}, {26, 42}, {40, 41}, {12, 13, 14}, {51, 55}};
  HexCells barely = hexBlock(3, 3, 3);
  barely.move([](const Vec3d& p) { return p == Vec3d(1.0) ? p + Vec3d(0.37) : p; });
  const std::pair<HexCells, HexCells> pairs[] = {
    {merged(block, groups), block}, {barely, hexBlock(3, 3, 3)}};
  // Faces of six points, sheared so that no ray is parallel to many of them.
  HexCells cells = foam(2);
  cells.move([](const Vec3d& p)
    { return p + Vec3d(0.13 * p.y, 0.07 * p.z, 0.11 * p.x) + 0.02 * Vec3d(wave(p)); });
  const auto sheared = cells.mesh();
  EXPECT_EQ(sheared->report().inParts, 16U);
  for (const Camera& camera : camerasFor(sheared->bounds()))
    EXPECT_EQ(compared(evenCloud(sheared), camera, 1e-5).many, 0U);
  for (const auto& [parts, whole] : pairs)
  {
    const auto mesh = parts.mesh();
    EXPECT_GT(mesh->report().inParts, 0U);
    CloudObject walked = evenCloud(mesh), expected = evenCloud(whole.mesh());
    addWalk(walked);
    expected.sampling.integrator = VolumeIntegrator::CellByCell;
    for (const Camera& camera : camerasFor(mesh->bounds()))
    {
      Scene found, reference;
      found.clouds = {walked};
      reference.clouds = {expected};
      const Difference d = difference(filmOf(found, camera), filmOf(reference, camera), 1e-5);
      EXPECT_EQ(d.many, 0U) << d.most;
    }
  }
}

TEST(CellWalk, CellsThatCrossThemselvesLoseNothingMuch)
{
  // Where a cell is there twice or not at all, spans and walks may tell of different ones.
  const auto mesh = hexBlock(4, 4, 4, 0.9, 5).mesh();
  EXPECT_GT(mesh->report().selfCrossing, 0U);
  for (const Camera& camera : camerasFor(mesh->bounds()))
  {
    const Difference d = compared(evenCloud(mesh), camera, 1e-4);
    EXPECT_LT(d.rms, 3e-2);
  }
}

TEST(CellWalk, PartsApartAndHolesAndOverlapsAreGoneThrough)
{
  // A block without some of its cells; one that slides along it, with other points; a smaller one
  // that reaches into it; and cells given twice.
  const HexCells block = hexBlock(6, 5, 4, 0.2);
  HexCells parts;
  const auto add = [&](const HexCells& cells, const auto& to, const auto& isWanted)
  {
    const auto first = static_cast<std::int64_t>(parts.points.size() / 3);
    for (std::size_t i = 0; i < cells.points.size(); i += 3)
      parts.addPoint(to(Vec3d(cells.points[i], cells.points[i + 1], cells.points[i + 2])));
    for (std::size_t c = 0; c + 1 < cells.offsets.size(); ++c)
    {
      std::vector<std::int64_t> ids;
      for (auto i = cells.offsets[c]; i < cells.offsets[c + 1]; ++i)
        ids.push_back(first + cells.connectivity[static_cast<std::size_t>(i)]);
      if (isWanted(c))
        parts.addCell(HexCellType::Hexahedron, ids);
    }
  };
  const auto all = [](std::size_t) { return true; };
  add(
    block, [](const Vec3d& p) { return p; }, [](std::size_t c) { return c % 7 != 3; });
  add(
    hexBlock(5, 4, 4), [](const Vec3d& p) { return p + Vec3d(6.0, 0.37, -0.21); }, all);
  add(
    hexBlock(3, 3, 3, 0.2), [](const Vec3d& p) { return 0.5 * p + Vec3d(2.0, 4.3, 1.1); }, all);
  add(
    block, [](const Vec3d& p) { return p; }, [](std::size_t c) { return c % 29 == 0; });
  const auto mesh = parts.mesh();
  for (const Camera& camera : camerasFor(mesh->bounds()))
  {
    const Difference d = compared(evenCloud(mesh), camera, 1e-5);
    EXPECT_EQ(d.many, 0U) << d.most;
  }
}

TEST(CellWalk, CloudsMayBePlacedAnyhow)
{
  const auto mesh = hexRing({6, 24, 6, 1.0, 2.0, 1.5, 0.4, 0.3, 3}).mesh();
  CloudObject volume = volumeOf(mesh, pointValues(*mesh, wave), colorful());
  for (const Mat4d& toWorld : {glm::translate(Mat4d(1.0), Vec3d(1e5, 2e5, -3e4)),
         glm::scale(glm::rotate(Mat4d(1.0), 0.7, Vec3d(1, 2, 0.5)), Vec3d(1.0, 0.5, 2.0)),
         glm::scale(Mat4d(1.0), Vec3d(-1.0, 1.0, 1.0)), glm::scale(Mat4d(1.0), Vec3d(1e-6))})
  {
    volume.toWorld = toWorld;
    volume.transfer.unitDistance = 0.6 * scaleOf(toWorld);
    Scene scene;
    scene.clouds = {volume};
    const Camera camera = camerasFor(scene.bounds())[6];
    EXPECT_LT(compared(volume, camera, 1e-3, 2).most, 1e-3);
  }
}

TEST(CellWalk, ErrorsStayBelowTheTolerance)
{
  HexCells uneven = hexBlock(7, 6, 5, 0.25, 3);
  uneven.move([](const Vec3d& p) { return 0.4 * p; });
  for (const auto& mesh : {hexRing({6, 24, 6, 1.0, 2.0, 1.5, 0.4, 0.3, 3}).mesh(), uneven.mesh(),
         hexBlock(3, 3, 3).mesh()})
  {
    CloudObject volume = volumeOf(mesh, pointValues(*mesh, wave), colorful());
    const Camera camera = camerasFor(mesh->bounds())[6];
    Scene exact;
    exact.clouds = {volume};
    exact.clouds[0].sampling.integrator = VolumeIntegrator::CellByCell;
    exact.clouds[0].sampling.tolerance = 1e-7;
    const auto expected = filmOf(exact, camera);
    addWalk(volume);
    for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4})
    {
      Scene scene;
      scene.clouds = {volume};
      scene.clouds[0].sampling.tolerance = tolerance;
      const Difference d = difference(filmOf(scene, camera), expected, tolerance);
      EXPECT_LT(d.most, tolerance);
      EXPECT_LT(d.rms, 0.2 * tolerance);
    }
  }
}

TEST(CellWalk, LinearFieldsInPlaneCellsAreTheAnalyticIntegral)
{
  // Opacity rises from 0 to 0.6 with x: the optical depth is the integral of -log(1 - 0.15 x).
  const auto mesh = hexBlock(4, 5, 5).mesh();
  TransferFunction f;
  f.knots = {{0.0, Vec4f(1, 1, 1, 0)}, {4.0, Vec4f(1, 1, 1, 0.6F)}};
  CloudObject volume = volumeOf(mesh, pointValues(*mesh, [](const Vec3d& p) { return p.x; }), f);
  addWalk(volume);
  Scene scene;
  scene.clouds = {volume};
  const Camera camera = parallel(lookAt({-9.0, 2.5, 2.5}, {0.0, 2.5, 2.5}), 1.0);
  const double k = double(0.6F) / 4.0, b = 1.0 - 4.0 * k;
  const double exact = 1.0 - std::exp(-(b * std::log(b) - b + 1.0) / k);
  const auto film = filmOf(scene, camera);
  for (std::size_t i = 0; i < film.size(); ++i)
    ASSERT_NEAR(film[i], exact, 2e-5);
}

TEST(CellWalk, ValuesOfCellsAndNaNAndSolidAndLitCloudsAreAsThroughStructures)
{
  const auto mesh = hexRing({6, 24, 6, 1.0, 2.0, 1.5, 0.4, 0.3, 3}).mesh();
  const Camera camera = camerasFor(mesh->bounds())[6];
  std::vector<double> ofCells;
  for (std::size_t c = 0; c < mesh->cellCount(); ++c)
    ofCells.push_back(c % 17 == 0 ? NAN : wave(cellCenter(mesh->corners(c))));
  CloudObject volume = volumeOf(mesh, ofCells, colorful(), HexStructureKind::CartesianBvh, true);
  volume.transfer.nan = Vec4f(1, 0, 1, 0.3f);
  EXPECT_LT(compared(volume, camera, 1e-4).most, 1e-4);

  std::vector<double> values = pointValues(*mesh, wave);
  for (std::size_t i = 0; i < values.size(); i += 41)
    values[i] = NAN;
  volume = volumeOf(mesh, values, colorful());
  volume.transfer.nan = Vec4f(1, 0, 1, 0.3f);
  EXPECT_LT(compared(volume, camera, 1e-3).most, 1e-3);

  volume = volumeOf(mesh, pointValues(*mesh, wave), colorful());
  volume.transfer.knots[5].color.w = 1.0f; // solid from 0.5 to 0.8
  volume.transfer.knots.insert(volume.transfer.knots.begin() + 6, {0.8, Vec4f(1, 0.5f, 0, 1)});
  EXPECT_LT(compared(volume, camera, 1e-3).most, 1e-3);

  volume = volumeOf(mesh, pointValues(*mesh, wave), colorful());
  volume.shade = true;
  EXPECT_LT(compared(volume, camera, 1e-3).most, 1e-3);
}

TEST(CellWalk, RaysEndAtLimitsAndGoOnBehindWhatLetsThemThrough)
{
  const auto mesh = hexRing({6, 24, 6, 1.0, 2.0, 1.5, 0.4, 0.3, 3}).mesh();
  Scene scene;
  scene.clouds = {volumeOf(mesh, pointValues(*mesh, wave), colorful())};
  CloudObject other = scene.clouds[0];
  other.toWorld = glm::translate(Mat4d(1.0), Vec3d(0.4, 0.3, -0.5));
  scene.surfaces = {isoSurfacesOf(other, {0.4})};
  scene.surfaces[0].material.opacity = 0.5f;
  other.toWorld = glm::translate(Mat4d(1.0), Vec3d(0.4, 0.3, -2.5));
  scene.clouds.push_back(other); // one behind the other
  for (CloudObject& cloud : scene.clouds)
  {
    addWalk(cloud);
    cloud.sampling.tolerance = 1e-4;
  }
  std::vector<float> limits(width * height, INFINITY);
  for (std::size_t i = 0; i < limits.size(); i += 3)
    limits[i] = 3.0f + 0.002f * static_cast<float>(i);
  for (const Camera& camera : {camerasFor(mesh->bounds())[6], camerasFor(mesh->bounds())[13]})
  {
    const auto film = [&]
    {
      Film film;
      film.resize(width, height);
      RayCaster caster(scene);
      caster.setLimits(limits.data());
      for (int k = 0; k < 2; ++k)
        EXPECT_TRUE(caster.addSample(camera, film));
      return std::vector<float>(film.color(), film.color() + 4 * film.pixels());
    };
    std::vector<std::shared_ptr<const WalkCells>> walks;
    const auto found = film();
    for (CloudObject& cloud : scene.clouds)
      walks.push_back(std::exchange(cloud.walk, nullptr));
    const Difference d = difference(found, film(), 1e-3);
    EXPECT_LT(d.most, 1e-3);
    for (std::size_t k = 0; k < walks.size(); ++k)
      scene.clouds[k].walk = walks[k];
  }
}

TEST(CellWalk, CloudsBetweenPartsOfAnotherAreMetInOrder)
{
  // Red at both ends of a block and nothing between, where a green block stands.
  const auto mesh = hexBlock(12, 3, 3, 0.2).mesh();
  TransferFunction ends;
  ends.knots = {{2.0, Vec4f(0.0f)}, {2.1, Vec4f(1, 0, 0, 0.3f)}};
  TransferFunction green;
  green.knots = {{0.0, Vec4f(0, 1, 0, 0.3f)}};
  Scene scene;
  scene.clouds.push_back(
    volumeOf(mesh, pointValues(*mesh, [](const Vec3d& p) { return std::abs(p.x - 6.0); }), ends));
  const auto small = hexBlock(3, 3, 3, 0.2).mesh();
  scene.clouds.push_back(volumeOf(small, std::vector<double>(small->pointCount(), 0.0), green));
  scene.clouds[1].toWorld = glm::translate(Mat4d(1.0), Vec3d(4.5, 0.0, 0.0));
  for (CloudObject& cloud : scene.clouds)
  {
    addWalk(cloud);
    cloud.sampling.tolerance = 1e-4;
  }
  Scene other = scene;
  for (CloudObject& cloud : other.clouds)
    cloud.walk = nullptr;
  for (const auto& [eye, focus] : {std::pair(Vec3d(-12, 1.4, 1.6), Vec3d(6, 1.5, 1.5)),
         std::pair(Vec3d(25, 1.4, 1.6), Vec3d(6, 1.5, 1.5)),
         std::pair(Vec3d(1.2, 1.4, 1.6), Vec3d(6, 1.5, 1.5)),
         std::pair(Vec3d(6.2, 1.4, 1.6), Vec3d(12, 1.5, 1.5))})
  {
    const Camera camera = lookAt(eye, focus, 20.0);
    const auto expected = filmOf(other, camera);
    const Difference d = difference(filmOf(scene, camera), expected, 1e-3);
    EXPECT_LT(d.most, 1e-3) << eye.x;
    EXPECT_GT(d.covered, 0.1) << eye.x;
  }
}

TEST(CellWalk, ViewsAreMadeOnceForTheSameCamera)
{
  const auto mesh = hexBlock(5, 5, 5, 0.3).mesh();
  CloudObject volume = evenCloud(mesh);
  addWalk(volume);
  const auto cameras = camerasFor(mesh->bounds());
  const auto viewOf = [&](std::size_t camera, int columns)
  {
    const CameraRays rays(cameras[camera], columns, height);
    return volume.walk->views().view(*volume.walk, rays, columns, height);
  };
  const auto first = viewOf(0, width);
  EXPECT_EQ(viewOf(0, width), first);
  EXPECT_NE(viewOf(0, 2 * width), first);
  EXPECT_EQ(viewOf(0, width), first) << "two are kept";
  EXPECT_NE(viewOf(2, width), first);
  EXPECT_NE(viewOf(4, width), first);
  EXPECT_NE(viewOf(0, width), first) << "no more than two";
}

TEST(CellWalk, FilmsDoNotDependOnBundlesOrThreads)
{
  const auto mesh = hexBlock(6, 5, 4, 0.3).mesh();
  CloudObject volume = volumeOf(mesh, pointValues(*mesh, wave), colorful());
  addWalk(volume);
  Scene scene;
  scene.clouds = {volume};
  const Camera camera = camerasFor(mesh->bounds())[6];
  const auto expected = filmOf(scene, camera);
  for (const int side : {2, 4, 8, 16})
  {
    Film film;
    film.resize(width, height);
    RayCaster caster(scene);
    caster.setThreads(1);
    caster.setBundleSide(side);
    EXPECT_TRUE(caster.addSample(camera, film));
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), film.color()));
  }
}

TEST(CellRuns, FindTheCellsThatAllWouldBeAskedFor)
{
  for (const auto& mesh : {hexBlock(9, 7, 8, 0.3).mesh(), foam(3).mesh()})
  {
    const CellRuns runs(*mesh);
    EXPECT_LT(double(runs.bytes()), 1.0 * double(mesh->cellCount()) + sizeof(Box));
    const Vec3d middle = 0.5 * (mesh->bounds().lower + mesh->bounds().upper);
    std::size_t met = 0;
    for (int i = 0; i < 300; ++i)
    {
      const double a = 0.7 * i, b = 0.13 * i;
      HexRay ray;
      ray.direction = {std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)};
      if (i % 10 == 0)
        ray.direction = {0.0, 0.0, 2.0}; // along cells' faces at times
      ray.origin = middle + 0.3 * Vec3d(i % 7 - 3, i % 5 - 2, i % 3 - 1) - 9.0 * ray.direction;
      ray.tMin = i % 4 == 0 ? 8.5 : 0.0;
      ray.tMax = i % 3 == 0 ? 9.5 : INFINITY;
      const auto spans = runs.spansOf(*mesh, ray);
      EXPECT_EQ(spans, allSpans(*mesh, ray)) << i;
      met += spans.size();
    }
    EXPECT_GT(met, 1000U);
  }
}

TEST(CellRuns, PicksWithoutAStructureAreTheSame)
{
  const auto mesh = hexBlock(9, 7, 8, 0.3).mesh();
  CloudObject volume = volumeOf(mesh, pointValues(*mesh, wave), colorful());
  addWalk(volume);
  Scene scene, bare;
  scene.clouds = {volume};
  bare.clouds = {volume};
  bare.clouds[0].structure = nullptr;
  int picked = 0;
  for (int i = 0; i < 200; ++i)
  {
    const Vec3d origin(i % 11 - 0.5, i % 9 - 0.5, -5.0),
      direction(0.02 * (i % 13), 0.01 * (i % 7), 1);
    const auto with = pickCloud(scene, origin, direction, 0.0, 100.0);
    const auto without = pickCloud(bare, origin, direction, 0.0, 100.0);
    ASSERT_EQ(with.has_value(), without.has_value()) << i;
    if (!with)
      continue;
    ++picked;
    EXPECT_EQ(with->cell, without->cell);
    EXPECT_EQ(with->t, without->t);
    EXPECT_EQ(with->value, without->value);
    EXPECT_EQ(with->opacity, without->opacity);
  }
  EXPECT_GT(picked, 100);
}
