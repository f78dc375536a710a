#include "VolumeTestSupport.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace mote::testing
{

namespace
{

void addCells(vtkUnstructuredGrid* grid, int n)
{
  const auto id = [n](int x, int y, int z) -> vtkIdType { return x + (n + 1) * (y + (n + 1) * z); };
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x)
      {
        const vtkIdType corners[8] = {id(x, y, z), id(x + 1, y, z), id(x + 1, y + 1, z),
          id(x, y + 1, z), id(x, y, z + 1), id(x + 1, y, z + 1), id(x + 1, y + 1, z + 1),
          id(x, y + 1, z + 1)};
        grid->InsertNextCell(VTK_HEXAHEDRON, 8, corners);
      }
}

} // namespace

vtkSmartPointer<vtkUnstructuredGrid> makeBox(int n, const Field& field)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> ofPoints;
  vtkNew<vtkDoubleArray> ofCells;
  ofPoints->SetName("f");
  ofCells->SetName("c");
  const auto at = [n](double i) { return -1.0 + 2.0 * i / n; };
  for (int z = 0; z <= n; ++z)
    for (int y = 0; y <= n; ++y)
      for (int x = 0; x <= n; ++x)
      {
        points->InsertNextPoint(at(x), at(y), at(z));
        ofPoints->InsertNextValue(static_cast<float>(field({at(x), at(y), at(z)})));
        if (x < n && y < n && z < n)
          ofCells->InsertNextValue(field({at(x + 0.5), at(y + 0.5), at(z + 0.5)}));
      }
  grid->SetPoints(points);
  grid->GetPointData()->SetScalars(ofPoints);
  grid->GetCellData()->AddArray(ofCells);
  addCells(grid, n);
  return grid;
}

vtkSmartPointer<vtkUnstructuredGrid> copyOf(vtkUnstructuredGrid* grid)
{
  auto copy = vtkSmartPointer<vtkUnstructuredGrid>::New();
  copy->DeepCopy(grid);
  return copy;
}

vtkSmartPointer<vtkUnstructuredGrid> cellsApart(vtkUnstructuredGrid* grid)
{
  auto apart = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(grid->GetPoints()->GetDataType());
  vtkPointData* values = apart->GetPointData();
  values->CopyAllOn();
  values->CopyAllocate(grid->GetPointData());
  apart->Allocate(grid->GetNumberOfCells());
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, ids);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      const vtkIdType own = points->InsertNextPoint(grid->GetPoint(ids->GetId(k)));
      values->CopyData(grid->GetPointData(), ids->GetId(k), own);
      ids->SetId(k, own);
    }
    apart->InsertNextCell(grid->GetCellType(cell), ids);
  }
  apart->SetPoints(points);
  return apart;
}

VolumeProp::VolumeProp(vtkUnstructuredGrid* grid)
{
  if (grid)
    mapper->SetInputData(grid);
  volume->SetMapper(mapper);
  property()->ShadeOff();
  paint({1, 1, 1}, 0.5);
}

void VolumeProp::paint(const Point& color, double opacity) const
{
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0, color[0], color[1], color[2]);
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(0, opacity);
  property()->SetColor(colors);
  property()->SetScalarOpacity(opacities);
}

double covered(double opacity, double length)
{
  return 1.0 - std::pow(1.0 - opacity, length);
}

double chord(const TrueView& view, double x, double y, const Point& place, double depth)
{
  const TrueView::Line line = view.line(x, y);
  double in = 0.0, out = std::numeric_limits<double>::infinity();
  if (std::isfinite(depth))
    out = depth / line.along;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double a = (place[k] - 1.0 - line.origin[k]) / line.direction[k];
    const double b = (place[k] + 1.0 - line.origin[k]) / line.direction[k];
    if (line.direction[k] != 0.0)
    {
      in = std::max(in, std::min(a, b));
      out = std::min(out, std::max(a, b));
    }
    else if (std::abs(line.origin[k] - place[k]) > 1.0)
      return 0.0;
  }
  return std::max(0.0, out - in);
}

VolumeStage::VolumeStage(vtkUnstructuredGrid* grid, bool parallel)
  : VolumeProp(grid)
{
  renderer->AddVolume(volume);
  camera()->SetPosition(0, 0, 10);
  camera()->SetFocalPoint(0, 0, 0);
  camera()->SetViewAngle(2.0 * 180.0 / M_PI * std::atan(1.5 / 10.0));
  camera()->SetParallelScale(1.5);
  camera()->SetParallelProjection(parallel);
}

vtkCamera* VolumeStage::camera() const
{
  return renderer->GetActiveCamera();
}

Picture VolumeStage::trace(int width, int height, int samples) const
{
  return mote::testing::trace(renderer, width, height, samples);
}

TrueView VolumeStage::view(int width, int height) const
{
  return {camera(), width, height};
}

} // namespace mote::testing
