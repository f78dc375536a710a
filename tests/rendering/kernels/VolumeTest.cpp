// What rays gather of a volume.

#include <kernels/core/Error.h>
#include <kernels/tracing/detail/CloudTracer.h>

#include <support/Structure.h>
#include <support/Volumes.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace mote;
using namespace mote::testing;

namespace
{

constexpr VolumeIntegrator integrators[] = {
  VolumeIntegrator::InverseDistance, VolumeIntegrator::Trilinear, VolumeIntegrator::CellByCell};

const RingShape twisted{6, 24, 6, 1.0, 2.0, 1.5, 0.4, 0.3, 3};

/// Rays from all around through the middle region of a mesh.
template <typename Visit>
void forRays(const HexMesh& mesh, int count, unsigned seed, const Visit& visit)
{
  const Box box = mesh.bounds();
  const auto from = randomPoints(static_cast<std::size_t>(count), box.center() - 2.0 * box.size(),
    box.center() + 2.0 * box.size(), seed);
  const auto to = randomPoints(static_cast<std::size_t>(count), box.lower, box.upper, seed + 1);
  for (std::size_t i = 0; i < from.size(); ++i)
    visit(from[i], to[i] - from[i]);
}

double largestDifference(const RayColor& a, const RayColor& b)
{
  const Vec3d d = glm::abs(a.color - b.color);
  return std::max({d.x, d.y, d.z, std::abs(a.transmittance - b.transmittance)});
}

} // namespace

TEST(Volume, AnEvenFieldIsItsChordWhateverTheMesh)
{
  HexCells far = hexRing(twisted);
  far.move([](const Vec3d& p) { return p + Vec3d(1e6, -1e6, 2e6); });
  HexCells thin = hexBlock(5, 5, 5, 0.3);
  thin.move([](const Vec3d& p) { return p * Vec3d(1.0, 1.0, 1e-5); });
  for (const auto& mesh :
    {hexBlock(6, 5, 4, 0.3).mesh(), hexRing(twisted).mesh(), far.mesh(), thin.mesh()})
    for (const VolumeIntegrator integrator : integrators)
    {
      CloudObject volume =
        volumeOf(mesh, std::vector<double>(mesh->pointCount(), 7.0), evenTransfer(0.3F));
      const double size = glm::length(mesh->bounds().size());
      volume.transfer.unitDistance = 0.2 * size;
      volume.sampling.integrator = integrator;
      volume.sampling.step = 0.013 * size;
      const double perLength = -std::log1p(-double(0.3F)) / volume.transfer.unitDistance;
      int met = 0;
      forRays(*mesh, 60, 5,
        [&](const Vec3d& from, const Vec3d& way)
        {
          double chord = 0.0;
          for (const CellSpan& span : allSpans(*mesh, {from, way}))
            chord += (span.tOut - span.tIn) * glm::length(way);
          const RayColor color = gathered(volume, from, way);
          EXPECT_NEAR(opticalDepth(color), perLength * chord, 1e-6 * perLength * chord + 1e-13);
          EXPECT_NEAR(color.color.y, 1.0 - color.transmittance, 1e-9);
          met += chord > 0.0;
        });
      EXPECT_GT(met, 15);
    }
}

