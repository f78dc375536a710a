#pragma once

#include "stage/Stage.h"

namespace mote::app
{

/// Writes one picture, or one for every time step. Throws Failure and Interrupted; then no file is
/// left that is not complete.
void render(const Settings& settings);

/// The settings with the size of their picture: of a session that of saved pictures, which have
/// lines as thick as its view, as a share of the height.
Settings asSaved(Settings settings, const std::array<int, 2>& usual);

/// Throws Failure where nothing on the stage can be drawn without OpenGL.
void requireTraced(const Stage& stage);

} // namespace mote::app
