#include "GeneratedMeshes.h"

#include "../core/Error.h"

#include <tbb/parallel_for.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <unordered_map>
#include <vector>

namespace mote
{

using Corners = TriangleMesh::Corners;

std::size_t triangleCountIn(std::string_view text)
{
  std::size_t count = 0;
  const char* end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, count);
  if (error != std::errc() || at != end || count < leastGenerated || count > mostGenerated)
    throw Error('"' + std::string(text) + "\" is no number of triangles from " +
                std::to_string(leastGenerated) + " to " + std::to_string(mostGenerated) + ".");
  return count;
}

GeneratedMesh displacedSphere(std::size_t count)
{
  const auto rows = static_cast<std::size_t>(std::sqrt(static_cast<double>(count) / 4.0));
  const std::size_t columns = 2 * rows;
  GeneratedMesh mesh;
  mesh.points.resize((rows + 1) * columns);
  mesh.triangles.resize(2 * rows * columns);
  tbb::parallel_for(std::size_t{0}, rows + 1,
    [&](std::size_t j)
    {
      const double theta = M_PI * static_cast<double>(j) / static_cast<double>(rows);
      for (std::size_t i = 0; i < columns; ++i)
      {
        const double phi = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(columns);
        const double r = 1.0 + 0.05 * std::sin(9.0 * theta) * std::cos(7.0 * phi) +
                         0.004 * std::sin(171.0 * theta) * std::sin(133.0 * phi);
        mesh.points[j * columns + i] = Vec3f(r * std::sin(theta) * std::cos(phi),
          r * std::sin(theta) * std::sin(phi), r * std::cos(theta));
      }
      if (j == rows)
        return;
      Corners* to = &mesh.triangles[2 * j * columns];
      for (std::size_t i = 0; i < columns; ++i)
      {
        const auto a = static_cast<std::uint32_t>(j * columns + i);
        const auto b = static_cast<std::uint32_t>(j * columns + (i + 1) % columns);
        const auto below = static_cast<std::uint32_t>(columns);
        *to++ = {a, a + below, b};
        *to++ = {b, a + below, b + below};
      }
    });
  return mesh;
}

namespace
{

/// Cuts every triangle into four.
void cutInFour(GeneratedMesh& mesh)
{
  std::unordered_map<std::uint64_t, std::uint32_t> middles;
  middles.reserve(2 * mesh.triangles.size());
  const auto middleOf = [&](std::uint32_t a, std::uint32_t b)
  {
    const std::uint64_t edge = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    const auto [at, isNew] =
      middles.try_emplace(edge, static_cast<std::uint32_t>(mesh.points.size()));
    if (isNew)
      mesh.points.push_back(0.5f * (mesh.points[a] + mesh.points[b]));
    return at->second;
  };
  RawVector<Corners> parts;
  parts.reserve(4 * mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles)
  {
    const std::uint32_t ab = middleOf(a, b), bc = middleOf(b, c), ca = middleOf(c, a);
    parts.push_back({a, ab, ca});
    parts.push_back({ab, b, bc});
    parts.push_back({ca, bc, c});
    parts.push_back({ab, bc, ca});
  }
  mesh.triangles.swap(parts);
}

/// Moves the points along their normals, by waves of a few edges: what was flat is flat no more.
void displace(GeneratedMesh& mesh)
{
  std::vector<Vec3f> normals(mesh.points.size(), Vec3f(0.0f));
  double area = 0.0;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    const Vec3f normal =
      glm::cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
    area += 0.5 * glm::length(normal);
    for (const std::uint32_t corner : {a, b, c})
      normals[corner] += normal;
  }
  const auto edge =
    static_cast<float>(std::sqrt(2.0 * area / static_cast<double>(mesh.triangles.size())));
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    const Vec3f at = mesh.points[i] / (1.5f * edge);
    const float wave = std::sin(at.x) * std::sin(at.y + 1.0f) * std::sin(at.z + 2.0f);
    if (const float length = glm::length(normals[i]); length > 0.0f)
      mesh.points[i] += 0.5f * edge * wave / length * normals[i];
  }
}

} // namespace

GeneratedMesh subdivided(GeneratedMesh mesh, std::size_t count)
{
  while (2 * mesh.triangles.size() < count)
    cutInFour(mesh);
  displace(mesh);
  return mesh;
}

} // namespace mote
