#include "RankBoxes.h"

#include "vtkCommunicator.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPVRenderView.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace mote
{

namespace
{

constexpr const char* boxName = "MoteBox";
/// What the box was written down for.
constexpr const char* contentName = "MoteBoxContent";

/// Cuts two boxes in the middle of where they overlap, along the axis where that is least. Neither
/// is cut where one reaches beyond the other on both sides.
void part(vtkBoundingBox& a, vtkBoundingBox& b)
{
  if (!a.IsValid() || !b.IsValid())
    return;
  double boundsA[6], boundsB[6], least = std::numeric_limits<double>::infinity();
  a.GetBounds(boundsA);
  b.GetBounds(boundsB);
  int axis = -1;
  for (int c = 0; c < 3; ++c)
  {
    const double low = std::max(boundsA[2 * c], boundsB[2 * c]);
    const double high = std::min(boundsA[2 * c + 1], boundsB[2 * c + 1]);
    if (high <= low)
      return; // they are apart
    const bool follow =
      (boundsA[2 * c] < boundsB[2 * c]) == (boundsA[2 * c + 1] < boundsB[2 * c + 1]);
    if (follow && high - low < least)
    {
      least = high - low;
      axis = c;
    }
  }
  if (axis < 0)
    return;
  double* first = boundsA[2 * axis] < boundsB[2 * axis] ? boundsA : boundsB;
  double* second = first == boundsA ? boundsB : boundsA;
  first[2 * axis + 1] = second[2 * axis] = 0.5 * (first[2 * axis + 1] + second[2 * axis]);
  a.SetBounds(boundsA);
  b.SetBounds(boundsB);
}

vtkBoundingBox ownBoundsOfCells(vtkPolyData* surface)
{
  vtkBoundingBox box;
  vtkUnsignedCharArray* marks = surface->GetCellGhostArray();
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
    if ((marks->GetValue(i) & vtkDataSetAttributes::DUPLICATECELL) == 0)
    {
      double bounds[6];
      surface->GetCellBounds(i, bounds);
      box.AddBounds(bounds);
    }
  return box;
}

void keep(const char* name, const vtkBoundingBox& box, vtkPointSet* points)
{
  double bounds[6];
  box.GetBounds(bounds);
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double bound : bounds)
    array->InsertNextValue(bound);
  points->GetFieldData()->AddArray(array);
}

vtkBoundingBox keptBy(const char* name, vtkPointSet* points)
{
  vtkBoundingBox box;
  auto* array = vtkDoubleArray::SafeDownCast(points->GetFieldData()->GetArray(name));
  if (array && array->GetNumberOfValues() == 6)
    box.SetBounds(array->GetPointer(0));
  return box;
}

} // namespace

vtkBoundingBox ownBoundsOf(vtkPointSet* points)
{
  vtkBoundingBox box;
  const vtkIdType count = points->GetNumberOfPoints();
  vtkUnsignedCharArray* marks = points->GetPointGhostArray();
  auto* surface = vtkPolyData::SafeDownCast(points);
  if (surface && !marks && surface->GetCellGhostArray())
    return ownBoundsOfCells(surface);
  if (count > 0 && !marks)
    box.SetBounds(points->GetPoints()->GetBounds());
  for (vtkIdType i = 0; marks && i < count; ++i)
    if ((marks->GetValue(i) & vtkDataSetAttributes::DUPLICATEPOINT) == 0)
    {
      double place[3];
      points->GetPoint(i, place);
      box.AddPoint(place);
    }
  return box;
}

std::vector<vtkBoundingBox> gatherBoxes(
  vtkMultiProcessController* controller, const vtkBoundingBox& own)
{
  double bounds[6];
  own.GetBounds(bounds);
  std::vector<double> all(6 * static_cast<std::size_t>(controller->GetNumberOfProcesses()));
  controller->AllGather(bounds, all.data(), 6);
  std::vector<vtkBoundingBox> boxes;
  for (std::size_t i = 0; i < all.size(); i += 6)
    boxes.emplace_back(&all[i]);
  return boxes;
}

vtkBoundingBox withoutOverlap(const vtkBoundingBox& own)
{
  auto* controller = vtkMultiProcessController::GetGlobalController();
  if (!controller || controller->GetNumberOfProcesses() < 2)
    return own;
  std::vector<vtkBoundingBox> boxes = gatherBoxes(controller, own);
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      part(boxes[j], boxes[i]);
  return boxes[controller->GetLocalProcessId()];
}

void tellBounds(vtkInformation* info, vtkPVDataRepresentation* representation,
  const vtkBoundingBox& bounds, const vtkBoundingBox& order, vtkMatrix4x4* matrix)
{
  double toView[6], toOrder[6];
  bounds.GetBounds(toView);
  order.GetBounds(toOrder);
  // ParaView 5.11 orders by the bounds of the geometry, before its matrix, even where it was given
  // others for that. So these are what it is told, with a matrix that makes them the others.
  vtkNew<vtkMatrix4x4> whole;
  if (matrix)
    whole->DeepCopy(matrix);
  if (bounds.IsValid() && order.IsValid())
  {
    vtkNew<vtkMatrix4x4> fit;
    for (int c = 0; c < 3; ++c)
    {
      if (!(toOrder[2 * c + 1] > toOrder[2 * c])) // flat: all ranks are, and none is before another
        std::copy_n(toView + 2 * c, 2, toOrder + 2 * c);
      const double from = toOrder[2 * c + 1] - toOrder[2 * c];
      const double scale = from > 0.0 ? (toView[2 * c + 1] - toView[2 * c]) / from : 1.0;
      fit->SetElement(c, c, scale);
      fit->SetElement(c, 3, toView[2 * c] - scale * toOrder[2 * c]);
    }
    vtkMatrix4x4::Multiply4x4(whole, fit, whole);
  }
  vtkPVRenderView::SetGeometryBounds(
    info, representation, order.IsValid() ? toOrder : toView, whole);
  vtkPVRenderView::SetOrderedCompositingConfiguration(info, representation,
    vtkPVRenderView::USE_BOUNDS_FOR_REDISTRIBUTION, order.IsValid() ? toOrder : toView);
}

void keepBox(const vtkBoundingBox& box, vtkPointSet* points)
{
  keep(boxName, box, points);
  if (const vtkBoundingBox own = ownBoundsOf(points); own.IsValid() && !box.Contains(own))
    keep(contentName, own, points);
}

vtkBoundingBox keptBoxOf(vtkPointSet* points)
{
  return keptBy(boxName, points);
}

RankFacts factsOfRanks(vtkPointSet* points)
{
  auto* controller = vtkMultiProcessController::GetGlobalController();
  if (!controller || controller->GetNumberOfProcesses() < 2)
    return {};
  const vtkBoundingBox own = ownBoundsOf(points), box = keptBoxOf(points);
  const vtkBoundingBox content = keptBy(contentName, points);
  const bool fits = box.IsValid() && own.IsValid() &&
                    (box.Contains(own) || (content.IsValid() && content.Contains(own)));
  const bool hasGhosts = points->GetPointGhostArray() || points->GetCellGhostArray();
  // Ranks without particles do not matter.
  const int mine[] = {fits, own.IsValid() && !fits, hasGhosts};
  int any[3] = {0, 0, 0};
  controller->AllReduce(mine, any, 3, vtkCommunicator::MAX_OP);
  return {any[0] != 0 && any[1] == 0, any[2] != 0};
}

} // namespace mote
