#include "MeshSamples.h"
#include "BoxParts.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

namespace samples
{

namespace
{

void addArrays(vtkDataSet* data, double time)
{
  vtkNew<vtkDoubleArray> p;
  p->SetName("p");
  double at[3];
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    data->GetPoint(i, at);
    p->InsertNextValue(at[0] + 10.0 * at[1] + 100.0 * at[2]);
  }
  vtkNew<vtkDoubleArray> q;
  q->SetName("q");
  vtkNew<vtkDoubleArray> velocity;
  velocity->SetName("U");
  velocity->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    q->InsertNextValue(double(i));
    velocity->InsertNextTuple3(time, double(i), 0.0);
  }
  data->GetPointData()->AddArray(p);
  data->GetCellData()->AddArray(q);
  data->GetCellData()->AddArray(velocity);
}

} // namespace

vtkSmartPointer<vtkUnstructuredGrid> box(double time)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  for (const Place& place : places())
    points->InsertNextPoint(place.data());
  grid->SetPoints(points);
  forCells(
    [&](int i, int j, int k)
    {
      const auto corners = hexahedron(i, j, k);
      const std::vector<vtkIdType> ids(corners.begin(), corners.end());
      grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids.data());
    });
  addArrays(grid, time);
  return grid;
}

vtkSmartPointer<vtkStructuredGrid> structuredBox(bool isLeftHanded)
{
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(nx + 1, ny + 1, nz + 1);
  vtkNew<vtkPoints> points;
  for (const Place& place : places())
    points->InsertNextPoint(isLeftHanded ? nx - place[0] : place[0], place[1], place[2]);
  grid->SetPoints(points);
  addArrays(grid, 0.0);
  return grid;
}

} // namespace samples