TEST(Volume, InvertedConcaveAndCollapsedCellsAreTheirVolume)
{
  // The even-field integral over many parallel rays is the volume, found by Gauss' rule.
  HexCells mixed;
  const auto add = [&](HexCellType type, std::vector<Vec3d> corners, double x)
  {
    for (Vec3d& c : corners)
      c.x += x;
    mixed.addCell(type, corners);
  };
  const std::vector<Vec3d> hex = {
    {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  std::vector<Vec3d> inverted = {hex[4], hex[5], hex[6], hex[7], hex[0], hex[1], hex[2], hex[3]};
  std::vector<Vec3d> concave = hex, flat = hex;
  concave[6] = Vec3d(0.45, 0.45, 0.8); // beyond the diagonal of its faces
  for (Vec3d& c : flat)
    c.z = 0.0;
  add(HexCellType::Hexahedron, inverted, 0.0);
  add(HexCellType::Hexahedron, concave, 2.0);
  add(HexCellType::Wedge, {hex[0], hex[3], hex[1], hex[4], hex[7], hex[5]}, 4.0);
  add(HexCellType::Pyramid, {hex[0], hex[1], hex[2], hex[3], {0.5, 0.5, 1.0}}, 6.0);
  add(HexCellType::Tetrahedron, {hex[0], hex[1], hex[3], hex[4]}, 8.0);
  add(HexCellType::Hexahedron, flat, 10.0); // no volume: left out
  const auto mesh = mixed.mesh();
  EXPECT_EQ(mesh->report().zeroVolume, 1U);
  EXPECT_EQ(mesh->report().inverted, 1U);
  for (const VolumeIntegrator integrator : integrators)
  {
    CloudObject volume =
      volumeOf(mesh, std::vector<double>(mesh->pointCount(), 2.0), evenTransfer(0.5F));
    volume.sampling.integrator = integrator;
    volume.sampling.step = 0.01;
    const int n = 40;
    double sum = 0.0;
    for (int x = 0; x < 12 * n; ++x)
      for (int y = 0; y < n; ++y)
        sum +=
          opticalDepth(gathered(volume, {(x + 0.5) / n, (y + 0.5) / n, -2.0}, {0.0, 0.0, 1.0}));
    EXPECT_NEAR(sum / (n * n) / std::log(2.0), mesh->report().volume, 0.01);
  }
}

TEST(Volume, TheStepOfSamplesDoesNotChangeAnEvenField)
{
  const auto mesh = hexBlock(4, 4, 4, 0.2).mesh();
  CloudObject volume =
    volumeOf(mesh, std::vector<double>(mesh->pointCount(), 1.0), evenTransfer(0.2F));
  for (const double step : {1e-300, 1e-3, 0.1, 0.77, 3.0, 100.0})
  {
    volume.sampling.step = step;
    const RayColor color = gathered(volume, {2.1, 1.9, -3.0}, {0.0, 0.0, 1.0});
    EXPECT_NEAR(color.transmittance, std::pow(1.0 - double(0.2F), 4.0), 1e-12) << step;
  }
}

TEST(Volume, ALinearFieldIsTheAnalyticIntegral)
{
  // Opacity rises from 0 to 0.6 with x: the optical depth is the integral of -log(1 - 0.15 x).
  HexCells cells = hexBlock(4, 5, 5);
  const double angle = 10.0 * M_PI / 180.0; // each layer is turned against the next
  cells.move(
    [&](const Vec3d& p)
    {
      const double a = angle * p.x, y = p.y - 2.5, z = p.z - 2.5;
      return Vec3d(
        p.x, 2.5 + y * std::cos(a) - z * std::sin(a), 2.5 + y * std::sin(a) + z * std::cos(a));
    });
  const auto mesh = cells.mesh();
  TransferFunction f;
  f.knots = {{0.0, Vec4f(1, 1, 1, 0)}, {4.0, Vec4f(1, 1, 1, 0.6F)}};
  CloudObject volume = volumeOf(mesh, pointValues(*mesh, [](const Vec3d& p) { return p.x; }), f);
  const double k = double(0.6F) / 4.0, b = 1.0 - 4.0 * k;
  const double exact = (b * std::log(b) - b + 1.0) / k;
  volume.sampling.integrator = VolumeIntegrator::CellByCell;
  volume.sampling.tolerance = 1e-7;
  EXPECT_NEAR(opticalDepth(gathered(volume, {-1.0, 2.6, 2.3}, {1, 0, 0})), exact, 1e-6);
  volume.sampling.integrator = VolumeIntegrator::Trilinear;
  double before = 1.0;
  for (const double step : {0.4, 0.2, 0.1, 0.05})
  {
    volume.sampling.step = step;
    const double error =
      std::abs(opticalDepth(gathered(volume, {-1.0, 2.6, 2.3}, {1, 0, 0})) - exact);
    EXPECT_LT(error, 0.3 * before); // of second order
    before = error;
  }
  EXPECT_LT(before, 1e-4);
}

TEST(Volume, LinearFieldsAreExactInTwistedCells)
{
  // 10-degree twisted cells: what is sampled is the field itself.
  const auto mesh = hexRing(twisted).mesh();
  const auto linear = [](const Vec3d& p) { return 0.3 * p.x - 0.4 * p.y + 0.7 * p.z; };
  const CloudObject volume = volumeOf(mesh, pointValues(*mesh, linear), colorful());
  const double range = volume.field->upper() - volume.field->lower();
  CellSampler sampler(*mesh, *volume.field);
  int sampled = 0;
  forRays(*mesh, 200, 11,
    [&](const Vec3d& from, const Vec3d& way)
    {
      for (const CellSpan& span : allSpans(*mesh, {from, way}))
        for (const double share : {0.0, 0.3, 0.5, 1.0})
        {
          const Vec3d p = from + (span.tIn + share * (span.tOut - span.tIn)) * way;
          sampler.enter(span.cell);
          EXPECT_NEAR(volume.field->offset() + sampler.trilinear(p), linear(p), 1e-6 * range);
          ++sampled;
        }
    });
  EXPECT_GT(sampled, 2000);
}

TEST(Volume, CellByCellKeepsItsTolerance)
{
  for (const auto& mesh : {hexRing(twisted).mesh(), hexBlock(5, 5, 5, 0.35).mesh()})
  {
    CloudObject volume = volumeOf(mesh, pointValues(*mesh, wave), colorful());
    volume.sampling.integrator = VolumeIntegrator::CellByCell;
    std::vector<std::pair<Vec3d, Vec3d>> rays;
    std::vector<RayColor> exact;
    forRays(*mesh, 60, 17,
      [&](const Vec3d& from, const Vec3d& way)
      {
        rays.emplace_back(from, way);
        exact.push_back(gatheredByDefinition(volume, from, way, 0.0, INFINITY, 4000));
      });
    for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4})
    {
      volume.sampling.tolerance = tolerance;
      double worst = 0.0;
      for (std::size_t i = 0; i < rays.size(); ++i)
        worst = std::max(
          worst, largestDifference(gathered(volume, rays[i].first, rays[i].second), exact[i]));
      EXPECT_LE(worst, tolerance);
      EXPECT_GT(worst, 0.0);
    }
  }
}

