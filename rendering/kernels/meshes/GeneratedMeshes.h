#pragma once

#include "TriangleMesh.h"

#include <cstddef>
#include <string_view>

namespace mote
{

/// Triangles over shared points that own their numbers.
struct GeneratedMesh
{
  RawVector<Vec3f> points;
  RawVector<TriangleMesh::Corners> triangles;
};

constexpr std::size_t leastGenerated = 100, mostGenerated = std::size_t{1} << 29;

/// The number of triangles that a text names. Throws Error where it is no whole number from
/// leastGenerated to mostGenerated.
std::size_t triangleCountIn(std::string_view text);

/// A closed sphere about the origin of about `count` triangles and radius 1, two triangles for each
/// cell of longitude and latitude, displaced in waves of a 40th and of a 500th of its size. The
/// same on any number of threads.
GeneratedMesh displacedSphere(std::size_t count);

/// A mesh whose triangles are cut into four until it has about `count`, its own number times a
/// power of four; then points are moved along their normals, in waves of a few edges, so that what
/// was flat is flat no more.
GeneratedMesh subdivided(GeneratedMesh mesh, std::size_t count);

} // namespace mote
