#ifndef MotePumpShape_h
#define MotePumpShape_h

#include <numbers>

namespace mote::pump
{

// The shape of the pump, as functions from places in its mesh to places in space. Lengths are in
// impeller radii, angles in radians; the axis is z, water enters along +z, the impeller turns
// towards growing angles. docs/pump.md has the formulas with a picture.

inline constexpr int bladeCount = 7, vaneCount = 9;
inline constexpr double pi = std::numbers::pi;

// The inlet pipe, which ends at z = 0. Its mesh has squares around the axis, rings outside.
inline constexpr double pipeLength = 1.6, eyeRadius = 0.5;
// The impeller: from the hub's radius at the eye to 1, blades between two stations.
inline constexpr double hubRadius = 0.18, bladeBegin = 0.18, bladeEnd = 0.93;
// The diffuser is a ring with vanes, then a volute that leaves it along a straight pipe. It begins
// where the impeller ends, with other points: cells overlap by what their chords cut off.
inline constexpr double ringBegin = 1.0, vaneBegin = 1.10, vaneEnd = 1.52, ringEnd = 1.65;
inline constexpr double ringMiddle = 0.41, ringHalfWidth = 0.07;
inline constexpr double voluteBegin = 2.0 * pi / vaneCount, outletLength = 1.5;

struct Point
{
  double x, y, z;
};

struct Cylindrical
{
  double radius, angle, z;
};

Point cartesian(const Cylindrical& place);

/// Spreads an even `u` of [0, 1] so that steps are small at both ends, the more so the larger
/// `strength` is (0: not at all).
double denseAtEnds(double u, double strength);
/// The same, dense at 0 alone.
double denseAtStart(double u, double strength);

/// A point of the inlet's cross section in pipe radii; `u` and `v` in [-1, 1] are places in the
/// middle square.
Point inletCore(double u, double v);

/// A blade's share of the way from leading (0) to trailing edge (1) at station `s`; outside [0, 1]
/// beside the blade.
double bladeFraction(double s);

/// A point of the impeller: `s` in [0, 1] from eye to outlet, `across` in [0, 1] from the pressure
/// side of blade `passage` to the suction side of the next, `span` in [0, 1] from hub to shroud.
Cylindrical rotorPoint(double s, double across, int passage, double span);

/// The angle that blades cover at a place.
double bladeThickness(double s, double span);

/// The same of the ring with vanes, at a radius; `span` in [0, 1] along z.
Cylindrical ringPoint(double radius, double across, int passage, double span);
double vaneFraction(double radius);
double vaneThickness(double radius);
/// The angle of the middle of vane 0, and by how much it grows with the logarithm of the radius.
double vaneAngle(double radius);
double vaneSlope(double radius);

/// A point of the volute: `angle` from voluteBegin to 2 pi, and the length of straight pipe beyond
/// in `beyond`; `out` in [0, 1] from the ring outwards, `span` in [0, 1] along z.
Point volutePoint(double angle, double beyond, double out, double span);
/// The area of the volute's cross section.
double voluteArea(double angle, double beyond);

} // namespace mote::pump

#endif
