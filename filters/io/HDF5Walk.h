#ifndef MoteHDF5Walk_h
#define MoteHDF5Walk_h

#include <string>

namespace mote
{

/// Throws FileError where HDF5's library does not survive the file: version 1.10 ends the program
/// on some damage. A child process goes through all groups, attributes and arrays first, without
/// their values, and dies in place of this one. It takes as long as opening each of them, and 5 s
/// at most; after that the file is taken as it is.
void requireWalkable(const std::string& path);

} // namespace mote

#endif
