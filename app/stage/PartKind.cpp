// What data are drawn as.

#include "Part.h"

#include "base/Failure.h"

#include <vtkCellType.h>
#include <vtkMoteLineTubes.h>
#include <vtkMoteSourcePoints.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

namespace mote::app
{

Part::Kind Part::kindOf(vtkDataSet* data, const Settings& settings)
{
  if (!isMesh(data))
    return Kind::Particles;
  if (settings.volume.cells != "surface" && settings.color.array != "none" && Volume::canShow(data))
    return Kind::Volume;
  if (settings.volume.cells == "volume")
    throw Failure("--cells volume needs tetrahedra, voxels, hexahedra, wedges or pyramids in an "
                  "unstructured grid, and an array of numbers that colours them");
  return Kind::Surface;
}

bool Part::isOfSource(vtkDataSet* data)
{
  auto* set = vtkPointSet::SafeDownCast(data);
  auto* ofSource = set ? vtkMoteSourcePoints::SafeDownCast(set->GetPoints()) : nullptr;
  return ofSource && ofSource->GetSource();
}

bool Part::isLines(vtkDataSet* data)
{
  if (!vtkMoteLineTubes::IsOfLines(data))
    return false;
  vtkPointData* const values = data->GetPointData();
  for (int i = 0; i < values->GetNumberOfArrays(); ++i)
    if (const char* name = values->GetArrayName(i); name && isTypes(data, {name, 0, false}))
      return false;
  return true;
}

bool Part::isMesh(vtkDataSet* data)
{
  if (isLines(data))
    return true;
  if (auto* surface = vtkPolyData::SafeDownCast(data))
    return surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0;
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    // As a rule the first cell tells.
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
      if (grid->GetCellType(i) > VTK_POLY_LINE)
        return true;
    return false;
  }
  return data->GetNumberOfCells() > 0;
}

std::vector<vtkDataSet*> volumesOf(const std::vector<std::unique_ptr<Part>>& parts)
{
  std::vector<vtkDataSet*> volumes;
  for (const auto& part : parts)
    if (part->kind() == Part::Kind::Volume)
      volumes.push_back(part->data());
  return volumes;
}

} // namespace mote::app
