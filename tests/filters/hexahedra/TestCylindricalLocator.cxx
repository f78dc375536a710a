// The locator's own answers: those of VTK's vtkStaticCellLocator.

#include "LocatorTools.h"

#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkStaticCellLocator.h>

#include <gtest/gtest.h>

#include <thread>

namespace
{

vtkSmartPointer<vtkStaticCellLocator> vtksLocatorOf(vtkDataSet* data)
{
  auto locator = vtkSmartPointer<vtkStaticCellLocator>::New();
  locator->SetDataSet(data);
  locator->BuildLocator();
  return locator;
}

/// What FindCell() tells of a place, and what the cell then is at.
struct Found
{
  Found(vtkAbstractCellLocator* locator, Vec p)
  {
    id = locator->FindCell(p.data(), 0.0, cell, pcoords.data(), weights.data());
  }
  double value(vtkDataArray* array) const
  {
    double sum = 0.0;
    for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
      sum += weights[i] * array->GetComponent(cell->GetPointId(int(i)), 0);
    return sum;
  }

  vtkNew<vtkGenericCell> cell;
  Vec pcoords{};
  std::array<double, 8> weights{};
  vtkIdType id;
};

TEST(CylindricalLocator, FindsTheCellsThatVTKFinds)
{
  for (const auto& [mesh, grid] : locatorMeshes())
  {
    const auto vtks = vtksLocatorOf(grid);
    const double size = grid->GetLength();
    vtkDataArray* values = grid->GetPointData()->GetScalars();
    const double range = values->GetRange()[1] - values->GetRange()[0];
    for (const std::string& name : names)
    {
      const Locator locator = locatorOf(grid, name);
      int inside = 0, others = 0;
      for (Vec p : placesFor(grid, 2000, 1))
      {
        const Found found(locator, p), expected(vtks, p);
        ASSERT_EQ(found.id < 0, expected.id < 0) << mesh << " " << name;
        ASSERT_EQ(found.id, locator->FindCell(p.data())) << mesh << " " << name;
        if (found.id < 0)
          continue;
        ++inside;
        others += found.id != expected.id;
        ASSERT_EQ(found.cell->GetCellType(), grid->GetCellType(found.id));
        ASSERT_NEAR(found.value(values), expected.value(values), 1e-5 * range) << mesh;
        // The coordinates and weights are those that VTK's cell has there.
        Vec back;
        std::array<double, 8> weights{};
        int subId = 0;
        found.cell->EvaluateLocation(subId, found.pcoords.data(), back.data(), weights.data());
        ASSERT_LT(length(back - p), 1e-10 * size) << mesh << " " << found.cell->GetCellType();
        for (int i = 0; i < found.cell->GetNumberOfPoints(); ++i)
          ASSERT_NEAR(weights[i], found.weights[i], 1e-12) << mesh;
      }
      EXPECT_GT(inside, 1200) << mesh;
      EXPECT_LE(others, 2) << mesh << " " << name; // within 1e-6 of a cell of a face
    }
  }
}

TEST(CylindricalLocator, PointsOfFacesAndCornersAreInACell)
{
  for (const auto& [mesh, grid] : locatorMeshes())
  {
    // Linear, so that neighbours agree also where faces are cut into triangles.
    addField(grid, "linear", 1, [](Vec p) { return Vec{p[0] - 2.0 * p[1] + 3.0 * p[2]}; });
    vtkDataArray* linear = grid->GetPointData()->GetArray("linear");
    const double tolerance = 1e-9 * grid->GetLength();
    for (const std::string& name : names)
    {
      const Locator locator = locatorOf(grid, name);
      int lost = 0;
      for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); cell += 13)
        for (int face = -1; face < 4; ++face)
        {
          vtkCell* whole = grid->GetCell(cell);
          vtkCell* part = face < 0 ? whole : whole->GetFace(face);
          Vec p = pointOf(grid, part->GetPointId(0));
          if (face >= 0)
          {
            p = {};
            for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
              for (int k = 0; k < 3; ++k)
                p[k] +=
                  pointOf(grid, part->GetPointId(int(i)))[k] / double(part->GetNumberOfPoints());
          }
          const Found found(locator, p);
          lost += found.id < 0;
          if (found.id < 0)
            continue;
          ASSERT_NEAR(found.value(linear), p[0] - 2.0 * p[1] + 3.0 * p[2], tolerance) << mesh;
        }
      EXPECT_EQ(lost, 0) << mesh << " " << name;
    }
  }
}

