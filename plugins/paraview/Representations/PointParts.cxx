#include "PointParts.h"

#include "vtkAppendPolyData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace mote
{

namespace
{

vtkSmartPointer<vtkPolyData> pointsOf(vtkPointSet* from)
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
    return pointsOf(parts.front());
  vtkNew<vtkAppendPolyData> append;
  for (vtkPointSet* part : parts)
    append->AddInputData(pointsOf(part));
  append->Update();
  return pointsOf(append->GetOutput());
}

vtkSmartPointer<vtkPolyData> subsetOf(vtkPolyData* all, const vtkIdType* ids, vtkIdType count)
{
  vtkNew<vtkIdList> list;
  list->SetNumberOfIds(count);
  std::copy_n(ids, count, list->GetPointer(0));
  auto some = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(all->GetPoints()->GetDataType());
  points->SetNumberOfPoints(count);
  all->GetPoints()->GetData()->GetTuples(list, points->GetData());
  some->SetPoints(points);
  some->GetPointData()->CopyAllOn();
  some->GetPointData()->CopyAllocate(all->GetPointData(), count);
  some->GetPointData()->CopyData(all->GetPointData(), list);
  return some;
}

vtkSmartPointer<vtkPolyData> withoutGhosts(vtkPolyData* data)
{
  vtkUnsignedCharArray* marks = data->GetPointGhostArray();
  if (!marks)
    return data;
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    if ((marks->GetValue(i) & vtkDataSetAttributes::DUPLICATEPOINT) == 0)
      ids.push_back(i);
  const auto own = subsetOf(data, ids.data(), static_cast<vtkIdType>(ids.size()));
  own->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  return own;
}

} // namespace mote