TEST(Volume, EvenSamplesTendToTheDefinition)
{
  const auto mesh = hexRing(twisted).mesh();
  CloudObject volume = volumeOf(mesh, pointValues(*mesh, wave), colorful());
  double last = 1.0;
  for (const double step : {0.1, 0.02, 0.004})
  {
    volume.sampling.step = step;
    double sum = 0.0;
    forRays(*mesh, 40, 19,
      [&](const Vec3d& from, const Vec3d& way)
      {
        sum += std::pow(largestDifference(gathered(volume, from, way),
                          gatheredByDefinition(volume, from, way, 0.0, INFINITY)),
          2.0);
      });
    EXPECT_LT(sum, 0.2 * last) << step;
    last = sum;
  }
}

TEST(Volume, EveryStructureGathersTheSame)
{
  const auto mesh = hexRing(twisted).mesh();
  for (const VolumeIntegrator integrator : integrators)
    forRays(*mesh, 60, 23,
      [&](const Vec3d& from, const Vec3d& way)
      {
        std::vector<RayColor> colors;
        for (const HexStructureKind kind : hexKinds)
        {
          CloudObject volume = volumeOf(mesh, pointValues(*mesh, wave), evenTransfer(0.4F), kind);
          volume.sampling.integrator = integrator;
          colors.push_back(gathered(volume, from, way));
        }
        for (const RayColor& color : colors)
        {
          EXPECT_EQ(color.transmittance, colors[0].transmittance);
          EXPECT_EQ(color.color, colors[0].color);
        }
      });
}

