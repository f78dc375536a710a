#ifndef MotePLYCheck_h
#define MotePLYCheck_h

#include <string>

namespace mote
{

/// Throws FileError if a file is no PLY (OtherFormat) or holds less than its header announces
/// (Truncated), which VTK 9.1's vtkPLYReader answers with a crash. Walks through the elements,
/// without keeping any.
void checkPLYIsWhole(const std::string& path);

} // namespace mote

#endif
