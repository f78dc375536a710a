#pragma once

#include "../Options.h"
#include "Contest.h"

#include <vector>

namespace mote::bench
{

/// Makes or reads the input that the options name, and says what is in it.
ParticleInput inputOf(const Options& options);

/// Whether the options ask for the method.
bool isWanted(const Options& options, const std::string& method);

/// A table of methods in views with their speed beside Embree's in the same view. Depth errors are
/// left out where none was measured.
Section comparison(const std::vector<Measurement>& measurements);

/// A table of what levels of detail cost and make wrong, of the measurements with any.
Section lodErrors(const std::vector<Measurement>& measurements);

} // namespace mote::bench
