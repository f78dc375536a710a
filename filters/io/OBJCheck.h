#ifndef MoteOBJCheck_h
#define MoteOBJCheck_h

#include <string>

namespace mote
{

/// Throws FileError, with the line, for what VTK 9.1's vtkOBJReader answers with a crash or with
/// nonsense: faces, lines and points of vertices, texture coordinates or normals that are not
/// there, corners that are not written as 1, 1/2, 1/2/3 or 1//3, vertices that are no numbers,
/// materials of long names, zero bytes. Reads every line once and keeps none.
void checkOBJ(const std::string& path);

} // namespace mote

#endif
