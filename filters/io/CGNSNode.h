#ifndef MoteCGNSNode_h
#define MoteCGNSNode_h

#include <cstdint>
#include <string>
#include <vector>

namespace mote
{

/// A node of a CGNS file, and what lies below it.
struct CGNSNode
{
  std::string name, label, type; ///< type: I4, R8, C1, MT...
  std::vector<std::int64_t> dimensions;
  std::vector<std::int64_t> values; ///< of some whole numbers
  std::vector<CGNSNode> children;

  /// How many values it has.
  std::int64_t size() const;
  /// Its first child with a label, or with a name; null where there is none.
  const CGNSNode* childLabelled(const std::string& wanted) const;
  const CGNSNode* childNamed(const std::string& wanted) const;
};

/// All nodes of a file, with the whole numbers that say how large other nodes are, or that name
/// faces and elements of other types than one. Throws FileError for what cannot be read.
CGNSNode readCGNSNodes(const std::string& path);

} // namespace mote

#endif
