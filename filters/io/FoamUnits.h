#ifndef MoteFoamUnits_h
#define MoteFoamUnits_h

#include <string>

namespace mote
{

/// What the values of a field of OpenFOAM are measured in, by the dimensions in its file: "m s^-1",
/// in units of the SI, which OpenFOAM computes in. "1" for numbers without dimension; empty where
/// the file does not say or is no field.
std::string foamUnitOf(const std::string& path);

} // namespace mote

#endif
