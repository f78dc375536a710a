#include "Reflectance.h"

#include "../core/RayBundle.h"

#include <algorithm>
#include <cmath>

namespace mote
{

namespace
{

/// Schlick's approximation of Fresnel's factor.
Vec3f fresnel(const Vec3f& color, float cosine)
{
  const float rest = 1.0f - std::clamp(cosine, 0.0f, 1.0f);
  return color + (Vec3f(1.0f) - color) * (rest * rest * rest * rest * rest);
}

/// Smith's Lambda of a direction at a cosine to the normal.
float masking(float cosine, float slope)
{
  const float c2 = cosine * cosine;
  return 0.5f * (std::sqrt(1.0f + slope * slope * (1.0f - c2) / c2) - 1.0f);
}

/// A normal of a mirror as seen from `out` (z is the surface's normal), as often as it is seen.
Vec3f visibleMirror(const Vec3f& out, float slope, const glm::dvec2& at)
{
  const Vec3f stretched = glm::normalize(Vec3f(slope * out.x, slope * out.y, out.z));
  const float across = stretched.x * stretched.x + stretched.y * stretched.y;
  const Vec3f u = across > 0.0f ? Vec3f(-stretched.y, stretched.x, 0.0f) / std::sqrt(across)
                                : Vec3f(1.0f, 0.0f, 0.0f);
  const Vec3f v = glm::cross(stretched, u);
  const double radius = std::sqrt(at.x), angle = 2.0 * M_PI * at.y;
  const auto a = static_cast<float>(radius * std::cos(angle));
  const float share = 0.5f * (1.0f + stretched.z);
  const float b = (1.0f - share) * std::sqrt(std::max(0.0f, 1.0f - a * a)) +
                  share * static_cast<float>(radius * std::sin(angle));
  const float c = std::sqrt(std::max(0.0f, 1.0f - a * a - b * b));
  const Vec3f n = a * u + b * v + c * stretched;
  return glm::normalize(Vec3f(slope * n.x, slope * n.y, std::max(1e-6f, n.z)));
}

} // namespace

Vec3d cosineDirection(const Vec3d& normal, const glm::dvec2& at)
{
  Vec3d u, v;
  acrossAxes(normal, u, v);
  const double angle = 2.0 * M_PI * at.y, sine = std::sqrt(at.x);
  return sine * std::cos(angle) * u + sine * std::sin(angle) * v + std::sqrt(1.0 - at.x) * normal;
}

Vec3f Reflectance::shine(const Vec3f& normal, const Vec3f& out, const Vec3f& in) const
{
  const float toLight = glm::dot(normal, in);
  if (!(toLight > 0.0f))
    return Vec3f(0.0f);
  Vec3f sum = (1.0f - metallic) * toLight * color;
  if (metallic > 0.0f)
  {
    const float toEye = std::max(glm::dot(normal, out), 1e-4f);
    const Vec3f mirror = glm::normalize(in + out);
    const float c = std::min(glm::dot(normal, mirror), 1.0f), a2 = slope * slope;
    const float spread = c * c * (a2 - 1.0f) + 1.0f;
    const float density = a2 / (spread * spread); // times pi
    const float open = 1.0f / (1.0f + masking(toEye, slope) + masking(toLight, slope));
    sum += metallic * density * open / (4.0f * toEye) * fresnel(color, glm::dot(in, mirror));
  }
  return sum;
}

Reflectance::Scattering Reflectance::scatter(
  const Vec3f& normal, const Vec3f& out, const glm::dvec2& at, double lobe) const
{
  Scattering found;
  found.isDiffuse = lobe >= metallic;
  if (found.isDiffuse)
  {
    found.direction = Vec3f(cosineDirection(Vec3d(normal), at));
    found.weight = color;
    return found;
  }
  Vec3d u, v;
  acrossAxes(Vec3d(normal), u, v);
  const Vec3f x(u), y(v);
  const float toEye = std::max(glm::dot(normal, out), 1e-4f);
  const Vec3f local(glm::dot(x, out), glm::dot(y, out), toEye);
  const Vec3f mirror = visibleMirror(glm::normalize(local), slope, at);
  const Vec3f in = 2.0f * glm::dot(local, mirror) * mirror - local;
  if (!(in.z > 0.0f))
    return found; // mirrored into the surface: lost
  found.direction = glm::normalize(in.x * x + in.y * y + in.z * normal);
  const float before = 1.0f + masking(toEye, slope);
  found.weight =
    fresnel(color, glm::dot(local, mirror)) * (before / (before + masking(in.z, slope)));
  return found;
}

} // namespace mote
