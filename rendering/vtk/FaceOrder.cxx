#include "FaceOrder.h"

#include "SurfaceTriangles.h"

#include "kernels/hexahedra/HangingFaces.h"

#include "vtkIdTypeArray.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace mote
{

void sortFaces(vtkIdTypeArray* corners, SurfaceTriangles& surface)
{
  std::vector<FaceRange> faces = facesOf(surface.cells.size(), surface.edges);
  const vtkIdType* const p = corners->GetPointer(0);
  const auto key = [&](const FaceRange& face)
  {
    const vtkIdType* const of = p + 3 * face.first;
    return std::tuple(surface.cells[face.first], of[0], of[1], of[2]);
  };
  const auto isLess = [&](const FaceRange& a, const FaceRange& b)
  { return std::tuple(key(a), a.first) < std::tuple(key(b), b.first); };
  if (std::is_sorted(faces.begin(), faces.end(), isLess))
    return;
  tbb::parallel_sort(faces.begin(), faces.end(), isLess);
  std::vector<vtkIdType> sortedCorners, cells;
  std::vector<std::uint8_t> edges;
  sortedCorners.reserve(3 * surface.cells.size());
  cells.reserve(surface.cells.size());
  for (const FaceRange& face : faces)
    for (std::size_t t = face.first; t < face.end; ++t)
    {
      sortedCorners.insert(sortedCorners.end(), p + 3 * t, p + 3 * t + 3);
      cells.push_back(surface.cells[t]);
      if (!surface.edges.empty())
        edges.push_back(surface.edges[t]);
    }
  std::copy(sortedCorners.begin(), sortedCorners.end(), corners->GetPointer(0));
  surface.cells = std::move(cells);
  surface.edges = std::move(edges);
}

} // namespace mote
