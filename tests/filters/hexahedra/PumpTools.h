#ifndef MotePumpTools_h
#define MotePumpTools_h

#include <vtkMotePumpSource.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

using Vec = std::array<double, 3>;

inline Vec operator-(const Vec& a, const Vec& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline double dot(const Vec& a, const Vec& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vec cross(const Vec& a, const Vec& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double length(const Vec& a)
{
  return std::sqrt(dot(a, a));
}

inline Vec pointOf(vtkUnstructuredGrid* grid, vtkIdType id)
{
  Vec p;
  grid->GetPoint(id, p.data());
  return p;
}

/// The corners' ids of a hexahedron.
inline std::array<vtkIdType, 8> cornersOf(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  grid->GetCellPoints(cell, count, ids);
  std::array<vtkIdType, 8> corners{};
  if (count == 8)
    std::copy(ids, ids + 8, corners.begin());
  return corners;
}

using Face = std::array<vtkIdType, 4>;

/// How many cells have each face, with the difference of those that see it from either side.
inline std::map<Face, std::pair<int, int>> facesOf(vtkUnstructuredGrid* grid)
{
  static constexpr int faces[6][4] = {
    {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  std::map<Face, std::pair<int, int>> found;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const auto ids = cornersOf(grid, cell);
    for (const auto& face : faces)
    {
      Face corners = {ids[face[0]], ids[face[1]], ids[face[2]], ids[face[3]]};
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      const int side = corners[1] < corners[3] ? 1 : -1;
      std::sort(corners.begin(), corners.end());
      auto& entry = found[corners];
      ++entry.first;
      entry.second += side;
    }
  }
  return found;
}

/// The grid of one part, 1 to 3, at the source's present settings.
inline vtkSmartPointer<vtkUnstructuredGrid> partOf(vtkMotePumpSource* source, int part)
{
  source->SetPart(part);
  source->Update();
  return vtkUnstructuredGrid::SafeDownCast(source->GetOutputDataObject(0));
}

#endif
