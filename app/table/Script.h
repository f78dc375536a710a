#pragma once

#include "stage/Stage.h"

#include <string>

namespace mote::app
{

/// A line for the shell that makes the picture `output` of these settings, or opens the window
/// where that is empty.
std::string commandOf(const Settings& settings, const std::string& output);

/// A program in Python that makes the picture `output` of the stage by VTK's and Mote's classes
/// alone: what mote render does, spelled out. `settings` are those in force.
std::string scriptOf(
  const Stage& stage, const Input& input, const Settings& settings, const std::string& output);

} // namespace mote::app
