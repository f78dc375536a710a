#pragma once

#include "Input.h"
#include "settings/Settings.h"

#include <map>
#include <string>
#include <vector>

namespace mote::app
{

/// The array that says where --where, --hide-ids and --only-ids hold: 1 there, else 0. Nobody is
/// asked to choose by it.
extern const std::string whereArray;

/// Whether the settings ask for that array.
bool isLimited(const SelectionSettings& selection);

/// The data with positions as --positions asks and the arrays of --calculate, --where and ids; the
/// data themselves stay as they are. A data set that lacks what an expression speaks of goes
/// without. Throws Failure where all do, but of expressions that are in `known`, which an earlier
/// time step had: then a warning tells it once. `known` gets those that are there, and whether a
/// warning was given.
using KnownExpressions = std::map<std::string, bool>;
std::vector<NamedData> withCalculated(
  const std::vector<NamedData>& data, const Settings& settings, KnownExpressions& known);

/// A time step's data, read and with all that. Throws Failure and Interrupted.
std::vector<NamedData> readAsAsked(
  Input& input, int step, const Settings& settings, ProgressRelay& progress);

/// Notes expressions whose arrays were made elsewhere, with no problem.
void noteCalculated(const Settings& settings, KnownExpressions& known);

/// Whether these settings ask for other arrays or positions.
bool areOtherCalculations(const Settings& a, const Settings& b);

} // namespace mote::app
