#ifndef MoteLocatorTools_h
#define MoteLocatorTools_h

#include "MeshTools.h"

#include <kernels/hexahedra/HexStructure.h>

#include <vtkMoteCylindricalLocator.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <random>

struct NamedGrid
{
  std::string name;
  Grid grid; ///< with active point scalars and vectors
};

/// Adds a smooth flow through the unit cube, and a number, as the active ones.
inline void addFlow(vtkUnstructuredGrid* grid)
{
  addField(grid, "flow", 3,
    [](Vec p) {
      return Vec{0.5 + p[1] * p[2], 0.3 * std::sin(3 * p[0]), 0.2 + p[0] * p[1]};
    });
  addField(grid, "number", 1, [](Vec p) { return Vec{1.0 + p[0] - 2.0 * p[1] + 0.5 * p[2]}; });
  grid->GetPointData()->SetActiveVectors("flow");
  grid->GetPointData()->SetActiveScalars("number");
}

inline Grid swirl(int step)
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(
    (std::string(MOTE_SOURCE_DIR) + "/data/swirl." + std::to_string(step) + ".vtu").c_str());
  reader->Update();
  Grid grid = reader->GetOutput();
  grid->GetPointData()->SetActiveVectors("U");
  grid->GetPointData()->SetActiveScalars("p");
  return grid;
}

/// A block that is twisted by 40 degrees about an axis that no coordinate axis is parallel to: all
/// faces across it are warped.
inline Grid twisted()
{
  const Grid grid = block(7,
    [](Vec p)
    {
      const double angle = 0.7 * p[2], x = p[0] - 0.5, y = p[1] - 0.5;
      const Vec q = {x * std::cos(angle) - y * std::sin(angle),
        x * std::sin(angle) + y * std::cos(angle), p[2] - 0.5};
      const double c = std::cos(0.6), s = std::sin(0.6);
      return Vec{c * q[0] + s * q[2], q[1], -s * q[0] + c * q[2]};
    });
  addFlow(grid);
  return grid;
}

/// A block of boxes, each left as a hexahedron, made a voxel, or cut into wedges, pyramids or
/// tetrahedra.
inline Grid mixed()
{
  constexpr int n = 5;
  const Grid boxes = block(n, [](Vec p) { return Vec{p[0], 1.3 * p[1], 0.7 * p[2]}; });
  auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  points->DeepCopy(boxes->GetPoints());
  grid->SetPoints(points);
  for (vtkIdType cell = 0; cell < boxes->GetNumberOfCells(); ++cell)
  {
    const auto c = cornersOf(boxes, cell);
    const auto add = [&](int type, std::initializer_list<int> corners, vtkIdType top = -1)
    {
      std::vector<vtkIdType> ids;
      for (const int i : corners)
        ids.push_back(c[i]);
      if (top >= 0)
        ids.push_back(top);
      grid->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
    };
    const auto kind = cell * 7 % 5;
    if (kind == 0)
      add(VTK_HEXAHEDRON, {0, 1, 2, 3, 4, 5, 6, 7});
    else if (kind == 1)
      add(VTK_VOXEL, {0, 1, 3, 2, 4, 5, 7, 6});
    else if (kind == 2)
    {
      add(VTK_WEDGE, {0, 2, 1, 4, 6, 5});
      add(VTK_WEDGE, {0, 2, 3, 4, 6, 7}); // listed in the other order
    }
    else if (kind == 3)
    {
      Vec middle{};
      for (const vtkIdType i : c)
        for (int k = 0; k < 3; ++k)
          middle[k] += 0.125 * pointOf(boxes, i)[k];
      const vtkIdType top = points->InsertNextPoint(middle.data());
      add(VTK_PYRAMID, {0, 1, 2, 3}, top);
      add(VTK_PYRAMID, {4, 7, 6, 5}, top);
      add(VTK_PYRAMID, {0, 4, 5, 1}, top);
      add(VTK_PYRAMID, {1, 5, 6, 2}, top);
      add(VTK_PYRAMID, {2, 6, 7, 3}, top);
      add(VTK_PYRAMID, {3, 7, 4, 0}, top);
    }
    else
      for (const auto& [a, b] : {std::pair(1, 2), {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}})
        add(VTK_TETRA, {0, 6, a, b});
  }
  addFlow(grid);
  return grid;
}

/// A pump of about 6500 cells.
inline void setSmall(vtkMotePumpSource* pump)
{
  pump->SetScale(0.001);
}

/// Meshes of every kind that there is.
inline std::vector<NamedGrid> locatorMeshes()
{
  std::vector<NamedGrid> all = {
    {"swirl.0", swirl(0)}, {"swirl.1", swirl(1)}, {"twisted", twisted()}, {"mixed", mixed()}};
  for (const int part : {1, 2, 3})
  {
    vtkNew<vtkMotePumpSource> pump;
    setSmall(pump);
    all.push_back({"pump " + std::to_string(part), partOf(pump, part)});
  }
  return all;
}

/// Points at random: three quarters in cells, the others anywhere in the bounds and a little
/// outside.
inline std::vector<Vec> placesFor(vtkUnstructuredGrid* grid, int count, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Vec> places;
  const double* b = grid->GetBounds();
  for (int i = 0; i < count; ++i)
  {
    Vec p{};
    if (i % 4 == 0)
      for (int k = 0; k < 3; ++k)
        p[k] = b[2 * k] + (1.1 * unit(random) - 0.05) * (b[2 * k + 1] - b[2 * k]);
    else
    {
      vtkCell* cell =
        grid->GetCell(static_cast<vtkIdType>(unit(random) * double(grid->GetNumberOfCells())));
      double sum = 0.0;
      std::vector<double> weights;
      for (vtkIdType j = 0; j < cell->GetNumberOfPoints(); ++j)
      {
        weights.push_back(0.05 + unit(random));
        sum += weights.back();
      }
      for (std::size_t j = 0; j < weights.size(); ++j)
        for (int k = 0; k < 3; ++k)
          p[k] += weights[j] / sum * pointOf(grid, cell->GetPointId(int(j)))[k];
    }
    places.push_back(p);
  }
  return places;
}

using Locator = vtkSmartPointer<vtkMoteCylindricalLocator>;

inline const std::vector<std::string>& names = mote::hexStructureNames();

inline Locator locatorOf(vtkDataSet* data, const std::string& name = "cylbvh")
{
  auto locator = Locator::New();
  locator->SetStructureName(name);
  locator->SetDataSet(data);
  locator->BuildLocator();
  return locator;
}

#endif
