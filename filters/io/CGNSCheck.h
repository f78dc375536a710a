#ifndef MoteCGNSCheck_h
#define MoteCGNSCheck_h

#include <string>

namespace mote
{

/// Goes through the nodes of a CGNS file, and throws FileError where they cannot be read or their
/// sizes do not fit together: VTK 9.1's vtkCGNSReader ends the program then, or crashes.
/// Coordinates and values are not read. One thread at a time.
void checkCGNSIsWhole(const std::string& path);

} // namespace mote

#endif
