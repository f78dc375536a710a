#ifndef MotePLYFile_h
#define MotePLYFile_h

#include "PLYHeader.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mote
{

/// The values of one property of all vertices or faces, in the type of the file.
struct PLYColumn
{
  std::string element; ///< "vertex" or "face"
  std::string name;
  PLYHeader::Number number;
  std::vector<char> bytes;

  std::size_t count() const { return bytes.size() / number.bytes; }
  double value(std::size_t i) const;
  void add(double value);
};

/// What a PLY file holds: vertices and faces with all that has one value for each. Lists but the
/// corners of faces, such as texture coordinates of these, are passed over, as are elements of
/// other names.
struct PLYFile
{
  std::vector<PLYColumn> columns;
  std::vector<std::int64_t> corners; ///< of the faces, one after the other
  std::vector<std::int64_t> ends;    ///< of the faces, in `corners`
  std::uint64_t vertices = 0;

  /// Null where there is none of this name.
  const PLYColumn* find(std::string_view element, std::string_view name) const;
};

/// Reads a file, of text or binary. Throws FileError: OtherFormat for a file that is no PLY,
/// Truncated where it holds less than its header announces, and Malformed for faces of points that
/// there are not, headers that are not of the format, and elements between vertices and faces.
/// Source: Turk, "The PLY Polygon File Format", 1994.
PLYFile readPLY(const std::string& path);

} // namespace mote

#endif
