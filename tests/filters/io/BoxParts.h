#ifndef MoteBoxParts_h
#define MoteBoxParts_h

#include "MeshSamples.h"

#include <array>
#include <functional>
#include <vector>

/// The box of MeshSamples.h, as those that write it want it: points, cells and faces.
namespace samples
{

constexpr int nx = cells[0], ny = cells[1], nz = cells[2];
constexpr int count = nx * ny * nz;
constexpr int pointCount = (nx + 1) * (ny + 1) * (nz + 1);

inline int pointAt(int i, int j, int k)
{
  return i + (nx + 1) * (j + (ny + 1) * k);
}

inline int cellAt(int i, int j, int k)
{
  return i + nx * (j + ny * k);
}

using Place = std::array<double, 3>;

inline std::vector<Place> places(double firstX = 0.0)
{
  std::vector<Place> all;
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i)
        all.push_back({firstX + i, double(j), double(k)});
  return all;
}

inline std::array<int, 8> hexahedron(int i, int j, int k)
{
  return {pointAt(i, j, k), pointAt(i + 1, j, k), pointAt(i + 1, j + 1, k), pointAt(i, j + 1, k),
    pointAt(i, j, k + 1), pointAt(i + 1, j, k + 1), pointAt(i + 1, j + 1, k + 1),
    pointAt(i, j + 1, k + 1)};
}

inline void forCells(const std::function<void(int, int, int)>& visit)
{
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        visit(i, j, k);
}

using Quad = std::array<int, 4>;

/// The face of a cell that points along an axis, forwards or backwards; its normal points out.
inline Quad faceOf(int i, int j, int k, int axis, bool isForwards)
{
  const auto at = [&](int a, int b, int c) { return pointAt(i + a, j + b, k + c); };
  const int d = isForwards ? 1 : 0;
  Quad quad = axis == 0   ? Quad{at(d, 0, 0), at(d, 1, 0), at(d, 1, 1), at(d, 0, 1)}
              : axis == 1 ? Quad{at(0, d, 0), at(0, d, 1), at(1, d, 1), at(1, d, 0)}
                          : Quad{at(0, 0, d), at(1, 0, d), at(1, 1, d), at(0, 1, d)};
  if (!isForwards)
    std::swap(quad[1], quad[3]);
  return quad;
}

struct Face
{
  Quad points;
  int owner;
};

/// The faces of the box along an axis, at one of its ends.
inline std::vector<Face> facesAt(int axis, bool isLast)
{
  std::vector<Face> faces;
  forCells(
    [&](int i, int j, int k)
    {
      const int at[3] = {i, j, k};
      if (at[axis] == (isLast ? cells[axis] - 1 : 0))
        faces.push_back({faceOf(i, j, k, axis, isLast), cellAt(i, j, k)});
    });
  return faces;
}

inline std::vector<Face> wallFaces()
{
  std::vector<Face> walls;
  for (int axis : {1, 2})
    for (bool isLast : {false, true})
      for (const Face& face : facesAt(axis, isLast))
        walls.push_back(face);
  return walls;
}

} // namespace samples

#endif
