#pragma once

// Only for tests that have VTK.

#include "HexMeshes.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

namespace mote::testing
{

/// The cells as VTK has them, with the scalars "linear", x + 2 y - z.
inline vtkSmartPointer<vtkUnstructuredGrid> gridOf(const HexCells& cells)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> linear;
  points->SetDataTypeToDouble();
  linear->SetName("linear");
  for (std::size_t i = 0; i < cells.points.size(); i += 3)
  {
    const double* const p = cells.points.data() + i;
    points->InsertNextPoint(p);
    linear->InsertNextValue(p[0] + 2.0 * p[1] - p[2]);
  }
  grid->SetPoints(points);
  grid->GetPointData()->SetScalars(linear);
  for (std::size_t c = 0; c < cells.types.size(); ++c)
  {
    const std::vector<vtkIdType> ids(cells.connectivity.begin() + cells.offsets[c],
      cells.connectivity.begin() + cells.offsets[c + 1]);
    const auto count = static_cast<vtkIdType>(ids.size());
    if (cells.faceLocations[c] < 0)
    {
      grid->InsertNextCell(cells.types[c], count, ids.data());
      continue;
    }
    const auto first = static_cast<std::size_t>(cells.faceLocations[c]);
    const std::vector<vtkIdType> faces(
      cells.faces.begin() + static_cast<std::ptrdiff_t>(first) + 1, cells.faces.end());
    grid->InsertNextCell(VTK_POLYHEDRON, count, ids.data(), cells.faces[first], faces.data());
  }
  return grid;
}

} // namespace mote::testing
