#include "detail/SurfaceShader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace mote
{

SurfaceShader::SurfaceShader(const SurfaceObject& object)
  : object_(object)
{
  const Mat3d linear(object.toWorld);
  isIdentity_ = linear == Mat3d(1.0);
  lengthToLocal_ = 1.0 / std::cbrt(std::abs(glm::determinant(linear)));
  const Mat3d normals = glm::transpose(glm::inverse(linear));
  // Only directions count: a common factor keeps the numbers within float's range.
  double largest = 0.0;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      largest = std::max(largest, std::abs(normals[column][row]));
  normalToWorld_ = glm::mat3(largest > 0.0 ? normals / largest : normals);
  normalToLocal_ = glm::mat3(glm::transpose(linear) * (largest > 0.0 ? largest : 1.0));
  isCut_ = !object.clip.isAll() && withSurface(object.surface, [](const auto& s)
                                     { return std::decay_t<decltype(s)>::isConvex; });
}

void SurfaceShader::gather(const RayBundle& local, std::int32_t index, const std::uint8_t* skipped,
  SurfaceBlock& block) const
{
  int count = 0;
  for (int i = 0; i < local.count; ++i)
  {
    block.ray[count] = static_cast<std::uint16_t>(i);
    count += local.object[i] == index && skipped[i] == 0;
  }
  block.count = count;
  block.surface = index;
  const auto take = [&](const auto* from, auto* to)
  {
    if (count == local.count) // as a rule
      std::copy_n(from, count, to);
    else
      for (int k = 0; k < count; ++k)
        to[k] = from[block.ray[k]];
  };
  take(local.slot, block.slot);
  if (usesMaps())
    object_.occlusion->fetch(block.slot, count);
  take(local.t, block.t);
  take(local.x, block.rayX);
  take(local.y, block.rayY);
  withSurface(object_.surface, [&](const auto& s) { s.fetch(block); });
}

namespace
{

/// Takes what colours are mixed from, where the surface's are; else false.
template <typename Kind, typename PointOf>
bool takeMix(
  const Kind& surface, const std::uint64_t* slots, int count, const PointOf& pointOf, ColorMix& mix)
{
  if (!surface.mixesColors())
    return false;
  Vec3d points[SurfaceBlock::capacity];
  for (int k = 0; k < count; ++k)
    points[k] = pointOf(k);
  surface.mixColors(slots, points, count, mix);
  return true;
}

} // namespace

namespace
{

/// The share of a pixel that a line along an edge covers, half of its width on this cell. Cells of
/// few pixels would be nothing but lines: theirs fade.
float edgeShare(const EdgeSeen& edge, double pixel, double width)
{
  if (!(pixel > 0.0) || !std::isfinite(edge.distance))
    return 0.0f;
  const double covered = std::clamp(0.5 + 0.5 * width - edge.distance / pixel, 0.0, 1.0);
  const double fading = std::clamp(edge.extent / pixel / (4.0 * width) - 0.5, 0.0, 1.0);
  return static_cast<float>(covered * fading);
}

/// Gives hits that stand for many the colours of the means.
template <typename Kind>
void takeMeans(const Kind& surface, const SurfaceColoring& coloring, const std::uint64_t* slots,
  int count, float (*colors)[4])
{
  std::uint64_t places[SurfaceBlock::capacity];
  int hit[SurfaceBlock::capacity], found = 0;
  for (int k = 0; k < count; ++k)
  {
    places[found] = surface.meanPlace(slots[k]);
    hit[found] = k;
    found += places[found] != RayBundle::noHit;
  }
  float means[SurfaceBlock::capacity][4];
  coloring.fillMeans(places, found, means);
  for (int k = 0; k < found; ++k)
    std::copy_n(means[k], 4, colors[hit[k]]);
}

} // namespace

/// Gives hits the colours of the values that the surface itself knows; false where it knows none.
template <typename PointOf>
bool SurfaceShader::takeValues(
  const std::uint64_t* slots, int count, const PointOf& pointOf, float (*colors)[4]) const
{
  return withSurface(object_.surface,
    [&](const auto& s)
    {
      if constexpr (std::decay_t<decltype(s)>::hasValues)
      {
        Vec3d points[SurfaceBlock::capacity];
        for (int k = 0; k < count; ++k)
          points[k] = pointOf(k);
        double values[SurfaceBlock::capacity];
        s.values(slots, points, count, values);
        object_.coloring.fill(values, count, colors);
        return true;
      }
      return false;
    });
}

/// Draws lines along the edges of cells into the colours of a block.
void SurfaceShader::drawEdges(SurfaceBlock& block, const BundlePlacing& placing) const
{
  const EdgeLook& look = object_.edges;
  if (!(look.width > 0.0))
    return;
  withSurface(object_.surface,
    [&](const auto& s)
    {
      if constexpr (std::decay_t<decltype(s)>::hasEdges)
      {
        Vec3d points[SurfaceBlock::capacity], ways[SurfaceBlock::capacity];
        EdgeSeen found[SurfaceBlock::capacity];
        for (int k = 0; k < block.count; ++k)
        {
          ways[k] = placing.local.directionOf(block.ray[k]);
          points[k] = placing.local.originOf(block.ray[k]) + block.t[k] * ways[k];
        }
        s.edges(block.slot, points, ways, block.count, found);
        for (int k = 0; k < block.count; ++k)
        {
          const double pixel =
            lengthToLocal_ * (placing.world.footprint + block.t[k] * placing.world.footprintPerT);
          const float share = look.color.a * edgeShare(found[k], pixel, look.width);
          for (int c = 0; c < 3; ++c)
            block.color[k][c] += share * (look.color[c] - block.color[k][c]);
          if (block.color[k][3] > 0.0f) // else there is nothing to have edges
            block.color[k][3] += share * (1.0f - block.color[k][3]);
        }
      }
    });
}

/// Colours of up to SurfaceBlock::capacity hits; pointOf(k) is where hit k lies, in the surface's
/// coordinates.
template <typename PointOf>
void SurfaceShader::fillColors(
  const std::uint64_t* slots, int count, const PointOf& pointOf, float (*colors)[4]) const
{
  const SurfaceColoring& coloring = object_.coloring;
  if (this->takeValues(slots, count, pointOf, colors))
    return;
  if (!coloring.usesIndices())
    return coloring.fill(slots, count, colors);
  withSurface(object_.surface,
    [&](const auto& s)
    {
      using Kind = std::decay_t<decltype(s)>;
      ColorMix mix;
      bool isMixed = false;
      if constexpr (Kind::mayMixColors)
        isMixed = takeMix(s, slots, count, pointOf, mix);
      if (isMixed)
        coloring.fill(mix, count, colors);
      else
      {
        std::uint64_t indices[SurfaceBlock::capacity];
        s.colorIndices(slots, count, indices);
        coloring.fill(indices, count, colors);
      }
      if constexpr (Kind::mayErr)
        if (s.pixelsOfError() > 0.0 && !coloring.means.empty())
          takeMeans(s, coloring, slots, count, colors);
    });
}

float SurfaceShader::sideOpacity(std::uint64_t slot, const Vec3d& local, const Vec3d& way) const
{
  const Vec3d outward =
    withSurface(object_.surface, [&](const auto& s) { return s.normalAt(slot, local); });
  return glm::dot(outward, way) > 0.0 ? object_.backOpacity.value_or(object_.material.opacity)
                                      : object_.material.opacity;
}

Vec4f SurfaceShader::colorOf(std::uint64_t slot, const Vec3d& local) const
{
  float color[1][4];
  this->fillColors(
    &slot, 1, [&](int) { return local; }, color);
  return {color[0][0], color[0][1], color[0][2], color[0][3]};
}

std::optional<Vec3d> cutFaceAt(const SurfaceObject& object, const Vec3d& point, double distance)
{
  const bool isSolid =
    withSurface(object.surface, [](const auto& s) { return std::decay_t<decltype(s)>::isConvex; });
  if (object.clip.isAll() || !isSolid)
    return {};
  // What rounding may put the point off the face.
  const Vec3d size = glm::abs(point);
  return object.clip.faceAt(point, 1e-9 * distance + 1e-13 * std::max({size.x, size.y, size.z}));
}

/// Calls take(hit, normal of the face) for hits where a solid was cut.
template <typename Take>
void SurfaceShader::forCuts(
  const SurfaceBlock& block, const BundlePlacing& placing, const Take& take) const
{
  for (int k = 0; isCut_ && k < block.count; ++k)
  {
    const bool fan = placing.world.kind == RayBundle::Kind::CommonOrigin;
    const Vec3d aside =
      double(block.rayX[k]) * placing.world.dx + double(block.rayY[k]) * placing.world.dy;
    const Vec3d origin = fan ? placing.world.origin : placing.world.origin + aside;
    const Vec3d way = fan ? placing.world.direction + aside : placing.world.direction;
    const auto face = cutFaceAt(object_, origin + block.t[k] * way, block.t[k] * glm::length(way));
    if (face && glm::dot(*face, way) <= 0.0)
      take(k, *face);
  }
}

Vec3f SurfaceShader::normalAt(std::uint64_t slot, const Vec3d& local, const Vec3d& way) const
{
  if (isCut_)
    if (const auto face = cutFaceAt(object_, transformPoint(object_.toWorld, local),
          glm::length(transformVector(object_.toWorld, local))))
      return Vec3f(*face);
  const Vec3d outward = withSurface(object_.surface,
    [&](const auto& s)
    {
      if constexpr (std::decay_t<decltype(s)>::mayErr)
        if (s.pixelsOfError() > 0.0 && s.meanPlace(slot) != RayBundle::noHit)
          return s.seenNormalAt(slot, local, way);
      return s.normalAt(slot, local);
    });
  const double largest = std::max({std::abs(outward.x), std::abs(outward.y), std::abs(outward.z)});
  return largest > 0.0 ? glm::normalize(normalToWorld_ * Vec3f(outward / largest)) : Vec3f(0.0f);
}

void SurfaceShader::place(
  SurfaceBlock& block, const BundlePlacing& placing, bool positions, bool ids) const
{
  const HitPlacing hits{placing.local, placing.world, placing.worldOrigin,
    isIdentity_ ? nullptr : &normalToWorld_, positions};
  const auto pointOf = [&](int k)
  {
    const int ray = block.ray[k];
    return placing.local.originOf(ray) + block.t[k] * placing.local.directionOf(ray);
  };
  this->fillColors(block.slot, block.count, pointOf, block.color);
  this->drawEdges(block, placing);
  for (int k = 0; object_.backOpacity && k < block.count; ++k)
    block.color[k][3] *=
      this->sideOpacity(block.slot[k], pointOf(k), placing.local.directionOf(block.ray[k]));
  withSurface(object_.surface,
    [&](const auto& s)
    {
      if (ids)
        s.inputIds(block.slot, block.count, block.id);
      s.place(block, hits);
    });
  forCuts(block, placing,
    [&](int k, const Vec3d& face)
    {
      block.normal.x[k] = static_cast<float>(face.x);
      block.normal.y[k] = static_cast<float>(face.y);
      block.normal.z[k] = static_cast<float>(face.z);
      block.side[k] = 1.0f;
    });
  beginLight(block, object_.material.ambient);
}

namespace
{

bool needsPositions(const Material& material, const SceneLighting& lighting)
{
  if (material.isUnlit)
    return false;
  return (lighting.occlusion && material.ambient > 0.0f) ||
         std::any_of(lighting.lights.begin(), lighting.lights.end(),
           [](const ShadedLight& light)
           { return light.shadows || light.samples.front().kind == Light::Kind::Point; });
}

/// Multiplies the even light that the block has received so far by the open share of the sky.
void darken(SurfaceBlock& block, const AmbientOcclusion* occlusion, float* shares)
{
  float found[SurfaceBlock::capacity];
  const bool known = shares != nullptr;
  if (!known)
    shares = found;
  if (occlusion)
    occlusion->findShares(block, shares, known);
  for (int k = 0; k < block.count; ++k)
  {
    const float share = std::isnan(shares[k]) ? 1.0f : shares[k];
    block.even.x[k] *= share;
    block.even.y[k] *= share;
    block.even.z[k] *= share;
  }
}

/// Lights a block that is placed: fills everything that is left. Positions must be filled where
/// needsPositions() says so, seeds where the lighting has occlusion; `footprint` is as in
/// ShadowCaster::remove(). `shares` are open shares of the sky that maps tell, a hit each, NaN
/// where they know nothing; null: where they know nothing of any. What is unknown is filled.
void lightSurfaces(SurfaceBlock& block, const SurfaceObject& object, const SceneLighting& lighting,
  double footprint, float* shares = nullptr)
{
  const Material& material = object.material;
  if (material.isUnlit)
    return finishSurfaces(block, material, object.evenOpacity());
  const AmbientOcclusion* occlusion = lighting.occlusion ? &*lighting.occlusion : nullptr;
  if ((occlusion || shares) && material.ambient > 0.0f)
    darken(block, occlusion, shares);
  for (const ShadedLight& light : lighting.lights)
    for (const LightSample& sample : light.samples)
    {
      faceLight(block, sample, material.specular > 0.0f);
      if (light.shadows)
        lighting.shadows->remove(block, sample, footprint);
      addLight(block, light.color, material);
    }
  finishSurfaces(block, material, object.evenOpacity());
}

} // namespace

namespace
{

/// Of what no map knows yet, and no rays ask for: about what particles in dense sets see of the
/// sky in the mean, so that baked ones among others are no pattern.
constexpr float typicalShare = 0.6f;

/// The same in drafts, of sets that are dense and others: both are nearer to their mean than if
/// they saw all of the sky.
constexpr float draftShare = 0.7f;

} // namespace

void SurfaceShader::shade(
  SurfaceBlock& block, const BundlePlacing& placing, const SceneLighting& lighting, bool ids) const
{
  const bool positions = needsPositions(object_.material, lighting);
  if (object_.material.isUnlit || (!usesMaps() && !lighting.assumesOcclusion))
  {
    place(block, placing, positions, ids);
    return lightSurfaces(block, object_, lighting, placing.footprint);
  }
  OcclusionLookUp found; // texels are on their way while surfaces are placed
  if (usesMaps())
    object_.occlusion->find(block.slot, block.count, found);
  place(block, placing, positions, ids);
  float shares[SurfaceBlock::capacity];
  std::fill_n(shares, block.count, std::numeric_limits<float>::quiet_NaN());
  if (usesMaps())
    lookUpShares(block, found, shares);
  // Maps are of the whole: what lay before a cut is not there.
  forCuts(block, placing, [&](int k, const Vec3d&) { shares[k] = 1.0f; });
  for (int k = 0; k < block.count && !lighting.occlusion; ++k)
    if (std::isnan(shares[k]) && block.side[k] > 0.0f)
      shares[k] = usesMaps() ? typicalShare : draftShare;
  lightSurfaces(block, object_, lighting, placing.footprint, shares);
}

/// What the maps know; of spheres that are seen from within they know nothing.
void SurfaceShader::lookUpShares(
  const SurfaceBlock& block, const OcclusionLookUp& found, float* shares) const
{
  const SurfaceBlock::Triple<float>* normals = &block.normal;
  SurfaceBlock::Triple<float> local;
  if (!isIdentity_)
  {
    for (int k = 0; k < block.count; ++k)
    {
      const Vec3f normal = glm::normalize(
        normalToLocal_ * Vec3f(block.normal.x[k], block.normal.y[k], block.normal.z[k]));
      local.x[k] = normal.x;
      local.y[k] = normal.y;
      local.z[k] = normal.z;
    }
    normals = &local;
  }
  object_.occlusion->lookUp(found, block.slot, normals->x, normals->y, normals->z, shares);
  for (int k = 0; k < block.count; ++k)
    shares[k] = block.side[k] > 0.0f ? shares[k] : std::numeric_limits<float>::quiet_NaN();
}

} // namespace mote