TEST(Volume, WhatCannotBeSeenIsSkippedAndNothingElse)
{
  const auto mesh = hexRing({8, 64, 8}).mesh();
  TransferFunction f;
  f.knots = {{1.2, Vec4f(1, 0, 0, 0)}, {1.4, Vec4f(1, 1, 0, 0.5F)}, {1.6, Vec4f(0, 1, 0, 0)}};
  for (const HexStructureKind kind : hexKinds)
  {
    CloudObject volume =
      volumeOf(mesh, pointValues(*mesh, [](const Vec3d& p) { return p.x; }), f, kind);
    volume.sampling.integrator = VolumeIntegrator::CellByCell;
    volume.sampling.tolerance = 1e-5;
    const std::vector<ShadedLight> none;
    const CloudTracer tracer(volume, none, Vec3d(0.0), 0);
    WalkCounts some, all;
    forRays(*mesh, 40, 29,
      [&](const Vec3d& from, const Vec3d& way)
      {
        RayGatherer gatherer(nullptr);
        tracer.gather(tracer.ray(from, way, 0.0, INFINITY), gatherer, some);
        EXPECT_LE(largestDifference(
                    gatherer.total(), gatheredByDefinition(volume, from, way, 0.0, INFINITY)),
          2e-5);
        withStructure(*volume.structure,
          [&](const auto& s)
          {
            s.forCellsAlong(
              {from, way}, [](const CellSpan&) { return true; }, KeepAll{}, all);
          });
      });
    EXPECT_LT(2 * some.cells, all.cells);
  }
}

TEST(Volume, RaysEndAtSaturation)
{
  const auto mesh = hexBlock(64, 2, 2).mesh();
  CloudObject volume =
    volumeOf(mesh, std::vector<double>(mesh->pointCount(), 1.0), evenTransfer(0.5F));
  const std::vector<ShadedLight> none;
  for (const VolumeIntegrator integrator : integrators)
    for (const double saturation : {0.9, 0.999})
    {
      volume.sampling.integrator = integrator;
      volume.sampling.saturation = saturation;
      const CloudTracer tracer(volume, none, Vec3d(0.0), 0);
      RayGatherer gatherer(nullptr);
      WalkCounts counts;
      tracer.gather(tracer.ray({-1.0, 1.1, 1.2}, {1, 0, 0}, 0.0, INFINITY), gatherer, counts);
      EXPECT_LE(gatherer.transmittance(), 1.0 - saturation);
      EXPECT_GT(gatherer.transmittance(), 0.2 * (1.0 - saturation));
      EXPECT_LT(counts.cells, 60U);
    }
}

TEST(Volume, CellsWithNaNAreLeftOutOrShown)
{
  const auto mesh = hexBlock(3, 1, 1).mesh();
  std::vector<double> values(mesh->pointCount(), 1.0);
  for (std::size_t p = 0; p < mesh->pointCount(); ++p)
    if (mesh->point(p).x == 1.0 && mesh->point(p).y == 0.0 && mesh->point(p).z == 0.0)
      values[p] = NAN; // of the first two cells
  for (const VolumeIntegrator integrator : integrators)
  {
    CloudObject volume = volumeOf(mesh, values, evenTransfer(0.5F));
    volume.sampling.integrator = integrator;
    volume.sampling.step = 0.05;
    EXPECT_NEAR(gathered(volume, {-1, 0.6, 0.4}, {1, 0, 0}).transmittance, 0.5, 1e-9);
    volume.transfer.nan = Vec4f(1, 0, 0, 0.25F);
    const RayColor shown = gathered(volume, {-1, 0.6, 0.4}, {1, 0, 0});
    EXPECT_NEAR(shown.transmittance, 0.5 * 0.75 * 0.75, 1e-9);
    EXPECT_NEAR(shown.color.x, 1.0 - shown.transmittance, 1e-9);
    EXPECT_NEAR(shown.color.y, 0.75 * 0.75 * 0.5, 1e-9);
  }
}

