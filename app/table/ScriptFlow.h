#pragma once

#include "stage/Stage.h"

namespace mote::app
{

class Script;

/// Writes what makes streamlines and arrows, as writeParts() writes the rest.
void writeFlow(Script& script, const Stage& stage, const FlowSettings& flow);

} // namespace mote::app
