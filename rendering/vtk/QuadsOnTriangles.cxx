#include "QuadsOnTriangles.h"

#include "SurfaceTriangles.h"

#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <span>

namespace mote
{

namespace
{

using Triangle = std::array<vtkIdType, 3>; ///< ascending

Triangle sorted(vtkIdType a, vtkIdType b, vtkIdType c)
{
  Triangle t = {a, b, c};
  std::sort(t.begin(), t.end());
  return t;
}

/// The triangles among the faces of a cell, as places of its corners.
std::span<const std::array<int, 3>> trianglesOfCell(int type)
{
  static constexpr std::array<int, 3> ofTetrahedron[] = {
    {0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
  static constexpr std::array<int, 3> ofPyramid[] = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  static constexpr std::array<int, 3> ofWedge[] = {{0, 1, 2}, {3, 4, 5}};
  switch (type)
  {
  case VTK_TETRA:
    return ofTetrahedron;
  case VTK_PYRAMID:
    return ofPyramid;
  case VTK_WEDGE:
    return ofWedge;
  default:
    return {};
  }
}

/// Calls visit(a, b, c) for the triangles among the faces of all visible cells, in parallel.
template <typename Visit>
void forTriangles(vtkUnstructuredGrid* grid, vtkUnsignedCharArray* isVisible, const Visit& visit)
{
  tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, grid->GetNumberOfCells(), 1 << 13),
    [&](const tbb::blocked_range<vtkIdType>& range)
    {
      vtkNew<vtkIdList> ids;
      for (vtkIdType cell = range.begin(); cell < range.end(); ++cell)
      {
        const auto faces = trianglesOfCell(grid->GetCellType(cell));
        if (faces.empty() || (isVisible && isVisible->GetValue(cell) == 0))
          continue;
        grid->GetCellPoints(cell, ids);
        for (const auto& face : faces)
          visit(ids->GetId(face[0]), ids->GetId(face[1]), ids->GetId(face[2]));
      }
    });
}

/// Of a quadrilateral without one of its corners.
struct Half
{
  Triangle triangle;
  std::size_t quad;
  int without;

  bool operator<(const Half& other) const { return triangle < other.triangle; }
};

/// The quadrilaterals of a surface, by the first of their two triangles.
class Quads
{
public:
  Quads(vtkIdType points, const std::vector<vtkIdType>& welds)
    : welds_(welds)
    , isOfTriangle_(static_cast<std::size_t>(points), 0)
  {
  }

  /// Notes the points of a face of a cell.
  void mayMeet(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    for (const vtkIdType point : {a, b, c})
      std::atomic_ref(isOfTriangle_[std::size_t(this->place(point))])
        .store(1, std::memory_order_relaxed);
  }

  /// Takes those all of whose corners were noted; whether there are any.
  bool take(const SurfaceTriangles& surface)
  {
    const ArrayView all = surface.view();
    for (std::size_t t = 0; t + 1 < surface.edges.size(); ++t)
    {
      if (surface.cells[t] != surface.cells[t + 1])
        continue;
      // Two triangles with one side within, which both have.
      std::array<vtkIdType, 6> corners;
      for (std::size_t i = 0; i < 6; ++i)
        corners[i] = this->place(static_cast<vtkIdType>(all.value(t + i / 3, int(i % 3))));
      const int inner = sideWithin(surface.edges[t]), other = sideWithin(surface.edges[t + 1]);
      if (inner < 0 || other < 0)
        continue;
      const vtkIdType a = corners[std::size_t(inner)], b = corners[std::size_t((inner + 1) % 3)];
      if (corners[std::size_t(3 + (other + 1) % 3)] != a || corners[std::size_t(3 + other)] != b)
        continue;
      this->add(t++,
        {a, corners[std::size_t(3 + (other + 2) % 3)], b, corners[std::size_t((inner + 2) % 3)]});
    }
    tbb::parallel_sort(halves_.begin(), halves_.end());
    met_.assign(first_.size(), 0);
    return !first_.empty();
  }

  /// Notes a face of a cell.
  void meet(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    const Half wanted = {sorted(this->place(a), this->place(b), this->place(c)), 0, 0};
    const auto [begin, end] = std::equal_range(halves_.begin(), halves_.end(), wanted);
    for (auto half = begin; half != end; ++half)
      std::atomic_ref(met_[half->quad])
        .fetch_or(static_cast<std::uint8_t>(1U << half->without), std::memory_order_relaxed);
  }

  /// Marks the triangles of those that two such faces make up.
  std::vector<std::uint8_t> covered(std::size_t triangles) const
  {
    std::vector<std::uint8_t> marks;
    for (std::size_t q = 0; q < met_.size(); ++q)
      if ((met_[q] & 5U) == 5U || (met_[q] & 10U) == 10U)
      {
        marks.resize(triangles, 0);
        marks[first_[q]] = marks[first_[q] + 1] = 1;
      }
    return marks;
  }

private:
  /// The only side of a triangle that is within its face; -1 for none or several.
  static int sideWithin(std::uint8_t edges)
  {
    return edges == 6 ? 0 : edges == 5 ? 1 : edges == 3 ? 2 : -1;
  }
  vtkIdType place(vtkIdType point) const
  {
    return welds_.empty() ? point : welds_[static_cast<std::size_t>(point)];
  }
  void add(std::size_t first, const std::array<vtkIdType, 4>& p)
  {
    for (const vtkIdType point : p)
      if (isOfTriangle_[static_cast<std::size_t>(point)] == 0)
        return;
    for (std::size_t i = 0; i < 4; ++i)
      halves_.push_back({sorted(p[(i + 1) % 4], p[(i + 2) % 4], p[(i + 3) % 4]), first_.size(),
        static_cast<int>(i)});
    first_.push_back(first);
  }

  const std::vector<vtkIdType>& welds_;
  std::vector<std::uint8_t> isOfTriangle_; ///< of the points
  std::vector<std::size_t> first_;
  std::vector<Half> halves_;
  std::vector<std::uint8_t> met_; ///< a bit for each half of each
};

} // namespace

std::vector<std::uint8_t> quadsOnTriangles(const SurfaceTriangles& surface,
  vtkUnstructuredGrid* grid, vtkUnsignedCharArray* isVisible, const std::vector<vtkIdType>& welds)
{
  std::array<bool, 256> has{};
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    has[static_cast<std::size_t>(grid->GetCellType(cell)) % 256] = true;
  // Of wedges or pyramids alone triangles meet triangles.
  const bool isMixed = has[VTK_TETRA] + has[VTK_PYRAMID] + has[VTK_WEDGE] + has[VTK_HEXAHEDRON] > 1;
  if (!isMixed || surface.edges.empty())
    return {};
  Quads quads(grid->GetNumberOfPoints(), welds);
  forTriangles(
    grid, isVisible, [&](vtkIdType a, vtkIdType b, vtkIdType c) { quads.mayMeet(a, b, c); });
  if (!quads.take(surface))
    return {};
  forTriangles(
    grid, isVisible, [&](vtkIdType a, vtkIdType b, vtkIdType c) { quads.meet(a, b, c); });
  return quads.covered(surface.view().count());
}

} // namespace mote
