#pragma once

#include "stage/Stage.h"

namespace mote::app
{

/// Writes one picture, or one for every time step. Throws Failure and Interrupted; then no file is
/// left that is not complete.
void render(const Settings& settings);

/// Throws Failure where nothing on the stage can be drawn without OpenGL.
void requireTraced(const Stage& stage);

} // namespace mote::app
