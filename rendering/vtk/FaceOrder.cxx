#include "FaceOrder.h"

#include "SurfaceTriangles.h"

#include "vtkIdTypeArray.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace mote
{

namespace
{

/// The triangles of a face, which follow one another.
struct OrderedFace
{
  std::size_t first, end;
};

std::vector<OrderedFace> facesOf(const SurfaceTriangles& surface)
{
  std::vector<OrderedFace> faces;
  std::size_t within = 0; // sides between its triangles, which two of them have
  for (std::size_t t = 0, first = 0; t < surface.cells.size(); ++t)
  {
    if (!surface.edges.empty())
      within += 3 - static_cast<std::size_t>(std::popcount(surface.edges[t] & 7U));
    if (within != 2 * (t - first) && t + 1 < surface.cells.size())
      continue;
    faces.push_back({first, t + 1});
    first = t + 1;
    within = 0;
  }
  return faces;
}

} // namespace

void sortFaces(vtkIdTypeArray* corners, SurfaceTriangles& surface)
{
  std::vector<OrderedFace> faces = facesOf(surface);
  const vtkIdType* const p = corners->GetPointer(0);
  const auto key = [&](const OrderedFace& face)
  {
    const vtkIdType* const of = p + 3 * face.first;
    return std::tuple(surface.cells[face.first], of[0], of[1], of[2]);
  };
  const auto isLess = [&](const OrderedFace& a, const OrderedFace& b)
  { return std::tuple(key(a), a.first) < std::tuple(key(b), b.first); };
  if (std::is_sorted(faces.begin(), faces.end(), isLess))
    return;
  tbb::parallel_sort(faces.begin(), faces.end(), isLess);
  std::vector<vtkIdType> sortedCorners, cells;
  std::vector<std::uint8_t> edges;
  sortedCorners.reserve(3 * surface.cells.size());
  cells.reserve(surface.cells.size());
  for (const OrderedFace& face : faces)
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
