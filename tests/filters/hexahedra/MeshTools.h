#ifndef MoteMeshTools_h
#define MoteMeshTools_h

#include "PumpTools.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

/// A grid of one or more cells of a type over points.
inline Grid cellsOf(int type, const std::vector<Vec>& points,
  std::initializer_list<std::initializer_list<vtkIdType>> cells)
{
  auto grid = Grid::New();
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (const Vec& p : points)
    places->InsertNextPoint(p.data());
  grid->SetPoints(places);
  for (const auto& cell : cells)
    grid->InsertNextCell(type, static_cast<vtkIdType>(cell.size()), cell.begin());
  return grid;
}

/// n^3 hexahedra over the unit cube, moved by `place`.
inline Grid block(int n, const std::function<Vec(Vec)>& place)
{
  auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto id = [n](int i, int j, int k) { return vtkIdType((k * (n + 1) + j) * (n + 1) + i); };
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        points->InsertNextPoint(place({double(i) / n, double(j) / n, double(k) / n}).data());
  grid->SetPoints(points);
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
      {
        const vtkIdType ids[8] = {id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k),
          id(i, j + 1, k), id(i, j, k + 1), id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1),
          id(i, j + 1, k + 1)};
        grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
      }
  return grid;
}

/// Adds a point array of a function of the place.
inline void addField(
  vtkUnstructuredGrid* grid, const char* name, int components, const std::function<Vec(Vec)>& field)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(grid->GetNumberOfPoints());
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    for (int k = 0; k < components; ++k)
      array->SetComponent(i, k, field(pointOf(grid, i))[k]);
  grid->GetPointData()->AddArray(array);
}

inline double valueAt(vtkTable* table, vtkIdType row, const char* column)
{
  return table->GetValueByName(row, column).ToDouble();
}

#endif
