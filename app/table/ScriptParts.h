#pragma once

#include "stage/Stage.h"

namespace mote::app
{

class Script;

/// Writes what makes a mapper and a prop, in the list `props`, of each of the stage's parts, which
/// a list `parts` has, and gives it to a `renderer`. `settings` are those in force, and `colors`
/// the table of colours.
void writeParts(Script& script, const Stage& stage, const Settings& settings);

/// What writeParts() has written, in the order of `props`.
std::vector<vtkProp3D*> writtenProps(const Stage& stage);

} // namespace mote::app
