#ifndef MotePLYColumns_h
#define MotePLYColumns_h

#include "PLYHeader.h"

#include <string>
#include <vector>

namespace mote
{

/// The values of one property of all vertices or faces.
struct PLYColumn
{
  std::string element; ///< "vertex" or "face"
  std::string name;
  PLYHeader::Number number; ///< the type in the file
  std::vector<double> values;
};

/// Reads what VTK 9.1's vtkPLYReader leaves out, such as the quality of vertices, and x, y and z of
/// type double, which it makes float. Throws FileError for what that reader answers with a crash or
/// with nonsense: a file that is no PLY (OtherFormat), holds less than its header announces
/// (Truncated), or has faces of points that there are not, headers that it does not know and
/// elements that it does not skip (Malformed).
std::vector<PLYColumn> readPLYColumns(const std::string& path);

} // namespace mote

#endif
