#pragma once

#include "Input.h"
#include "settings/Settings.h"

#include <string>
#include <vector>

namespace mote::app
{

/// The array that says where --where holds: 1 there, else 0. Nobody is asked to choose by it.
extern const std::string whereArray;

/// The data with the arrays that --calculate and --where ask for; the data themselves stay as they
/// are. A data set that lacks what an expression speaks of goes without. Throws Failure where all
/// do.
std::vector<NamedData> withCalculated(const std::vector<NamedData>& data, const Settings& settings);

/// Whether these settings ask for other arrays.
bool areOtherCalculations(const Settings& a, const Settings& b);

} // namespace mote::app