TEST(CylindricalLocator, ClosestPointsAreVTKs)
{
  for (const auto& [mesh, grid] : locatorMeshes())
  {
    const auto vtks = vtksLocatorOf(grid);
    const Locator locator = locatorOf(grid);
    vtkNew<vtkGenericCell> cell;
    const double size = grid->GetLength();
    for (const Vec& p : placesFor(grid, 300, 2))
    {
      Vec closest, expected;
      vtkIdType id = -1, other = -1;
      int subId = 0, inside = -1;
      double distance2 = -1.0, expected2 = -1.0;
      locator->FindClosestPoint(p.data(), closest.data(), cell, id, subId, distance2);
      vtks->FindClosestPoint(p.data(), expected.data(), cell, other, subId, expected2);
      ASSERT_GE(id, 0);
      ASSERT_LT(std::sqrt(distance2), std::sqrt(expected2) + 1e-6 * size) << mesh;
      ASSERT_NEAR(length(closest - p), std::sqrt(distance2), 1e-9 * size) << mesh;
      Vec q = p;
      const double radius = std::sqrt(distance2);
      const auto within = [&](double r)
      {
        return locator->FindClosestPointWithinRadius(
          q.data(), r, closest.data(), cell, id, subId, distance2, inside);
      };
      ASSERT_EQ(within(1.0001 * radius + 1e-9 * size), 1) << mesh;
      EXPECT_EQ(inside, radius == 0.0) << mesh;
      ASSERT_EQ(within(0.999 * radius), radius == 0.0) << mesh;
    }
  }
}

struct LineHit
{
  LineHit(vtkAbstractCellLocator* locator, const Vec& a, const Vec& b)
  {
    vtkNew<vtkGenericCell> cell;
    any = locator->IntersectWithLine(
      a.data(), b.data(), 0.0, t, x.data(), pcoords.data(), subId, id, cell);
  }
  int any, subId = 0;
  double t = -1.0;
  Vec x{}, pcoords{};
  vtkIdType id = -1;
};

/// The first face is where the cell that the line is in changes for the first time.
void expectFirstFace(vtkMoteCylindricalLocator* locator, const Vec& a, const Vec& b)
{
  const LineHit hit(locator, a, b);
  const auto cellAt = [&](double t)
  {
    Vec p;
    for (int k = 0; k < 3; ++k)
      p[k] = a[k] + t * (b[k] - a[k]);
    return locator->FindCell(p.data());
  };
  const vtkIdType first = cellAt(0.0);
  // What is a millionth of a cell outside of the mesh counts as in it.
  const double before = first < 0 ? 1e-4 : 1e-9;
  const double until = hit.any ? hit.t - before : 1.0;
  for (int i = 0; i <= 20; ++i)
    ASSERT_EQ(cellAt(std::max(0.0, until * i / 20.0)), first);
  if (!hit.any || hit.t > 1.0 - 1e-8)
    return;
  const vtkIdType next = cellAt(hit.t + 1e-9);
  ASSERT_TRUE(hit.id == next || (hit.id == first && next < 0));
}

