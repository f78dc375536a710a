#ifndef MotePLYCheck_h
#define MotePLYCheck_h

#include <string>

namespace mote
{

/// Throws FileError for what VTK 9.1's vtkPLYReader answers with a crash or with nonsense: a file
/// that is no PLY (OtherFormat), holds less than its header announces (Truncated), or has faces of
/// points that there are not, headers that it does not know and elements that it does not skip
/// (Malformed). Walks through the values, without keeping any.
void checkPLY(const std::string& path);

} // namespace mote

#endif
