#include "PumpFlow.h"

#include "kernels/core/Vec.h"

#include <algorithm>
#include <cmath>

namespace mote::pump
{

namespace
{

// The flow through the pump by the impeller's coefficients: mean radial speed at its outlet, and
// angular momentum behind it, both by tip speed.
constexpr double outletSpeed = 0.08, outletSwirl = 0.75, outletWidth = 0.12;
constexpr double volumeFlow = 2.0 * pi * outletWidth * outletSpeed;
constexpr double pressureBehind = 0.41; // the rise through the impeller
constexpr double slip = 0.2;            // by how much water lags behind the blades at the outlet

/// 0 at both walls, nearly 1 between, 8/9 on average.
double betweenWalls(double share)
{
  const double side = 2.0 * share - 1.0, square = side * side, fourth = square * square;
  return 1.0 - fourth * fourth;
}

/// From 0 below `a` to 1 above `b`.
double ramp(double a, double b, double x)
{
  const double u = std::clamp((x - a) / (b - a), 0.0, 1.0);
  return u * u * (3.0 - 2.0 * u);
}

/// How much of the flow the boundary layers and wakes of blades leave: 0 on a blade, 1 far from
/// any. `x` goes from 0 to 1 along the blade, `across` from blade to blade.
double besideBlades(double x, double across)
{
  const double grown = std::clamp(x, 0.0, 1.0);
  const double side = std::abs(2.0 * across - 1.0);
  const double layers = std::pow(side, 12.0 - 6.0 * grown);
  const double presence = x < 0.0   ? std::exp(-(x * x) / 0.0025)
                          : x > 1.0 ? std::exp((1.0 - x) / 0.3)
                                    : 1.0;
  return 1.0 - presence * layers;
}

/// Lift along a blade: 0 at both edges, most in the first half.
double loading(double x)
{
  return x > 0.0 && x < 1.0 ? std::sin(pi * std::pow(x, 0.8)) : 0.0;
}

void setVelocity(SteadyFlow& flow, double x, double y, double z)
{
  flow.velocity[0] = static_cast<float>(x);
  flow.velocity[1] = static_cast<float>(y);
  flow.velocity[2] = static_cast<float>(z);
}

/// From parts along radius, circumference and axis.
void setCylindrical(SteadyFlow& flow, double angle, double radial, double around, double axial)
{
  const double c = std::cos(angle), s = std::sin(angle);
  setVelocity(flow, radial * c - around * s, radial * s + around * c, axial);
}

/// From a stream function F(y), y = (r^2 - h^2) / (R^2 - h^2), h the radius of the dead water ahead
/// of the hub: without divergence, and along every wall.
SteadyFlow pipeFlow(double x, double y, double z)
{
  const double ahead = -z / eyeRadius, radius = eyeRadius * std::hypot(x, y);
  const double angle = std::atan2(y, x), square = eyeRadius * eyeRadius;
  const double dead = hubRadius * std::exp(-3.0 * ahead), dead2 = dead * dead;
  const double share = std::max(0.0, (radius * radius - dead2) / (square - dead2));
  const double profile = 1.25 * (1.0 - share * share * share * share);
  const double atHub = dead / hubRadius, away = std::max(0.0, radius - dead) / (0.25 * hubRadius);
  const double slowed = 1.0 - atHub * atHub * std::exp(-away * away);
  const double axial = volumeFlow / pi * profile * slowed / (square - dead2);
  // dead grows by 3 / eyeRadius of itself along z.
  const double widening = 3.0 / eyeRadius * dead2 * (1.0 - share);
  const double radial = radius > 0.0 && share > 0.0 ? axial * widening / radius : 0.0;
  const double wall = 1.0 - std::pow(radius / eyeRadius, 8.0);
  const double around = 0.3 * radius * std::exp(-1.5 * ahead) * wall;

  SteadyFlow flow;
  setCylindrical(flow, angle, radial, around, axial);
  flow.pressure = static_cast<float>(-0.5 * (axial * axial + radial * radial + around * around));
  // A vortex that winds along the pipe like a rope, and the blades' own pressure before them.
  const double off = (radius / eyeRadius - 0.45) / 0.28;
  flow.pulse = static_cast<float>(-0.016 * std::exp(-off * off - 0.25 * ahead));
  flow.pulsePhase = static_cast<float>(angle + 2.2 * ahead);
  flow.wave = static_cast<float>(
    0.012 * std::pow(radius / eyeRadius, double{bladeCount}) * std::exp(-3.5 * ahead));
  flow.wavePhase = static_cast<float>(bladeCount * angle);
  return flow;
}

SteadyFlow rotorFlow(double s, double across, int passage, double span)
{
  // What the flow runs along: derivatives of the place by station, at the ends one-sided.
  constexpr double step = 1e-4;
  const double s0 = std::max(0.0, s - step), s1 = std::min(1.0, s + step);
  const double t0 = std::max(0.0, span - step), t1 = std::min(1.0, span + step);
  const Cylindrical at = rotorPoint(s, across, passage, span);
  const Cylindrical a = rotorPoint(s0, across, passage, span),
                    b = rotorPoint(s1, across, passage, span),
                    c = rotorPoint(s, across, passage, t0), d = rotorPoint(s, across, passage, t1);
  const double rs = (b.radius - a.radius) / (s1 - s0), zs = (b.z - a.z) / (s1 - s0),
               as = (b.angle - a.angle) / (s1 - s0);
  const double rt = (d.radius - c.radius) / (t1 - t0), zt = (d.z - c.z) / (t1 - t0);
  const double jacobian = zs * rt - rs * zt; // positive: from hub to shroud, along the stream
  const double x = bladeFraction(s), lift = loading(x);
  const double blocked = 1.0 - bladeCount * bladeThickness(s, span) / (2.0 * pi);
  // The stations' rate that carries the volume flow, before walls slow it down.
  const double rate = volumeFlow / (2.0 * pi * at.radius * jacobian * blocked) *
                      (1.0 + 0.45 * lift * (2.0 * across - 1.0));
  const double walls = 9.0 / 8.0 * betweenWalls(span) * besideBlades(x, across);
  const double free = at.radius * (-1.0 + 0.3 * walls); // not turned by a blade yet
  const double turned = at.radius * (as * rate - slip * ramp(0.7, 1.0, s));
  const double guided = ramp(0.0, bladeBegin, s);
  SteadyFlow flow;
  setCylindrical(
    flow, at.angle, rs * rate * walls, std::lerp(free, turned, guided) * walls, zs * rate * walls);
  // Bernoulli's law before the blades, the same in the turning frame between them, with losses.
  const double meridional2 = rate * rate * (rs * rs + zs * zs), swirl = 0.3 * at.radius;
  const double ahead = -0.5 * (meridional2 + swirl * swirl);
  const double between =
    0.5 * at.radius * at.radius - 0.35 * (meridional2 + turned * turned) - 0.09;
  flow.pressure =
    static_cast<float>(std::lerp(ahead, between, guided) + 0.16 * lift * (0.5 - across));
  // Vanes pass the outlet; between the blades turns a pair of stalled cells at half the speed.
  flow.pulse =
    static_cast<float>(0.05 * std::pow(at.radius, double{vaneCount}) * ramp(0.4, 1.0, s));
  flow.pulsePhase = static_cast<float>(-vaneCount * at.angle);
  flow.wave = static_cast<float>(0.03 * std::sin(pi * s) * at.radius);
  flow.wavePhase = static_cast<float>(-2.0 * at.angle);
  return flow;
}

SteadyFlow ringFlow(double radius, double across, int passage, double span)
{
  const Cylindrical at = ringPoint(radius, across, passage, span);
  const double x = vaneFraction(radius);
  const double blocked = 1.0 - vaneCount * vaneThickness(radius) / (2.0 * pi);
  const double radial = volumeFlow / (2.0 * pi * radius * 2.0 * ringHalfWidth * blocked);
  const double guided = ramp(ringBegin, vaneBegin + 0.1, radius);
  const double around = std::lerp(outletSwirl / radius, radial * vaneSlope(radius), guided);
  const double lift = loading(x);
  // Outside the first passage there is no volute yet but a wall.
  const double toWall = std::max(0.0, (radius - vaneEnd) / (ringEnd - vaneEnd));
  const bool closed = passage == 0 || (passage == 1 && across == 0.0);
  const double ended = closed ? 1.0 - std::pow(toWall, 4.0) : 1.0;
  const double walls = 9.0 / 8.0 * betweenWalls(span) * besideBlades(x, across) * ended *
                       (1.0 + 0.3 * lift * (2.0 * across - 1.0));
  SteadyFlow flow;
  setCylindrical(flow, at.angle, radial * walls, around * walls, 0.0);
  const double before = outletSwirl * outletSwirl;
  flow.pressure =
    static_cast<float>(pressureBehind + 0.4 * (before - radial * radial - around * around) +
                       0.05 * lift * (0.5 - across));
  // Blades pass, and their wakes run along the vanes, fading.
  const double fading = std::exp(-2.5 * (radius - ringBegin));
  flow.pulse = static_cast<float>(-0.06 * fading);
  flow.pulsePhase = static_cast<float>(bladeCount * (at.angle - vaneAngle(radius)));
  flow.wave = static_cast<float>(0.015 * betweenWalls(across) * ramp(0.0, 0.3, x));
  flow.wavePhase = static_cast<float>(2.0 * at.angle);
  return flow;
}

/// The unit vector from one place to another, unless they are one.
Vec3d direction(const Point& from, const Point& to)
{
  return glm::normalize(Vec3d(to.x - from.x, to.y - from.y, to.z - from.z));
}

SteadyFlow voluteFlow(double angle, double beyond, double out, double span)
{
  constexpr double step = 1e-4;
  const bool straight = beyond > 0.0;
  const auto at = [&](double along, double o)
  {
    return straight ? volutePoint(angle, beyond + along, o, span)
                    : volutePoint(angle + along, 0.0, o, span);
  };
  const Vec3d forward = direction(at(-step, out), at(step, out));
  const Vec3d outward =
    direction(at(0.0, std::max(0.0, out - step)), at(0.0, std::min(1.0, out + step)));

  // What the ring has given by this angle flows through the section; it begins with a wall.
  const double begun = straight ? 1.0 : ramp(0.0, 0.15, angle - voluteBegin);
  const double collected = (angle - voluteBegin) / (2.0 * pi - voluteBegin);
  const double speed = volumeFlow * collected / voluteArea(angle, beyond) * begun;
  const double layer = 8.0 + 40.0 * std::exp(-10.0 * beyond);
  const double inner = straight ? 1.0 - std::pow(1.0 - out, layer) : 1.0;
  const double walls = 1.2 * betweenWalls(span) * (1.0 - std::pow(out, 8.0)) * inner;
  // The ring's outflow turns over in the volute: outwards in the middle, back along the sides.
  const double side = 2.0 * span - 1.0;
  const double turning = 1.4 * speed * out * (1.0 - out) * (1.0 - 3.0 * side * side);
  const double fromRing = volumeFlow / (2.0 * pi * ringEnd * 2.0 * ringHalfWidth);
  const double around = fromRing * vaneSlope(ringEnd);
  const double own = straight ? 1.0 : ramp(0.0, 0.5, out);
  const Vec3d ring = 9.0 / 8.0 * betweenWalls(span) * begun *
                     Vec3d(fromRing * std::cos(angle) - around * std::sin(angle),
                       fromRing * std::sin(angle) + around * std::cos(angle), 0.0);
  const Vec3d velocity = glm::mix(ring, walls * (speed * forward + turning * outward), own);

  SteadyFlow flow;
  setVelocity(flow, velocity.x, velocity.y, velocity.z);
  const double through2 = std::lerp(fromRing * fromRing + around * around, speed * speed, own);
  flow.pressure = static_cast<float>(
    pressureBehind + 0.4 * (outletSwirl * outletSwirl - through2) + 0.02 * out * out);
  const double fading = std::exp(-2.5 * (ringEnd - ringBegin) - 2.0 * out - 3.0 * beyond);
  flow.pulse = static_cast<float>(-0.06 * fading);
  flow.pulsePhase = static_cast<float>(bladeCount * (angle - 2.0 * beyond));
  flow.wave = static_cast<float>(0.015 * (1.0 - out * out) * std::exp(-beyond));
  flow.wavePhase = static_cast<float>(2.0 * (angle + beyond));
  return flow;
}

} // namespace

Rhythm rhythmOf(Region region)
{
  switch (region)
  {
  case Region::Pipe:
    return {1, bladeCount, 12.0F};
  case Region::Rotor:
    return {vaneCount, 1, -2.0F};
  case Region::Ring:
  case Region::Volute:
  case Region::Outlet:
    break;
  }
  return {bladeCount, 1, 6.0F};
}

SteadyFlow steadyFlow(const PlaneVertex& vertex, double layer)
{
  switch (vertex.region)
  {
  case Region::Pipe:
    return pipeFlow(vertex.along, vertex.across, layer);
  case Region::Rotor:
    return rotorFlow(vertex.along, vertex.across, vertex.passage, layer);
  case Region::Ring:
    return ringFlow(vertex.along, vertex.across, vertex.passage, layer);
  case Region::Volute:
    return voluteFlow(vertex.across, 0.0, vertex.along, layer);
  case Region::Outlet:
    break;
  }
  return voluteFlow(2.0 * pi, vertex.across, vertex.along, layer);
}

Point placeOf(const PlaneVertex& vertex, double layer)
{
  switch (vertex.region)
  {
  case Region::Pipe:
    return {eyeRadius * vertex.along, eyeRadius * vertex.across, layer};
  case Region::Rotor:
    return cartesian(rotorPoint(vertex.along, vertex.across, vertex.passage, layer));
  case Region::Ring:
    return cartesian(ringPoint(vertex.along, vertex.across, vertex.passage, layer));
  case Region::Volute:
    return volutePoint(vertex.across, 0.0, vertex.along, layer);
  case Region::Outlet:
    break;
  }
  return volutePoint(2.0 * pi, vertex.across, vertex.along, layer);
}

} // namespace mote::pump
