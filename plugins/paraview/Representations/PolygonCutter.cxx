#include "PolygonCutter.h"

#include "DataParts.h"
#include "RankExchange.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"

#include <numeric>

namespace mote
{

namespace
{

/// The surface with triangles in place of strips.
vtkSmartPointer<vtkPolyData> withoutStrips(vtkPolyData* surface)
{
  if (surface->GetNumberOfStrips() == 0)
    return surface;
  vtkNew<vtkTriangleFilter> filter;
  filter->PassVertsOff();
  filter->PassLinesOff();
  filter->SetInputData(surface);
  filter->Update();
  return filter->GetOutput();
}

/// The numbers of polygons that are drawn here.
std::vector<vtkIdType> ownPolygonsOf(vtkPolyData* surface)
{
  std::vector<vtkIdType> own;
  vtkUnsignedCharArray* marks = surface->GetCellGhostArray();
  const vtkIdType before = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  constexpr int left = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  for (vtkIdType i = 0; i < surface->GetNumberOfPolys(); ++i)
    if (!marks || (marks->GetValue(before + i) & left) == 0)
      own.push_back(i);
  return own;
}

} // namespace

PolygonCutter::PolygonCutter(vtkPolyData* from)
  : from_(from)
  , before_(from->GetNumberOfVerts() + from->GetNumberOfLines())
  , numbers_(from->GetNumberOfPoints(), -1)
{
}

vtkSmartPointer<vtkPolyData> PolygonCutter::part(const std::vector<vtkIdType>& polygons)
{
  vtkNew<vtkIdList> points, corners, cells, places;
  vtkNew<vtkCellArray> kept;
  const auto count = static_cast<vtkIdType>(polygons.size());
  kept->AllocateEstimate(count, 3);
  cells->SetNumberOfIds(count);
  places->SetNumberOfIds(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    from_->GetPolys()->GetCellAtId(polygons[i], corners);
    for (vtkIdType& corner : *corners)
    {
      vtkIdType& number = numbers_[corner];
      if (number < 0)
        number = points->InsertNextId(corner);
      corner = number;
    }
    kept->InsertNextCell(corners);
    cells->SetId(i, before_ + polygons[i]);
    places->SetId(i, i);
  }
  for (const vtkIdType point : *points)
    numbers_[point] = -1;
  const auto part = mote::pointsOf(from_, points);
  part->SetPolys(kept);
  vtkCellData* data = part->GetCellData();
  data->CopyAllOn();
  data->CopyAllocate(from_->GetCellData(), count);
  data->CopyData(from_->GetCellData(), cells, places);
  return part;
}

vtkSmartPointer<vtkPolyData> collectPolygons(const std::vector<vtkPointSet*>& parts)
{
  std::vector<vtkSmartPointer<vtkPolyData>> surfaces;
  for (vtkPointSet* part : parts)
    if (auto* surface = vtkPolyData::SafeDownCast(part))
    {
      const auto polygons = withoutStrips(surface);
      const auto cut = PolygonCutter(polygons).part(ownPolygonsOf(polygons));
      cut->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
      cut->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
      if (cut->GetNumberOfPolys() > 0)
        surfaces.push_back(cut);
    }
  return mote::joined(surfaces);
}

} // namespace mote
