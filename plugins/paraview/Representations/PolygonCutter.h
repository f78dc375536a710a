#pragma once

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkPointSet;

namespace mote
{

/// Cuts some polygons out of a surface, with the points that these have and all arrays.
class PolygonCutter
{
public:
  /// The surface must stay, and must not change.
  explicit PolygonCutter(vtkPolyData* from);

  /// Those of these numbers, which count polygons alone, in this order.
  vtkSmartPointer<vtkPolyData> part(const std::vector<vtkIdType>& polygons);

private:
  vtkPolyData* from_;
  vtkIdType before_;               ///< cells before the first polygon
  std::vector<vtkIdType> numbers_; ///< of the points in the part; -1 outside of part()
};

/// The polygons of these parts in one surface, strips as triangles; no lines, vertices, cells that
/// are hidden or ghosts, and no parts of other types.
vtkSmartPointer<vtkPolyData> collectPolygons(const std::vector<vtkPointSet*>& parts);

} // namespace mote