TEST(CylindricalLocator, LinesMeetTheFirstFace)
{
  for (const auto& [mesh, grid] : locatorMeshes())
  {
    const auto vtks = vtksLocatorOf(grid);
    const double size = grid->GetLength();
    const bool flat = mesh == "mixed"; // VTK cuts warped faces into triangles
    for (const std::string& name : names)
    {
      const Locator locator = locatorOf(grid, name);
      vtkNew<vtkGenericCell> cell;
      vtkNew<vtkIdList> passed;
      const auto ends = placesFor(grid, 400, 3);
      int hits = 0, compared = 0, other = 0;
      for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
      {
        const Vec &a = ends[i], &b = ends[i + 1];
        const LineHit hit(locator, a, b), expected(vtks, a, b);
        // A voxel of VTK's is met at once by a line that begins in it.
        if (expected.t != 0.0)
        {
          ++compared;
          other += hit.any != expected.any;
          const bool comparable = flat && hit.any && expected.any;
          ASSERT_LT(comparable ? std::abs(hit.t - expected.t) * length(b - a) : 0.0, 1e-6 * size);
        }
        // Not in collapsed cells: those claim what is a thousandth of them outside.
        if (!flat)
          expectFirstFace(locator, a, b);
        if (!hit.any)
          continue;
        ++hits;
        grid->GetCell(hit.id, cell);
        Vec back;
        std::array<double, 8> weights{};
        int subId = 0;
        cell->EvaluateLocation(subId, hit.pcoords.data(), back.data(), weights.data());
        ASSERT_LT(length(back - hit.x), 1e-9 * size) << mesh;
        locator->FindCellsAlongLine(a.data(), b.data(), 0.0, passed);
        ASSERT_GE(passed->IsId(hit.id), 0) << mesh;
      }
      EXPECT_GT(hits, 100) << mesh;
      EXPECT_GT(compared, 150) << mesh;
      EXPECT_LE(other, 1) << mesh << " " << name;
    }
  }
}

TEST(CylindricalLocator, CellsWithinBoundsAreAmongVTKs)
{
  for (const auto& [mesh, grid] : locatorMeshes())
  {
    const auto vtks = vtksLocatorOf(grid);
    for (const std::string& name : names)
    {
      const Locator locator = locatorOf(grid, name);
      vtkNew<vtkIdList> found, expected;
      for (const Vec& p : placesFor(grid, 40, 4))
      {
        const double h = 0.03 * grid->GetLength();
        double box[6] = {p[0] - h, p[0] + h, p[1] - h, p[1] + h, p[2] - h, p[2] + h};
        locator->FindCellsWithinBounds(box, found);
        vtks->FindCellsWithinBounds(box, expected);
        for (vtkIdType i = 0; i < found->GetNumberOfIds(); ++i)
          ASSERT_GE(expected->IsId(found->GetId(i)), 0) << mesh << " " << name;
        // Every cell with a corner in the box is found.
        for (vtkIdType i = 0; i < expected->GetNumberOfIds(); ++i)
        {
          vtkCell* cell = grid->GetCell(expected->GetId(i));
          for (int k = 0; k < cell->GetNumberOfPoints(); ++k)
          {
            const Vec q = pointOf(grid, cell->GetPointId(k));
            const bool in = std::abs(q[0] - p[0]) <= h && std::abs(q[1] - p[1]) <= h &&
                            std::abs(q[2] - p[2]) <= h;
            ASSERT_TRUE(!in || found->IsId(expected->GetId(i)) >= 0) << mesh << " " << name;
          }
        }
      }
    }
  }
}

TEST(CylindricalLocator, ThreadsFindTheSame)
{
  const Grid grid = mixed();
  const Locator locator = locatorOf(grid);
  const auto places = placesFor(grid, 4000, 5);
  const auto search = [&](std::vector<double>& into)
  {
    for (const Vec& p : places)
    {
      const Found found(locator, p);
      into.push_back(double(found.id));
      into.insert(into.end(), found.weights.begin(), found.weights.end());
    }
  };
  std::vector<double> alone;
  search(alone);
  std::vector<std::vector<double>> together(4);
  std::vector<std::thread> threads;
  for (auto& into : together)
    threads.emplace_back([&search, &into] { search(into); });
  for (std::thread& thread : threads)
    thread.join();
  for (const auto& one : together)
    EXPECT_EQ(one, alone);
}

} // namespace
