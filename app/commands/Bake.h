#pragma once

#include "settings/Settings.h"
#include "stage/Input.h"
#include "stage/Stage.h"

#include <string>
#include <vector>

namespace mote::app
{

/// Writes the occlusion maps of the particles of a file. Throws Failure and Interrupted.
void bake(const Settings& settings);

/// Adds the maps that mote bake has written beside their files, if there are any, to the particles
/// among the data. A file that cannot be read is a warning.
void addOcclusionMaps(const std::vector<NamedData>& data);

/// Reads a time step for the stage, with the maps where its settings ask for them. Throws what
/// Input::read() does.
void readStep(Stage& stage, Input& input, int step, ProgressRelay& progress);

} // namespace mote::app
