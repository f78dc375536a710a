#pragma once

namespace mote::bench
{

/// Whether there is an X server to draw on: VTK aborts without one.
bool hasDisplay();

} // namespace mote::bench
