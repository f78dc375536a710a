#include "Shader.h"

#include <glm/exponential.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace mote
{

ParticleShader::ParticleShader(const ParticleObject& object, const std::vector<Light>& lights)
  : object_(object)
  , lights_(lights)
  , toLocal_(glm::inverse(object.toWorld))
  , normalToWorld_(glm::transpose(Mat3d(toLocal_)))
{
}

Vec4f ParticleShader::colorOf(std::uint64_t particle) const
{
  const ParticleColoring& c = object_.coloring;
  if (!c.direct.empty())
  {
    const int n = c.direct.components();
    const auto channel = [&](int k)
    { return static_cast<float>(c.direct.value(particle, k) / 255.0); };
    const float alpha = n == 2 ? channel(1) : n == 4 ? channel(3) : 1.0f;
    return n < 3 ? Vec4f(Vec3f(channel(0)), alpha)
                 : Vec4f(channel(0), channel(1), channel(2), alpha);
  }
  return c.values.empty() ? c.constant : c.map(c.values.value(particle, c.component));
}

Vec3f ParticleShader::lit(
  const Vec3f& color, const Vec3f& normal, const Vec3f& toEye, const Vec3d& position) const
{
  const Material& m = object_.material;
  Vec3f even(m.ambient), highlight(0.0f);
  for (const Light& light : lights_)
  {
    Vec3f toLight = toEye;
    if (light.kind == Light::Kind::Directional)
      toLight = -Vec3f(glm::normalize(light.vector));
    else if (light.kind == Light::Kind::Point)
      toLight = Vec3f(glm::normalize(light.vector - position));
    const float cosine = glm::dot(normal, toLight);
    if (cosine <= 0.0f)
      continue;
    even += light.color * (m.diffuse * cosine);
    if (m.specular > 0.0f)
    {
      const float shine = glm::dot(2.0f * cosine * normal - toLight, toEye);
      if (shine > 0.0f)
        highlight += light.color * (m.specular * std::pow(shine, m.specularPower));
    }
  }
  return glm::min(color * even + m.specularColor * highlight, Vec3f(1.0f));
}

ShadedHit ParticleShader::shade(
  const Vec3d& origin, const Vec3d& direction, double t, std::uint64_t slot) const
{
  const Vec3d position = origin + t * direction;
  Vec3d center(0.0);
  ShadedHit hit;
  withStructure(*object_.structure,
    [&](const auto& s)
    {
      center = s.center(slot);
      hit.particle = s.inputIndex(slot);
    });
  // In double: in float the squares of very small or very large scenes would vanish or overflow.
  const Vec3d outward = normalToWorld_ * (transformPoint(toLocal_, position) - center);
  hit.normal = Vec3f(glm::normalize(outward));
  const Vec3f toEye = -Vec3f(glm::normalize(direction));
  const Vec3f facing = glm::dot(hit.normal, toEye) < 0.0f ? -hit.normal : hit.normal;
  const Vec4f color = colorOf(hit.particle);
  const float alpha = color.a * object_.material.opacity;
  hit.color = Vec4f(lit(Vec3f(color), facing, toEye, position) * alpha, alpha);
  return hit;
}

} // namespace mote
