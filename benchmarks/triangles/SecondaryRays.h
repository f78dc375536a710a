#pragma once

#include "../particles/OcclusionRays.h"
#include "TriangleImage.h"

#include <kernels/core/Camera.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace mote::bench
{

/// What rays are cast for.
enum class TriangleTask : std::uint8_t
{
  Primary,   ///< a ray through every pixel: what it meets first
  Occlusion, ///< in all directions from what is seen, a tenth of the longest side long: anything?
  Shadow,    ///< from what is seen and faces the light to that: anything?
  Reflection ///< as if all that is seen were a mirror: what they meet first
};
constexpr std::array<TriangleTask, 4> triangleTasks = {
  TriangleTask::Primary, TriangleTask::Occlusion, TriangleTask::Shadow, TriangleTask::Reflection};

const char* nameOf(TriangleTask task);

/// Rays that leave what a picture shows; those of 8x8 pixels stand side by side.
struct SecondaryRays
{
  OcclusionRays rays;
  /// How far neighbouring pixels are apart in the world where the rays start, for each packet its
  /// least, and by how much more behind each unit of length.
  std::vector<double> width;
  double widthPerLength = 0.0;

  double widthOf(const OcclusionRays::Packet& packet) const
  {
    return width[static_cast<std::size_t>(&packet - rays.packets.data())];
  }
};

/// Those of a task; none for primary rays. The picture is an exact one by that camera of triangles
/// within the bounds.
SecondaryRays secondaryRays(
  TriangleTask task, const TriangleImage& image, const CameraRays& camera, const Box& bounds);

/// Towards the light, which is far away and has no size; of unit length.
Vec3d towardsLight();

/// What the rays of a packet meet first: t is infinite for nothing, normals have any length.
struct alignas(64) PacketHits
{
  float t[OcclusionRays::packetRays];
  std::uint32_t triangle[OcclusionRays::packetRays];
  float normal[3][OcclusionRays::packetRays];
};

} // namespace mote::bench
