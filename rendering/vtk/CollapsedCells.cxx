#include "CollapsedCells.h"

#include "GridCells.h"
#include "SurfaceTriangles.h"

#include "kernels/hexahedra/HangingFaces.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <vector>

namespace mote
{

bool hasCollapsedCells(vtkUnstructuredGrid* grid)
{
  if (!grid->GetCells() || grid->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()))
    return false;
  std::atomic<bool> isOther{false}, isCollapsed{false};
  tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, grid->GetNumberOfCells(), 1 << 13),
    [&](const tbb::blocked_range<vtkIdType>& range)
    {
      vtkNew<vtkIdList> ids;
      std::vector<vtkIdType> sorted;
      for (vtkIdType cell = range.begin(); cell < range.end() && !isOther; ++cell)
      {
        const int type = grid->GetCellType(cell);
        if (type < VTK_TETRA || type > VTK_PYRAMID)
          isOther = true;
        if (type == VTK_TETRA || isOther)
          continue;
        grid->GetCellPoints(cell, ids);
        sorted.assign(ids->begin(), ids->end());
        std::sort(sorted.begin(), sorted.end());
        if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
          isCollapsed = true;
      }
    });
  return isCollapsed && !isOther;
}

SurfaceTriangles surfaceOfCollapsedCells(vtkUnstructuredGrid* grid)
{
  const HexMesh mesh(GridCells(GridArrays(grid)).input());
  const FaceAdjacency adjacency(mesh);
  const FaceTriangles faces(mesh, adjacency.boundary());
  SurfaceTriangles found;
  vtkNew<vtkIdTypeArray> corners;
  corners->SetNumberOfValues(static_cast<vtkIdType>(faces.corners.size()));
  std::copy(faces.corners.begin(), faces.corners.end(), corners->GetPointer(0));
  found.corners = DataArrayView(corners);
  found.edges = faces.edges;
  found.cells.reserve(faces.edges.size());
  for (std::size_t f = 0; f + 1 < faces.first.size(); ++f)
    found.cells.insert(found.cells.end(), faces.first[f + 1] - faces.first[f],
      static_cast<vtkIdType>(mesh.inputCell(adjacency.boundary()[f].cell)));
  return found;
}

} // namespace mote