TEST(Volume, PointsThatCoincideKeepTheirOwnValues)
{
  // Two cubes that share no point: the field jumps from 0 to 1 between them.
  HexCells cells;
  for (const double x : {0.0, 1.0})
    cells.addCell(
      HexCellType::Hexahedron, std::vector<Vec3d>{{x, 0, 0}, {x + 1, 0, 0}, {x + 1, 1, 0},
                                 {x, 1, 0}, {x, 0, 1}, {x + 1, 0, 1}, {x + 1, 1, 1}, {x, 1, 1}});
  const auto mesh = cells.mesh();
  std::vector<double> values(16, 0.0);
  std::fill(values.begin() + 8, values.end(), 1.0);
  TransferFunction f;
  f.knots = {{0.0, Vec4f(1, 0, 0, 0.2F)}, {0.5, Vec4f(0, 1, 0, 0.9F)}, {1.0, Vec4f(0, 0, 1, 0.3F)}};
  for (const HexStructureKind kind : hexKinds)
    for (const VolumeIntegrator integrator : integrators)
    {
      CloudObject volume = volumeOf(mesh, values, f, kind);
      volume.sampling.integrator = integrator;
      const RayColor color = gathered(volume, {-1, 0.4, 0.6}, {1, 0, 0});
      EXPECT_NEAR(color.transmittance, 0.8 * 0.7, 1e-7);
      EXPECT_NEAR(color.color.y, 0.0, 1e-7);
    }
}

TEST(Volume, ValuesOfCellsAreEvenInEach)
{
  const auto mesh = hexBlock(3, 1, 1).mesh();
  std::vector<double> values;
  for (std::size_t c = 0; c < 3; ++c)
    values.push_back(double(c));
  TransferFunction f;
  f.knots = {{0.0, Vec4f(1, 1, 1, 0)}, {2.0, Vec4f(1, 1, 1, 0.5F)}};
  for (const VolumeIntegrator integrator : integrators)
  {
    CloudObject volume = volumeOf(mesh, values, f, HexStructureKind::CartesianGrid, true);
    volume.sampling.integrator = integrator;
    volume.sampling.step = 0.1;
    EXPECT_NEAR(gathered(volume, {-1, 0.6, 0.4}, {1, 0, 0}).transmittance, 0.75 * 0.5, 1e-7);
  }
}

TEST(Volume, RaysAlongAxisSeamEdgesAndFromWithin)
{
  // The disc has collapsed cells at its axis.
  const auto mesh = hexRing({4, 16, 3, 0.0, 1.0, 2.0}).mesh();
  for (const HexStructureKind kind : hexKinds)
    for (const VolumeIntegrator integrator : integrators)
    {
      CloudObject volume =
        volumeOf(mesh, std::vector<double>(mesh->pointCount(), 1.0), evenTransfer(0.5F), kind);
      volume.sampling.integrator = integrator;
      const auto depth = [&](const Vec3d& from, const Vec3d& way, double tMin = 0.0)
      { return opticalDepth(gathered(volume, from, way, tMin)) / std::log(2.0); };
      EXPECT_NEAR(depth({0, 0, -5}, {0, 0, 1}), 2.0, 1e-6);        // the axis
      EXPECT_NEAR(depth({0.25, 0, -5}, {0, 0, 1}), 2.0, 1e-6);     // an edge
      EXPECT_NEAR(depth({0.3, 0, -5}, {0, 0, 1}), 2.0, 1e-6);      // in a face
      EXPECT_NEAR(depth({-5, 0, 1.1}, {1, 0, 0}), 2.0, 1e-6);      // through axis, in the seam
      EXPECT_NEAR(depth({0.1, 0.1, 0.5}, {0, 0, 1}), 1.5, 1e-6);   // from within
      EXPECT_NEAR(depth({0.0, 0.0, 0.5}, {0, 0, -2}), 0.5, 1e-6);  // from the axis
      EXPECT_NEAR(depth({-5, 0, 1.1}, {1, 0, 0}, 4.5), 1.5, 1e-6); // cut in front
    }
}

