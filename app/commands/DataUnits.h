#pragma once

#include "base/Unit.h"
#include "stage/Input.h"

#include <optional>
#include <string>
#include <vector>

namespace mote::app
{

/// What an array is measured in, or for no name lengths, where any of the data say so and it is
/// understood.
std::optional<Unit> knownUnit(const std::vector<NamedData>& data, const std::string& array = {});

/// What times are measured in, for pictures: seconds where an array is a length a second. Empty
/// where no array tells.
std::string timeUnitOf(const std::vector<NamedData>& data);

/// "p (Pa)"; without a unit the name alone.
std::string withUnit(const std::string& name, const std::string& unit);

} // namespace mote::app
