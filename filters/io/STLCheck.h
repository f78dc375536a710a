#ifndef MoteSTLCheck_h
#define MoteSTLCheck_h

#include <string>

namespace mote
{

/// Throws FileError (Truncated) where a binary STL file announces more triangles than it has room
/// for: VTK 9.1's vtkSTLReader takes memory for all of them.
void checkSTL(const std::string& path);

} // namespace mote

#endif
