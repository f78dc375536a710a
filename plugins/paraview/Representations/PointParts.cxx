#include "PointParts.h"

#include "DataParts.h"

#include "vtkAppendPolyData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

namespace mote
{

namespace
{

/// The points of a data set with their arrays, and no cells.
vtkSmartPointer<vtkPolyData> withoutCells(vtkPointSet* from)
{
  auto to = vtkSmartPointer<vtkPolyData>::New();
  to->SetPoints(from->GetPoints());
  to->GetPointData()->ShallowCopy(from->GetPointData());
  to->GetFieldData()->ShallowCopy(from->GetFieldData());
  return to;
}

} // namespace

std::vector<vtkPointSet*> pointSetsOf(vtkDataObject* data)
{
  std::vector<vtkPointSet*> parts;
  const auto add = [&](vtkDataObject* part)
  {
    if (auto* points = vtkPointSet::SafeDownCast(part); points && points->GetNumberOfPoints() > 0)
      parts.push_back(points);
  };
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    add(data);
    return parts;
  }
  const auto it = vtk::TakeSmartPointer(composite->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    add(it->GetCurrentDataObject());
  return parts;
}

vtkSmartPointer<vtkPolyData> collectPoints(const std::vector<vtkPointSet*>& parts)
{
  if (parts.empty())
    return vtkSmartPointer<vtkPolyData>::New();
  if (parts.size() == 1)
    return withoutCells(parts.front());
  vtkNew<vtkAppendPolyData> append;
  for (vtkPointSet* part : parts)
    append->AddInputData(withoutCells(part));
  append->Update();
  return withoutCells(append->GetOutput());
}

} // namespace mote
