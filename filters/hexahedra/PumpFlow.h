#ifndef MotePumpFlow_h
#define MotePumpFlow_h

#include "PumpPlane.h"
#include "PumpShape.h"

namespace mote::pump
{

/// What the flow at a vertex is made of, in units of the impeller: tip speed 1, density 1, one
/// radian a unit of time. `velocity` is in x, y, z, in the rotor relative to the walls.
///
/// While the phase of the rotation grows by 2 pi, a pulse and a wave pass:
///   pulse(t) = exp(2 (cos(pulsePhase - k t) - 1)), wave(t) = cos(wavePhase - n t),
/// with k and n those of the region, and
///   pressure(t) = pressure + pulse pulse(t) + wave wave(t),
///   velocity(t) = velocity (1 + pulseGain pulse pulse(t) - wave wave(t)).
struct SteadyFlow
{
  float pressure, velocity[3];
  float pulse, pulsePhase, wave, wavePhase;
};

/// How often a region's pulse and wave pass during one revolution, and how much faster water runs
/// where the pulse raises the pressure.
struct Rhythm
{
  int pulses, waves;
  float pulseGain;
};

Rhythm rhythmOf(Region region);

/// The flow at a vertex of a part's sheet in a layer, and where that lies.
SteadyFlow steadyFlow(const PlaneVertex& vertex, double layer);
Point placeOf(const PlaneVertex& vertex, double layer);

} // namespace mote::pump

#endif
