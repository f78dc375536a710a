#include "RankBoxes.h"

#include "vtkCommunicator.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkUnsignedCharArray.h"

#include <cstddef>

namespace mote
{

namespace
{

constexpr const char* boxName = "MoteBox";

} // namespace

vtkBoundingBox ownBoundsOf(vtkPointSet* points)
{
  vtkBoundingBox box;
  const vtkIdType count = points->GetNumberOfPoints();
  vtkUnsignedCharArray* marks = points->GetPointGhostArray();
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

void keepBox(const vtkBoundingBox& box, vtkPointSet* points)
{
  double bounds[6];
  box.GetBounds(bounds);
  vtkNew<vtkDoubleArray> array;
  array->SetName(boxName);
  for (const double bound : bounds)
    array->InsertNextValue(bound);
  points->GetFieldData()->AddArray(array);
}

vtkBoundingBox keptBoxOf(vtkPointSet* points)
{
  vtkBoundingBox box;
  auto* array = vtkDoubleArray::SafeDownCast(points->GetFieldData()->GetArray(boxName));
  if (array && array->GetNumberOfValues() == 6)
    box.SetBounds(array->GetPointer(0));
  return box;
}

bool canBlendInOrder(vtkPointSet* points)
{
  auto* controller = vtkMultiProcessController::GetGlobalController();
  if (!controller || controller->GetNumberOfProcesses() < 2)
    return false;
  // Ranks without particles have neither, and do not matter.
  const bool has = points->GetPointGhostArray() && keptBoxOf(points).IsValid();
  const int own[] = {has, points->GetNumberOfPoints() > 0 && !has};
  int any[2] = {0, 0};
  controller->AllReduce(own, any, 2, vtkCommunicator::MAX_OP);
  return any[0] != 0 && any[1] == 0;
}

} // namespace mote
