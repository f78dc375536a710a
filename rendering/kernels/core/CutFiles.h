#pragma once

namespace mote
{

/// From here on a file that another program cuts short, or that the disk fails to read, while it is
/// mapped into memory does not end this program: what is missing reads as zeros, and AtomicFile
/// writes nothing made of it. Other bus errors end the program as ever. For programs to call, not
/// for libraries: it sets the action of a signal, SIGBUS.
void surviveCutFiles();

/// Whether that has happened since the last takeFileCut().
bool fileWasCut();

/// The same, and forgets it.
bool takeFileCut();

} // namespace mote
