#include "Shader.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote
{

std::vector<ShadedLight> shadedLights(const Scene& scene, const Vec3d& reference, int filmSample)
{
  std::vector<ShadedLight> lights;
  const auto casts = [](const Light& l) { return l.shadows && l.kind != Light::Kind::Headlight; };
  const bool anyShadows = std::any_of(scene.lights.begin(), scene.lights.end(), casts);
  const Vec3d middle = anyShadows ? scene.bounds().center() : Vec3d(0.0);
  for (const Light& light : scene.lights)
  {
    ShadedLight shaded;
    shaded.samples = lightSamples(light, middle, filmSample);
    if (shaded.samples.empty() || light.color == Vec3f(0.0f))
      continue;
    if (light.kind == Light::Kind::Point)
      for (LightSample& sample : shaded.samples)
        sample.place -= reference;
    shaded.color = light.color / static_cast<float>(shaded.samples.size());
    shaded.shadows = casts(light);
    lights.push_back(std::move(shaded));
  }
  return lights;
}

SceneLighting::SceneLighting(const Scene& scene, const Vec3d& reference, int filmSample)
  : lights(shadedLights(scene, reference, filmSample))
{
  const bool anyShadows =
    std::any_of(lights.begin(), lights.end(), [](const auto& light) { return light.shadows; });
  const bool anyOcclusion = scene.occlusion.rays > 0;
  if (anyShadows || anyOcclusion)
    rays.emplace(scene, reference);
  if (anyShadows)
    shadows.emplace(*rays);
  if (anyOcclusion)
    occlusion.emplace(*rays, filmSample);
}

ParticleShader::ParticleShader(const ParticleObject& object)
  : object_(object)
{
  const Mat3d linear(object.toWorld);
  isIdentity_ = linear == Mat3d(1.0);
  const Mat3d normals = glm::transpose(glm::inverse(linear));
  // Only directions count: a common factor keeps the numbers within float's range.
  double largest = 0.0;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      largest = std::max(largest, std::abs(normals[column][row]));
  normalToWorld_ = glm::mat3(largest > 0.0 ? normals / largest : normals);
  normalToLocal_ = glm::mat3(glm::transpose(linear) * (largest > 0.0 ? largest : 1.0));
}

void ParticleShader::gather(const RayBundle& local, std::int32_t index, const std::uint8_t* skipped,
  SurfaceBlock& block) const
{
  int count = 0;
  for (int i = 0; i < local.count; ++i)
  {
    block.ray[count] = static_cast<std::uint16_t>(i);
    count += local.object[i] == index && skipped[i] == 0;
  }
  block.count = count;
  block.object = index;
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
  withStructure(*object_.structure,
    [&](const auto& s)
    {
      for (int k = 0; k < count; ++k)
      {
        const Vec3d center = s.center(block.slot[k]);
        block.center.x[k] = center.x;
        block.center.y[k] = center.y;
        block.center.z[k] = center.z;
        block.radius[k] = s.radius(block.slot[k]);
      }
    });
}

/// Colours of up to SurfaceBlock::capacity particles, by input index.
void ParticleShader::fillColors(const std::uint64_t* particles, int count, float (*colors)[4]) const
{
  const ParticleColoring& c = object_.coloring;
  const auto set = [&](int k, float red, float green, float blue, float alpha)
  {
    colors[k][0] = red;
    colors[k][1] = green;
    colors[k][2] = blue;
    colors[k][3] = alpha;
  };
  if (!c.direct.empty())
  {
    const int n = c.direct.components();
    const bool isGrey = n < 3, hasAlpha = n == 2 || n == 4;
    for (int k = 0; k < count; ++k)
    {
      const auto channel = [&](int channel)
      { return static_cast<float>(c.direct.value(particles[k], channel) / 255.0); };
      const float first = channel(0);
      set(k, first, isGrey ? first : channel(1), isGrey ? first : channel(2),
        hasAlpha ? channel(n - 1) : 1.0f);
    }
  }
  else if (!c.values.empty())
  {
    // Values come from anywhere in memory: with nothing else in the loop many are on their way.
    double values[SurfaceBlock::capacity];
    for (int k = 0; k < count; ++k)
      values[k] = c.values.value(particles[k], c.component);
    c.map.map(values, count, colors);
  }
  else
    for (int k = 0; k < count; ++k)
      set(k, c.constant.r, c.constant.g, c.constant.b, c.constant.a);
}

bool ParticleShader::needsIndices() const
{
  return !object_.coloring.direct.empty() || !object_.coloring.values.empty();
}

Vec4f ParticleShader::colorOf(std::uint64_t slot) const
{
  const std::uint64_t particle =
    needsIndices()
      ? withStructure(*object_.structure, [&](const auto& s) { return s.inputIndex(slot); })
      : slot;
  float color[1][4];
  fillColors(&particle, 1, color);
  return {color[0][0], color[0][1], color[0][2], color[0][3]};
}

Vec3f ParticleShader::normalAt(std::uint64_t slot, const Vec3d& local) const
{
  const Vec3d outward = withStructure(
    *object_.structure, [&](const auto& s) { return (local - s.center(slot)) / s.radius(slot); });
  return glm::normalize(normalToWorld_ * Vec3f(outward));
}

void ParticleShader::place(
  SurfaceBlock& block, const BundlePlacing& placing, bool positions, bool indices) const
{
  if (indices || needsIndices())
    withStructure(*object_.structure,
      [&](const auto& s)
      {
        for (int k = 0; k < block.count; ++k)
          block.particle[k] = s.inputIndex(block.slot[k]);
      });
  fillColors(block.particle, block.count, block.color);
  SurfacePlacing surfaces;
  surfaces.local = &placing.local;
  surfaces.world = &placing.world;
  surfaces.worldOrigin = placing.worldOrigin;
  surfaces.normalToWorld = isIdentity_ ? nullptr : &normalToWorld_;
  surfaces.positions = positions;
  placeSurfaces(block, surfaces, object_.material.ambient);
}

void ParticleShader::shade(SurfaceBlock& block, const BundlePlacing& placing,
  const SceneLighting& lighting, bool indices) const
{
  const bool positions = needsPositions(object_.material, lighting);
  if (!usesMaps())
  {
    place(block, placing, positions, indices);
    return lightSurfaces(block, object_.material, lighting, placing.footprint);
  }
  OcclusionLookUp found; // texels are on their way while surfaces are placed
  object_.occlusion->find(block.slot, block.count, found);
  place(block, placing, positions, indices);
  float shares[SurfaceBlock::capacity];
  lookUpShares(block, found, shares);
  lightSurfaces(block, object_.material, lighting, placing.footprint, shares);
}

/// What the maps know; of spheres that are seen from within they know nothing.
void ParticleShader::lookUpShares(
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

bool needsPositions(const Material& material, const SceneLighting& lighting)
{
  return (lighting.occlusion && material.ambient > 0.0f) ||
         std::any_of(lighting.lights.begin(), lighting.lights.end(),
           [](const ShadedLight& light)
           { return light.shadows || light.samples.front().kind == Light::Kind::Point; });
}

namespace
{

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

} // namespace

void lightSurfaces(SurfaceBlock& block, const Material& material, const SceneLighting& lighting,
  double footprint, float* shares)
{
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
  finishSurfaces(block, material);
}

} // namespace mote
