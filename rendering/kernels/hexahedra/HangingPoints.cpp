#include "HangingPoints.h"

#include "HangingFaces.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <algorithm>

namespace mote
{

namespace
{

/// Where in a bilinear patch, from 0 to 1 along both, a point lies that is nearest to another.
glm::dvec2 placeIn(const std::array<Vec3d, 4>& p, const Vec3d& point)
{
  glm::dvec2 at(0.5);
  for (int step = 0; step < 8; ++step)
  {
    const double u = at.x, v = at.y;
    const Vec3d here =
      (1.0 - v) * ((1.0 - u) * p[0] + u * p[1]) + v * ((1.0 - u) * p[3] + u * p[2]);
    const Vec3d alongU = (1.0 - v) * (p[1] - p[0]) + v * (p[2] - p[3]);
    const Vec3d alongV = (1.0 - u) * (p[3] - p[0]) + u * (p[2] - p[1]);
    const Vec3d off = point - here;
    const double uu = glm::dot(alongU, alongU), vv = glm::dot(alongV, alongV);
    const double uv = glm::dot(alongU, alongV), size = uu * vv - uv * uv;
    if (!(size > 0.0))
      break;
    const double du = glm::dot(off, alongU), dv = glm::dot(off, alongV);
    at = glm::clamp(at + glm::dvec2(vv * du - uv * dv, uu * dv - uv * du) / size, 0.0, 1.0);
  }
  return at;
}

std::array<float, 4> weightsAt(const glm::dvec2& at)
{
  const double u = at.x, v = at.y;
  return {static_cast<float>((1.0 - u) * (1.0 - v)), static_cast<float>(u * (1.0 - v)),
    static_cast<float>(u * v), static_cast<float>((1.0 - u) * v)};
}

} // namespace

std::vector<HangingPoint> hangingPointsOf(const HexMesh& mesh)
{
  const FaceAdjacency adjacency(mesh);
  const FaceTriangles faces(mesh, adjacency.boundary());
  if (faces.edges.empty())
    return {};
  const ArrayView triangles(faces.corners.data(), ArrayView::Type::UInt32, faces.edges.size(), 3);
  const ArrayView points(&mesh.point(0).x, mesh.allPointCount(), 3);
  std::vector<HangingPoint> found;
  std::vector<bool> hangs(mesh.allPointCount(), false);
  for (const CoveredFace& face : coveredFaces({triangles, points, faces.edges, {}}))
  {
    // A quadrilateral is two triangles, 0 1 2 and 0 2 3.
    const std::uint32_t* first = &faces.corners[3 * face.larger.first];
    const bool isTriangle = face.larger.end - face.larger.first == 1;
    const std::array<std::uint32_t, 4> corners = {
      first[0], first[1], first[2], isTriangle ? first[2] : first[5]};
    std::array<Vec3d, 4> at;
    std::transform(
      corners.begin(), corners.end(), at.begin(), [&](std::uint32_t id) { return mesh.point(id); });
    for (const FaceRange& smaller : face.smaller)
      for (std::size_t i = 3 * smaller.first; i < 3 * smaller.end; ++i)
      {
        const std::uint32_t id = faces.corners[i];
        if (hangs[id] || std::find(corners.begin(), corners.end(), id) != corners.end())
          continue;
        hangs[id] = true;
        found.push_back({id, corners, weightsAt(placeIn(at, mesh.point(id)))});
      }
  }
  return found;
}

} // namespace mote
