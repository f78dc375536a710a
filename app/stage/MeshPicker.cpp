#include "MeshPicker.h"

#include <vtkActor.h>
#include <vtkCell.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProp3D.h>
#include <vtkStaticCellLocator.h>

#include <limits>

namespace mote::app
{

std::optional<MeshPicker::Hit> MeshPicker::hit(
  const Part& part, const std::array<double, 3>& from, const std::array<double, 3>& to)
{
  auto* actor = vtkActor::SafeDownCast(part.prop());
  auto* mapper = actor ? vtkPolyDataMapper::SafeDownCast(actor->GetMapper()) : nullptr;
  if (part.kind() != Part::Kind::Surface || !mapper || !actor->GetVisibility())
    return {};
  mapper->Update();
  vtkPolyData* surface = mapper->GetInput();
  if (!surface || surface->GetNumberOfCells() == 0)
    return {};
  Faces& faces = faces_[&part];
  if (faces.surface != surface || faces.time != surface->GetMTime())
  {
    faces.surface = surface;
    faces.locator = vtkSmartPointer<vtkStaticCellLocator>::New();
    faces.locator->SetDataSet(surface);
    faces.locator->BuildLocator();
    faces.time = surface->GetMTime();
  }
  Hit hit;
  double inCell[3];
  int piece = 0;
  vtkIdType face = -1;
  vtkNew<vtkGenericCell> cell;
  if (!faces.locator->IntersectWithLine(
        from.data(), to.data(), 0.0, hit.share, hit.at.data(), inCell, piece, face, cell))
    return {};
  surface->GetCell(face, cell);
  double nearest = std::numeric_limits<double>::max(), corner[3] = {};
  for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
  {
    double place[3];
    surface->GetPoint(cell->GetPointId(static_cast<int>(i)), place);
    const double away = vtkMath::Distance2BetweenPoints(place, hit.at.data());
    if (away < nearest)
    {
      nearest = away;
      std::copy_n(place, 3, corner);
    }
  }
  // Faces may be made of copies of the data's points.
  hit.point = part.data()->FindPoint(corner);
  if (hit.point < 0)
    return {};
  return hit;
}

} // namespace mote::app