TEST(Volume, NoCellAndOneCell)
{
  const auto empty = HexCells().mesh();
  for (const HexStructureKind kind : hexKinds)
  {
    const CloudObject nothing = volumeOf(empty, {}, evenTransfer(0.5F), kind);
    EXPECT_EQ(gathered(nothing, {0, 0, 0}, {1, 0, 0}).transmittance, 1.0);
    const auto one = hexBlock(1, 1, 1).mesh();
    const CloudObject cell = volumeOf(one, std::vector<double>(8, 1.0), evenTransfer(0.5F), kind);
    EXPECT_NEAR(gathered(cell, {-1, 0.5, 0.5}, {1, 0, 0}).transmittance, 0.5, 1e-7);
  }
}

TEST(Volume, AnOpacityOfOneHidesAtOnce)
{
  const auto mesh = hexBlock(8, 2, 2).mesh();
  TransferFunction f;
  f.knots = {{0.0, Vec4f(1, 1, 1, 0)}, {4.0, Vec4f(1, 1, 1, 0)}, {4.0, Vec4f(0, 1, 0, 1)}};
  CloudObject volume = volumeOf(mesh, pointValues(*mesh, [](const Vec3d& p) { return p.x; }), f);
  for (const VolumeIntegrator integrator : integrators)
  {
    volume.sampling.integrator = integrator;
    const RayColor color = gathered(volume, {-1, 1.1, 1.2}, {1, 0, 0});
    EXPECT_EQ(color.transmittance, 0.0);
    EXPECT_NEAR(color.color.y, 1.0, 1e-9);
    EXPECT_NEAR(color.color.x, 0.0, 1e-9);
  }
}

TEST(Volume, LengthsAreOfTheWorld)
{
  const auto mesh = hexBlock(4, 4, 4).mesh();
  CloudObject volume =
    volumeOf(mesh, std::vector<double>(mesh->pointCount(), 1.0), evenTransfer(0.25F));
  volume.toWorld = Mat4d(Mat3d(0, 2, 0, -3, 0, 0, 0, 0, 0.5)); // turned and stretched
  for (const VolumeIntegrator integrator : integrators)
  {
    volume.sampling.integrator = integrator;
    // x of the mesh runs along y of the world, 8 long; its y along -x, 12 long.
    const RayColor y = gathered(volume, {-5, -3, 1}, {0, 0.3, 0});
    EXPECT_NEAR(y.transmittance, std::pow(0.75, 8.0), 1e-9);
    const RayColor x = gathered(volume, {5, 3, 1}, {-2, 0, 0});
    EXPECT_NEAR(x.transmittance, std::pow(0.75, 12.0), 1e-9);
  }
}

TEST(Volume, RefusesBadSettings)
{
  const auto mesh = hexBlock(1, 1, 1).mesh();
  const std::vector<ShadedLight> none;
  CloudObject volume = volumeOf(mesh, std::vector<double>(8, 1.0), evenTransfer(0.5F));
  volume.transfer.unitDistance = -1.0;
  EXPECT_THROW(CloudTracer(volume, none, Vec3d(0.0), 0), Error);
  volume.transfer.unitDistance = 1.0;
  volume.field = nullptr;
  EXPECT_THROW(CloudTracer(volume, none, Vec3d(0.0), 0), Error);
}
