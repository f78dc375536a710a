#ifndef MoteEnSightGeometry_h
#define MoteEnSightGeometry_h

#include "EnSightSource.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace mote
{

/// How many nodes and elements a part of EnSight Gold has.
struct EnSightPart
{
  std::int64_t nodes = 0;
  std::int64_t cells = 0; ///< of a block
  bool isBlock = false;
  std::map<std::string, std::int64_t> elements = {}; ///< of each type
};

using EnSightParts = std::map<std::int64_t, EnSightPart>;

/// Goes through a geometry file: the parts of each of its steps. Throws FileError for what is
/// damaged.
std::vector<EnSightParts> checkEnSightGeometry(const std::string& path);

/// Goes through a file of values, with one or more components a node or element, on these parts.
/// Returns how many steps it holds.
std::size_t checkEnSightValues(const std::string& path, EnSightForm form,
  const std::vector<EnSightParts>& steps, int components, bool isOfNodes);

} // namespace mote

#endif
