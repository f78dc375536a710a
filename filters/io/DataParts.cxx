#include "DataParts.h"

#include "vtkCellData.h"
#include "vtkExtractCells.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace mote
{

namespace
{

/// Whether the numbers are all from 0 on, in order.
bool areAll(vtkIdList* ids, vtkIdType count)
{
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    if (ids->GetId(i) != i)
      return false;
  return ids->GetNumberOfIds() == count;
}

} // namespace

vtkSmartPointer<vtkPolyData> pointsOf(vtkDataSet* data, vtkIdList* ids)
{
  const vtkIdType count = ids->GetNumberOfIds();
  auto* set = vtkPointSet::SafeDownCast(data);
  auto* const source = set ? set->GetPoints() : nullptr;
  vtkNew<vtkPoints> points;
  points->SetDataType(source ? source->GetDataType() : VTK_DOUBLE);
  points->SetNumberOfPoints(count);
  vtkNew<vtkIdList> places;
  places->SetNumberOfIds(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->SetPoint(i, data->GetPoint(ids->GetId(i)));
    places->SetId(i, i);
  }
  auto some = vtkSmartPointer<vtkPolyData>::New();
  some->SetPoints(points);
  if (areAll(ids, data->GetNumberOfPoints()))
  {
    some->GetPointData()->ShallowCopy(data->GetPointData());
    return some;
  }
  some->GetPointData()->CopyAllOn();
  some->GetPointData()->CopyAllocate(data->GetPointData(), count);
  some->GetPointData()->CopyData(data->GetPointData(), ids, places);
  return some;
}

vtkSmartPointer<vtkDataSet> cellsOf(vtkDataSet* data, vtkIdList* ids)
{
  if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    auto some = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetDataType(surface->GetPoints()->GetDataType());
    some->SetPoints(points);
    some->AllocateProportional(
      surface, static_cast<double>(ids->GetNumberOfIds()) /
                 static_cast<double>(std::max<vtkIdType>(1, surface->GetNumberOfCells())));
    some->GetPointData()->CopyAllOn();
    some->GetCellData()->CopyAllOn();
    some->CopyCells(surface, ids);
    return some;
  }
  vtkNew<vtkExtractCells> extract;
  extract->SetInputData(data);
  extract->SetCellList(ids);
  extract->Update();
  vtkSmartPointer<vtkDataSet> some = extract->GetOutput();
  if (!data->GetCellData()->HasArray("vtkOriginalCellIds"))
    some->GetCellData()->RemoveArray("vtkOriginalCellIds");
  return some;
}

} // namespace mote
