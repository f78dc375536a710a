#include "detail/PathTracer.h"

#include "../shading/SampleSequence.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote
{

namespace
{

/// Paths end by chance only behind so many surfaces.
constexpr int sureBounces = 3;
/// Slope of metals behind a diffuse surface, at least.
constexpr float slopeBehindDiffuse = 0.3f;
/// What the random numbers of a bounce are for; lights follow.
enum Purpose : std::uint32_t
{
  Direction,
  Choice,
  FirstLight
};

} // namespace

/// The end of a path: a surface, and what its light is worth at the camera.
struct PathTracer::Path
{
  Vec3d position; ///< from the reference point
  Vec3f normal;   ///< towards where the path comes from
  Vec3f out;      ///< there
  Vec3f weight;
  Reflectance reflectance;
  std::uint64_t slot;
  std::int32_t surface;
  bool isOutside; ///< not within a solid
  bool isDiffuse; ///< there was a diffuse surface before
  double width;   ///< how far the paths of neighbouring pixels are apart there, if mirrors are flat
  std::uint32_t seed;
  std::uint16_t hit; ///< of the block
};

/// The paths of a block.
struct PathTracer::Work
{
  int count = 0;
  Path paths[SurfaceBlock::capacity];
  Vec3f light[SurfaceBlock::capacity]; ///< that the hits send to the camera
  double widthPerLength = 0.0;         ///< as SurfaceBlock has it
  RayPacket packet;
  Departures from;
  int path[RayPacket::capacity];      ///< that each ray belongs to
  Vec3f carried[RayPacket::capacity]; ///< light that arrives if nothing stands in the way

  /// Adds a ray from the end of a path, which does not meet where it starts. An error may be larger
  /// by `perT` behind each unit of length.
  void addRay(const SceneRays& rays, int index, const Vec3f& direction, double tMax, double perT)
  {
    const Path& start = paths[index];
    const int k = packet.count++;
    packet.footprint = k > 0 ? std::min(packet.footprint, start.width) : start.width;
    packet.footprintPerT = k > 0 ? std::min(packet.footprintPerT, perT) : perT;
    for (int axis = 0; axis < 3; ++axis)
    {
      packet.origin[axis][k] = start.position[axis];
      packet.direction[axis][k] = direction[axis];
    }
    rays.leave(packet, k, from, start.surface, start.slot,
      std::max(1e-9, double(glm::dot(direction, start.normal))));
    packet.t[k] = tMax;
    packet.slot[k] = RayPacket::noHit;
    packet.object[k] = -1;
    path[k] = index;
  }
};

PathTracer::PathTracer(const SceneRays& rays, const std::vector<SurfaceShader>& shaders,
  const CameraRays& camera, int filmSample)
  : rays_(rays)
  , shaders_(shaders)
  , sample_(static_cast<std::uint32_t>(filmSample))
{
  const bool isFan = camera.ox == Vec3d(0.0) && camera.oy == Vec3d(0.0);
  for (Light light : rays.scene().lights)
  {
    if (light.color == Vec3f(0.0f))
      continue;
    if (light.kind == Light::Kind::Headlight)
    {
      light.kind = isFan ? Light::Kind::Point : Light::Kind::Directional;
      light.vector = isFan ? rays.reference() : camera.d0;
      light.size = 0.0;
    }
    LightSquare square(light, rays.scene().bounds().center());
    if (!square.isLight())
      continue;
    square.move(-rays.reference());
    lights_.push_back({square, light.color});
  }
}

/// Starts a path at each hit of the block.
void PathTracer::begin(Work& work, const SurfaceBlock& block) const
{
  for (int k = 0; k < block.count; ++k)
  {
    work.light[k] = Vec3f(0.0f);
    Path& path = work.paths[work.count];
    path.position = {block.position.x[k], block.position.y[k], block.position.z[k]};
    path.normal = {block.normal.x[k], block.normal.y[k], block.normal.z[k]};
    path.out = {block.toEye.x[k], block.toEye.y[k], block.toEye.z[k]};
    path.weight = Vec3f(1.0f);
    path.slot = block.slot[k];
    path.surface = block.surface;
    path.isOutside = block.side[k] > 0.0f;
    path.isDiffuse = false;
    path.width = block.width;
    path.seed = block.seed[k];
    path.hit = static_cast<std::uint16_t>(k);
    work.count += meet(work, path, Vec3f(block.color[k][0], block.color[k][1], block.color[k][2]));
  }
}

/// Gives the path the reflectance of the surface where it ends. False where it ends for good.
bool PathTracer::meet(Work& work, Path& path, const Vec3f& color) const
{
  const Material& m = rays_.surface(path.surface).material;
  Reflectance& r = path.reflectance;
  r.metallic = std::clamp(m.metallic, 0.0f, 1.0f);
  if (!(m.diffuse > 0.0f) && !(r.metallic > 0.0f))
  {
    work.light[path.hit] += path.weight * m.ambient * color;
    return false;
  }
  r.color = glm::clamp(color * m.diffuse, Vec3f(0.0f), Vec3f(1.0f));
  r.slope = std::max(
    m.roughness * m.roughness, path.isDiffuse ? slopeBehindDiffuse : Reflectance::smoothest);
  return true;
}

/// Adds what a light sends straight to the ends of the paths.
void PathTracer::addLight(Work& work, std::size_t light, int bounce) const
{
  const auto cast = [&]
  {
    rays_.shadow(work.packet, &work.from);
    for (int k = 0; k < work.packet.count; ++k)
      if (work.packet.t[k] > 0.0)
        work.light[work.paths[work.path[k]].hit] += work.carried[k];
    work.packet.count = 0;
  };
  work.packet.count = 0;
  for (int i = 0; i < work.count; ++i)
  {
    const Path& path = work.paths[i];
    const std::uint32_t seed = mixedBits(
      mixedBits(path.seed, std::uint32_t(bounce)), FirstLight + static_cast<std::uint32_t>(light));
    const glm::dvec2 at = samplePoint(sample_, seed) - 0.5;
    const LightSample sample = lights_[light].square.at(at.x, at.y);
    const bool isPoint = sample.kind == Light::Kind::Point;
    const Vec3d way = isPoint ? sample.place - path.position : sample.place;
    const double distance = glm::length(way);
    if (!(distance > 0.0))
      continue;
    const Vec3f in(way / distance);
    const Vec3f shine = path.reflectance.shine(path.normal, path.out, in);
    if (shine == Vec3f(0.0f))
      continue;
    const int k = work.packet.count;
    // What is off by the width at the surface moves the shadow of a near light by more.
    if (isPoint)
      work.addRay(rays_, i, in, distance, -path.width / distance);
    else
      work.addRay(rays_, i, in, std::numeric_limits<double>::infinity(), 0.0);
    if (path.isOutside) // else the solid itself keeps out what shines from without
    {
      work.packet.slot[k] = path.slot;
      work.packet.object[k] = path.surface;
    }
    work.carried[k] = path.weight * shine * lights_[light].color;
    if (work.packet.count == RayPacket::capacity)
      cast();
  }
  cast();
}

/// Follows the rays of the packet: to the sky, or to the next surface, where paths go on from.
void PathTracer::follow(Work& work, int& arrived) const
{
  rays_.castAtKeepers(work.packet, &work.from);
  const RayPacket& packet = work.packet;
  for (int k = 0; k < packet.count; ++k)
  {
    Path path = work.paths[work.path[k]];
    const Vec3d direction(packet.direction[0][k], packet.direction[1][k], packet.direction[2][k]);
    if (packet.object[k] < 0)
    {
      work.light[path.hit] += path.weight * rays_.scene().sky(direction);
      continue;
    }
    path.surface = packet.object[k];
    const SurfaceShader& shader = shaders_[static_cast<std::size_t>(path.surface)];
    path.position += packet.t[k] * direction;
    path.width += packet.t[k] * work.widthPerLength;
    path.slot = packet.slot[k];
    path.out = Vec3f(-direction);
    const Vec3d local =
      transformPoint(rays_.toLocal(path.surface), rays_.reference() + path.position);
    path.normal =
      shader.normalAt(path.slot, local, transformVector(rays_.toLocal(path.surface), direction));
    if (path.normal == Vec3f(0.0f))
      path.normal = path.out;
    path.isOutside = glm::dot(path.normal, path.out) >= 0.0f;
    if (!path.isOutside)
      path.normal = -path.normal;
    // Arrivals are never more than rays: what they overwrite is done with.
    if (meet(work, path, Vec3f(shader.colorOf(path.slot, local))))
      work.paths[arrived++] = path;
  }
  work.packet.count = 0;
}

/// Sends the paths on to their next surfaces.
void PathTracer::goOn(Work& work, int bounce) const
{
  const bool last = bounce >= rays_.scene().paths.bounces;
  int arrived = 0;
  work.packet.count = 0;
  for (int i = 0; i < work.count; ++i)
  {
    Path& path = work.paths[i];
    const std::uint32_t seed = mixedBits(path.seed, std::uint32_t(bounce));
    const glm::dvec2 choice = samplePoint(sample_, mixedBits(seed, Choice));
    const auto found = path.reflectance.scatter(
      path.normal, path.out, samplePoint(sample_, mixedBits(seed, Direction)), choice.x);
    path.weight *= found.weight;
    path.isDiffuse = path.isDiffuse || found.isDiffuse;
    const float most = std::max({path.weight.x, path.weight.y, path.weight.z});
    if (!(most > 0.0f) || !(glm::dot(found.direction, path.normal) > 0.0f))
      continue;
    if (bounce >= sureBounces)
    {
      const float chance = std::min(most, 1.0f);
      if (choice.y >= chance)
        continue;
      path.weight /= chance;
    }
    work.addRay(
      rays_, i, found.direction, std::numeric_limits<double>::infinity(), work.widthPerLength);
    if (work.packet.count == RayPacket::capacity)
      follow(work, arrived);
  }
  follow(work, arrived);
  work.count = last ? 0 : arrived;
}

void PathTracer::shade(SurfaceBlock& block) const
{
  Work work;
  work.widthPerLength = block.widthPerLength;
  work.packet.onSurface = OnSurface::Start;
  begin(work, block);
  for (int bounce = 1; work.count > 0; ++bounce)
  {
    for (std::size_t light = 0; light < lights_.size(); ++light)
      addLight(work, light, bounce);
    goOn(work, bounce);
  }
  const float opacity = rays_.surface(block.surface).evenOpacity();
  for (int k = 0; k < block.count; ++k)
  {
    const float alpha = block.color[k][3] * opacity;
    for (int c = 0; c < 3; ++c)
      block.out[k][c] = work.light[k][c] * alpha;
    block.out[k][3] = alpha;
  }
}

} // namespace mote
