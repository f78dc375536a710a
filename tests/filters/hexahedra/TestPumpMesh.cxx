// The pump's mesh: right cells, conforming, without overlap, at every scale and in every place.

#include "PumpTools.h"

#include <vtkNew.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{

constexpr int neighbours[8][3] = {
  {1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};

/// The least Jacobian at a corner, by the product of the three edges there.
double leastScaledJacobian(vtkUnstructuredGrid* grid)
{
  double least = 1.0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const auto ids = cornersOf(grid, cell);
    for (int k = 0; k < 8; ++k)
    {
      const Vec o = pointOf(grid, ids[k]);
      const Vec a = pointOf(grid, ids[neighbours[k][0]]) - o,
                b = pointOf(grid, ids[neighbours[k][1]]) - o,
                c = pointOf(grid, ids[neighbours[k][2]]) - o;
      least = std::min(least, dot(a, cross(b, c)) / (length(a) * length(b) * length(c)));
    }
  }
  return least;
}

TEST(PumpMesh, CountsKeepTheirRatio)
{
  for (const double scale : {0.0005, 0.001, 0.004, 0.01, 0.05, 0.3, 1.0, 4.0})
  {
    const double millions[3] = {0.86e6, 2.15e6, 3.44e6};
    for (int part = 1; part <= 3; ++part)
    {
      const auto count = static_cast<double>(vtkMotePumpSource::GetNumberOfCells(scale, part));
      const double wanted = scale * millions[part - 1];
      EXPECT_NEAR(count / wanted, 1.0, wanted > 2e4 ? 0.01 : 0.03) << scale << " " << part;
    }
    if (scale > 0.01)
      continue;
    vtkNew<vtkMotePumpSource> source;
    source->SetScale(scale);
    for (int part = 1; part <= 3; ++part)
      EXPECT_EQ(
        partOf(source, part)->GetNumberOfCells(), vtkMotePumpSource::GetNumberOfCells(scale, part));
  }
}

TEST(PumpMesh, EveryCornerIsRight)
{
  vtkNew<vtkMotePumpSource> source;
  const double least[3] = {0.8, 0.2, 0.01};
  for (const double scale : {0.0005, 0.0007, 0.001, 0.0015, 0.002, 0.003, 0.005, 0.01, 0.02, 0.1})
    for (int part = 1; part <= 3; ++part)
    {
      source->SetScale(scale);
      EXPECT_GT(leastScaledJacobian(partOf(source, part)), least[part - 1]) << scale << " " << part;
    }
}

TEST(PumpMesh, AnyAxisAnyPlace)
{
  vtkNew<vtkMotePumpSource> source;
  source->SetScale(0.002);
  std::vector<double> upright;
  for (int part = 1; part <= 3; ++part)
    upright.push_back(leastScaledJacobian(partOf(source, part)));
  const double axes[4][3] = {{1, 0, 0}, {0, -2, 0}, {0, 0, -1}, {0.3, -0.5, 0.1}};
  for (const auto& axis : axes)
  {
    source->SetAxis(axis);
    source->SetOrigin(3.0, -20.0, 100.0);
    for (int part = 1; part <= 3; ++part)
      EXPECT_NEAR(leastScaledJacobian(partOf(source, part)), upright[part - 1], 1e-6);
  }
  source->SetOrigin(1e6, -1e6, 1e6);
  for (int part = 1; part <= 3; ++part)
    EXPECT_GT(leastScaledJacobian(partOf(source, part)), 0.0);
}

