#include "DataParts.h"

#include "vtkCellData.h"
#include "vtkExtractCells.h"
#include "vtkFieldData.h"
#include "vtkGeometryFilter.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

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

vtkSmartPointer<vtkPointSet> withoutMarkedPoints(vtkPointSet* data)
{
  vtkUnsignedCharArray* marks = data->GetPointGhostArray();
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; marks && i < data->GetNumberOfPoints(); ++i)
    if (marks->GetValue(i) == 0)
      ids->InsertNextId(i);
  if (!marks || ids->GetNumberOfIds() == data->GetNumberOfPoints())
    return data;
  const auto own = pointsOf(data, ids);
  own->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  own->GetFieldData()->ShallowCopy(data->GetFieldData());
  return own;
}

vtkSmartPointer<vtkDataSet> cellsOf(vtkDataSet* data, vtkIdList* ids)
{
  vtkNew<vtkExtractCells> extract;
  extract->SetInputData(data);
  extract->SetCellList(ids);
  extract->Update();
  vtkSmartPointer<vtkDataSet> some = extract->GetOutput();
  if (!data->GetCellData()->HasArray("vtkOriginalCellIds"))
    some->GetCellData()->RemoveArray("vtkOriginalCellIds");
  if (!vtkPolyData::SafeDownCast(data))
    return some;
  vtkNew<vtkGeometryFilter> surface; // vtkPolyData::CopyCells() crashes, in VTK 9.1
  surface->SetInputData(some);
  surface->Update();
  return surface->GetOutput();
}

} // namespace mote
