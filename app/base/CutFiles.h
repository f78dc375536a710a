#pragma once

namespace mote::app
{

/// From here on a file that another program cuts short while it is mapped into memory does not end
/// this one: what is missing reads as zeros. Other bus errors end the program as ever.
void surviveCutFiles();

/// Whether that has happened since the last call.
bool takeFileCut();

} // namespace mote::app
