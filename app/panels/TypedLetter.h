#pragma once

namespace mote::app
{

/// The character, in Unicode, of a key by its name in X11: "mu", "Greek_sigma", "U2103"; 0 where it
/// writes none. VTK's own characters are those of ASCII alone.
unsigned letterOf(const char* symbol);

} // namespace mote::app
