#include "PumpShape.h"

#include <algorithm>
#include <cmath>

namespace mote::pump
{

namespace
{

struct Meridional
{
  double radius, z;
};

Meridional bezier(const Meridional (&p)[4], double s)
{
  const double a = 1.0 - s;
  const double w[4] = {a * a * a, 3.0 * a * a * s, 3.0 * a * s * s, s * s * s};
  Meridional at{0.0, 0.0};
  for (int i = 0; i < 4; ++i)
  {
    at.radius += w[i] * p[i].radius;
    at.z += w[i] * p[i].z;
  }
  return at;
}

Meridional impellerAt(double s, double span)
{
  static constexpr Meridional hub[4] = {{hubRadius, 0.0}, {0.18, 0.33}, {0.45, 0.47}, {1.0, 0.47}};
  static constexpr Meridional shroud[4] = {
    {eyeRadius, 0.0}, {0.5, 0.22}, {0.65, 0.35}, {1.0, 0.35}};
  const Meridional inner = bezier(hub, s), outer = bezier(shroud, s);
  return {std::lerp(inner.radius, outer.radius, span), std::lerp(inner.z, outer.z, span)};
}

/// The thickness of a blade along its length: 0 at both edges, 1 in the middle.
double lens(double fraction)
{
  return fraction > 0.0 && fraction < 1.0 ? 4.0 * fraction * (1.0 - fraction) : 0.0;
}

/// How far the volute reaches outwards, and how far on both sides of its middle.
struct Section
{
  double height, halfWidth;
};

Section voluteSection(double angle, double beyond)
{
  const double share = (angle - voluteBegin) / (2.0 * pi - voluteBegin);
  const double height = 0.06 + 0.46 * share + 0.05 * beyond;
  return {height, ringHalfWidth + 0.36 * height};
}

} // namespace

Point cartesian(const Cylindrical& place)
{
  return {place.radius * std::cos(place.angle), place.radius * std::sin(place.angle), place.z};
}

double denseAtEnds(double u, double strength)
{
  if (strength <= 0.0)
    return u;
  return 0.5 + 0.5 * std::tanh(strength * (2.0 * u - 1.0)) / std::tanh(strength);
}

double denseAtStart(double u, double strength)
{
  if (strength <= 0.0)
    return u;
  return 1.0 - std::tanh(strength * (1.0 - u)) / std::tanh(strength);
}

Point inletCore(double u, double v)
{
  // Between a square and a disc, so that no angle at its corners comes near 180 degrees.
  constexpr double half = 0.36, roundness = 0.45;
  return {half * u * std::sqrt(1.0 - 0.5 * roundness * v * v),
    half * v * std::sqrt(1.0 - 0.5 * roundness * u * u), 0.0};
}

double bladeFraction(double s)
{
  return (s - bladeBegin) / (bladeEnd - bladeBegin);
}

double bladeThickness(double s, double span)
{
  const double shape = lens(bladeFraction(s));
  return shape > 0.0 ? 0.07 / impellerAt(s, span).radius * shape : 0.0;
}

Cylindrical rotorPoint(double s, double across, int passage, double span)
{
  const Meridional at = impellerAt(s, span);
  const double x = bladeFraction(s), pitch = 2.0 * pi / bladeCount;
  // Swept back by 100 degrees, more where the radius is small; the hub leads at the eye.
  const double camber =
    -1.75 * (1.5 * x - 0.5 * x * x) - 0.35 * (span - 0.5) * (1.0 - x) * (1.0 - x);
  const double thickness = lens(x) * 0.07 / at.radius;
  return {
    at.radius, camber + pitch * passage + 0.5 * thickness + across * (pitch - thickness), at.z};
}

double vaneFraction(double radius)
{
  return (radius - vaneBegin) / (vaneEnd - vaneBegin);
}

double vaneThickness(double radius)
{
  return 0.1 / radius * lens(vaneFraction(radius));
}

double vaneAngle(double radius)
{
  const auto from = [](double r)
  {
    const double way = std::log(r / ringBegin), all = std::log(ringEnd / ringBegin);
    return 3.5 * way - 0.85 * way * way / all;
  };
  return from(radius) - from(ringEnd);
}

double vaneSlope(double radius)
{
  return 3.5 - 1.7 * std::log(radius / ringBegin) / std::log(ringEnd / ringBegin);
}

Cylindrical ringPoint(double radius, double across, int passage, double span)
{
  const double pitch = 2.0 * pi / vaneCount, thickness = vaneThickness(radius);
  return {radius,
    vaneAngle(radius) + pitch * passage + 0.5 * thickness + across * (pitch - thickness),
    ringMiddle + ringHalfWidth * (2.0 * span - 1.0)};
}

Point volutePoint(double angle, double beyond, double out, double span)
{
  const Section section = voluteSection(angle, beyond);
  const double side = 2.0 * span - 1.0;
  // Narrow where it meets the ring, widest at four fifths, rounded outside.
  const double radius = ringEnd + section.height * (out - 0.12 * out * out * side * side);
  const double width = std::lerp(ringHalfWidth, section.halfWidth, std::sin(0.62 * pi * out));
  const double z = ringMiddle + side * width;
  if (beyond > 0.0)
    return {radius, beyond, z};
  return cartesian({radius, angle, z});
}

double voluteArea(double angle, double beyond)
{
  const Section section = voluteSection(angle, beyond);
  // The width times the height's growth, integrated over both: see volutePoint().
  double area = 0.0;
  constexpr int steps = 8;
  for (int i = 0; i < steps; ++i)
  {
    const double out = (i + 0.5) / steps;
    const double width = std::lerp(ringHalfWidth, section.halfWidth, std::sin(0.62 * pi * out));
    area += 2.0 * width * section.height * (1.0 - 0.24 * out / 3.0) / steps;
  }
  return area;
}

} // namespace mote::pump
