#pragma once

// What tests of vtkMoteMeshMapper share: small meshes, and a stage to see them on.

#include "VTKTestSupport.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellTypeSource.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkMoteMeshMapper.h"
#include "vtkMoteParticlePicker.h"
#include "vtkProperty.h"
#include "vtkUnstructuredGrid.h"

#include <utility>
#include <vector>

namespace mote::testing
{

using Cells = std::vector<std::vector<vtkIdType>>;

inline vtkSmartPointer<vtkCellArray> cellArray(const Cells& cells)
{
  auto array = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& cell : cells)
    array->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  return array;
}

/// Six points: the unit square about the origin, and two to its right.
inline vtkSmartPointer<vtkPolyData> sixPoints()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& [x, y] :
    {std::pair(-0.5, -0.5), {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}, {1.0, -0.5}, {1.0, 0.5}})
    points->InsertNextPoint(x, y, 0.0);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  return data;
}

/// The square as a polygon and as a triangle strip to its right, of cells 1 and 2: there is a line.
inline vtkSmartPointer<vtkPolyData> polygonAndStrip()
{
  auto data = sixPoints();
  data->SetLines(cellArray({{0, 5}}));
  data->SetPolys(cellArray({{0, 1, 2, 3}}));
  data->SetStrips(cellArray({{1, 4, 2, 5}}));
  return data;
}

/// Three cells along each axis, or what of a type is cut out of these.
inline vtkSmartPointer<vtkUnstructuredGrid> gridOf(int type)
{
  vtkNew<vtkCellTypeSource> source;
  source->SetCellType(type);
  source->SetBlocksDimensions(3, 3, 3);
  source->Update();
  return source->GetOutput();
}

/// A mapper and an actor in a renderer with a parallel camera that sees [-1.5, 1.5]^2.
struct MeshStage : ::testing::Test
{
  static constexpr int size = 60;
  vtkNew<vtkMoteMeshMapper> mapper;
  vtkNew<vtkActor> actor;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkGenericOpenGLRenderWindow> window; // never opened: it lends the renderer its size
  vtkNew<vtkMoteParticlePicker> picker;

  MeshStage()
  {
    actor->SetMapper(mapper);
    renderer->AddActor(actor);
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetPosition(0, 0, 5);
    camera->SetFocalPoint(0, 0, 0);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.5);
    camera->SetClippingRange(1, 10);
    window->SetSize(size, size);
    window->AddRenderer(renderer);
  }
  void unlit()
  {
    actor->GetProperty()->SetAmbient(1);
    actor->GetProperty()->SetDiffuse(0);
  }
  Picture trace() const { return mote::testing::trace(renderer, size, size); }
  static int pixel(double x, double y)
  {
    const auto at = [](double v) { return static_cast<int>((v + 1.5) / 3.0 * size); };
    return at(y) * size + at(x);
  }
  /// Cell at a place of the picture; -1 for none.
  vtkIdType cellAt(double x, double y)
  {
    const int p = pixel(x, y);
    picker->Pick(p % size, p / size, 0, renderer);
    EXPECT_EQ(picker->GetParticleId(), -1);
    return picker->GetCellId();
  }
};

} // namespace mote::testing