TEST(PumpMesh, InnerFacesBelongToTwoCells)
{
  vtkNew<vtkMotePumpSource> source;
  for (const double scale : {0.0005, 0.003})
    for (int part = 1; part <= 3; ++part)
    {
      source->SetScale(scale);
      vtkUnstructuredGrid* grid = partOf(source, part);
      vtkIdType inner = 0;
      for (const auto& [corners, entry] : facesOf(grid))
      {
        ASSERT_LE(entry.first, 2);
        if (entry.first == 2)
        {
          EXPECT_EQ(entry.second, 0) << "both cells lie on one side of a face";
          ++inner;
        }
      }
      EXPECT_GT(inner, 2 * grid->GetNumberOfCells());
      // No vertex is without a cell, and none stands twice in one place.
      std::vector<char> used(grid->GetNumberOfPoints(), 0);
      for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
        for (const vtkIdType id : cornersOf(grid, cell))
          used[id] = 1;
      EXPECT_EQ(std::count(used.begin(), used.end(), 0), 0);
      std::vector<Vec> places;
      for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
      {
        Vec p = pointOf(grid, i);
        for (double& x : p)
          x = std::round(x * 1e9);
        places.push_back(p);
      }
      std::sort(places.begin(), places.end());
      EXPECT_EQ(std::adjacent_find(places.begin(), places.end()), places.end());
    }
}

TEST(PumpMesh, CellsHoldTheAxis)
{
  vtkNew<vtkMotePumpSource> source;
  source->SetScale(0.005);
  vtkUnstructuredGrid* inlet = partOf(source, 1);
  vtkIdType holding = 0;
  for (vtkIdType cell = 0; cell < inlet->GetNumberOfCells(); ++cell)
  {
    double bounds[6];
    inlet->GetCellBounds(cell, bounds);
    holding += bounds[0] < 0 && bounds[1] > 0 && bounds[2] < 0 && bounds[3] > 0;
  }
  EXPECT_GE(holding, 8);
}

TEST(PumpMesh, NoPointLiesInTwoCells)
{
  vtkNew<vtkMotePumpSource> source;
  source->SetScale(0.001);
  std::vector<vtkSmartPointer<vtkUnstructuredGrid>> parts;
  for (int part = 1; part <= 3; ++part)
  {
    auto copy = vtkSmartPointer<vtkUnstructuredGrid>::New();
    copy->ShallowCopy(partOf(source, part));
    parts.push_back(copy);
  }
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(-0.24, 0.24), z(-0.16, 0.08);
  int inside = 0;
  for (int i = 0; i < 9000; ++i)
  {
    const double p[3] = {x(random), x(random), z(random)};
    if (std::abs(std::hypot(p[0], p[1]) - 0.1) < 0.001)
      continue; // the chords of rotor and diffuser cross
    int owners = 0;
    for (vtkUnstructuredGrid* grid : parts)
      for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
      {
        double bounds[6], closest[3], local[3], weights[8], distance = 0.0;
        grid->GetCellBounds(cell, bounds);
        if (p[0] < bounds[0] || p[0] > bounds[1] || p[1] < bounds[2] || p[1] > bounds[3] ||
            p[2] < bounds[4] || p[2] > bounds[5])
          continue;
        int sub = 0;
        const bool in =
          grid->GetCell(cell)->EvaluatePosition(p, closest, sub, local, distance, weights) == 1;
        // On a face both may claim it.
        owners +=
          in && std::all_of(local, local + 3, [](double u) { return u > 1e-4 && u < 0.9999; });
      }
    EXPECT_LE(owners, 1) << p[0] << " " << p[1] << " " << p[2];
    inside += owners;
  }
  EXPECT_GT(inside, 300);
}

TEST(PumpMesh, CellsAreTinyAtBlades)
{
  vtkNew<vtkMotePumpSource> source;
  source->SetScale(0.05);
  for (int part = 2; part <= 3; ++part)
  {
    vtkUnstructuredGrid* grid = partOf(source, part);
    double least = 1.0, most = 0.0;
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      const auto ids = cornersOf(grid, cell);
      const Vec o = pointOf(grid, ids[0]);
      const double volume =
        dot(pointOf(grid, ids[1]) - o, cross(pointOf(grid, ids[3]) - o, pointOf(grid, ids[4]) - o));
      least = std::min(least, volume);
      most = std::max(most, volume);
    }
    EXPECT_GT(most / least, 500.0) << part;
  }
}

} // namespace
