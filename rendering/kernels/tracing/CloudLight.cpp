#include "detail/CloudLight.h"

#include <algorithm>
#include <cmath>

namespace mote
{

Vec3d CloudLight::operator()(
  const Vec3d& color, const Vec3d& position, const Vec3d& normal, const Vec3d& toEye) const
{
  if (normal == Vec3d(0.0))
    return color * std::min(1.0, double(material_.ambient) + material_.diffuse);
  const Vec3d n = glm::dot(normal, toEye) < 0.0 ? -normal : normal;
  Vec3d even(material_.ambient), highlight(0.0);
  for (const ShadedLight& light : lights_)
    for (const LightSample& sample : light.samples)
    {
      const Vec3d towards = sample.kind == Light::Kind::Headlight     ? toEye
                            : sample.kind == Light::Kind::Directional ? sample.place
                                                                      : sample.place - position;
      const double length = glm::length(towards);
      const double cosine = length > 0.0 ? glm::dot(n, towards) / length : 0.0;
      if (cosine <= 0.0)
        continue;
      even += double(material_.diffuse) * cosine * Vec3d(light.color);
      const double shine = 2.0 * cosine * glm::dot(n, toEye) - glm::dot(towards, toEye) / length;
      if (material_.specular > 0.0f && shine > 0.0)
        highlight += double(material_.specular) * std::pow(shine, double(material_.specularPower)) *
                     Vec3d(light.color);
    }
  return color * even + highlight * Vec3d(material_.specularColor);
}

} // namespace mote
