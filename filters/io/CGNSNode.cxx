#include "CGNSNode.h"

#include "FileError.h"
#include "HDF5Walk.h"
#include "TextFile.h"

#include "vtk_cgns.h"

// clang-format off
#include VTK_CGNS(cgnslib.h)
#include VTK_CGNS(cgns_io.h)
// clang-format on

#include <algorithm>

namespace mote
{

namespace
{

constexpr int deepest = 24;
constexpr int mostNodes = 2'000'000;
constexpr std::int64_t mostValues = std::int64_t{1} << 40; // products stay numbers

/// Lets the library forget nodes, in the end.
struct Released
{
  ~Released()
  {
    for (const double id : ids)
      cgio_release_id(file, id);
  }
  int file;
  const std::vector<double>& ids;
};

/// An open file, whose nodes it reads.
class Nodes
{
public:
  explicit Nodes(const std::string& path)
    : path_(path)
    , bytes_(stampOf(path).bytes)
  {
    int type = 0;
    this->require(cgio_check_file(path.c_str(), &type));
    if (type == CGIO_FILE_HDF5)
      requireWalkable(path);
    this->require(cgio_open_file(path.c_str(), CGIO_MODE_READ, CGIO_FILE_NONE, &file_));
  }
  ~Nodes()
  {
    if (file_ > 0)
      cgio_close_file(file_);
  }
  Nodes(const Nodes&) = delete;
  Nodes& operator=(const Nodes&) = delete;

  CGNSNode read()
  {
    double root = 0.0;
    this->require(cgio_get_root_id(file_, &root));
    return this->read(root, "", 0);
  }

private:
  void require(int code) const
  {
    if (code == CGIO_ERR_NONE)
      return;
    char message[CGIO_MAX_ERROR_LENGTH + 1] = "";
    cgio_error_message(message);
    std::string text = message;
    text.erase(text.find_last_not_of(" \n") + 1);
    throw FileError(FileError::Kind::Malformed, path_,
      "this is no whole CGNS file" + (text.empty() ? "" : " (" + text + ")"));
  }

  /// Whether a node's numbers say how large others are.
  static bool isWanted(const std::string& label, const std::string& name, const std::string& parent)
  {
    return label == "CGNSBase_t" || label == "Zone_t" || label == "Elements_t" ||
           label == "IndexRange_t" || label == "IndexArray_t" ||
           label == "\"int[2*IndexDimension]\"" || label == "Rind_t" ||
           label == "BaseIterativeData_t" || name == "ElementStartOffset" ||
           parent == "Elements_t other";
  }

  CGNSNode read(double id, const std::string& parent, int depth)
  {
    if (depth > deepest || ++count_ > mostNodes)
      throw FileError(FileError::Kind::Malformed, path_, "its nodes lie in one another too deeply");
    CGNSNode node;
    char text[CGIO_MAX_NAME_LENGTH + 1] = "";
    this->require(cgio_get_name(file_, id, text));
    node.name = text;
    this->require(cgio_get_label(file_, id, text));
    node.label = text;
    this->require(cgio_get_data_type(file_, id, text));
    node.type = text;
    this->readDimensions(id, node);
    const bool isWhole = node.type == "I4" || node.type == "I8";
    if (isWhole && node.size() > 0 && isWanted(node.label, node.name, parent))
    {
      node.values.resize(static_cast<std::size_t>(node.size()));
      this->require(cgio_read_all_data_type(file_, id, "I8", node.values.data()));
    }
    int children = 0;
    this->require(cgio_number_children(file_, id, &children));
    std::vector<double> ids(static_cast<std::size_t>(std::max(children, 0)));
    int listed = 0;
    const Released released{file_, ids};
    if (children > 0)
      this->require(cgio_children_ids(file_, id, 1, children, &listed, ids.data()));
    if (listed != children)
      throw FileError(
        FileError::Kind::Malformed, path_, "not all nodes in '" + node.name + "' can be found");
    // What elements of several types are, only their numbers say.
    const bool isOther =
      node.label == "Elements_t" && !node.values.empty() &&
      (node.values[0] == CGNS_ENUMV(MIXED) || node.values[0] >= CGNS_ENUMV(NGON_n));
    for (int i = 0; i < children; ++i)
    {
      node.children.push_back(
        this->read(ids[i], isOther ? "Elements_t other" : node.label, depth + 1));
      // Others will look for it by its name.
      double found = 0.0;
      this->require(cgio_get_node_id(file_, id, node.children.back().name.c_str(), &found));
      cgio_release_id(file_, found);
    }
    return node;
  }

  void readDimensions(double id, CGNSNode& node) const
  {
    int count = 0;
    cgsize_t dimensions[CGIO_MAX_DIMENSIONS] = {};
    this->require(cgio_get_dimensions(file_, id, &count, dimensions));
    if (node.type == "MT" || node.type == "LK")
      count = 0;
    for (int i = 0; i < std::min<int>(count, CGIO_MAX_DIMENSIONS); ++i)
    {
      if (dimensions[i] < 0 || dimensions[i] > mostValues)
        throw FileError(FileError::Kind::Malformed, path_,
          "the node '" + node.name + "' says that it has " + std::to_string(dimensions[i]) +
            " values");
      node.dimensions.push_back(dimensions[i]);
    }
    // Links lead to other files; what is packed may be larger than the file.
    if (node.size() > mostValues || (node.size() >> 12) > static_cast<std::int64_t>(bytes_))
      throw FileError(FileError::Kind::Truncated, path_,
        "the node '" + node.name + "' says that it has " + std::to_string(node.size()) +
          " values, which the file has no room for");
  }

  std::string path_;
  std::uint64_t bytes_;
  int file_ = 0;
  int count_ = 0;
};

const CGNSNode* firstOf(
  const std::vector<CGNSNode>& nodes, std::string CGNSNode::*what, const std::string& wanted)
{
  const auto found = std::find_if(
    nodes.begin(), nodes.end(), [&](const CGNSNode& node) { return node.*what == wanted; });
  return found == nodes.end() ? nullptr : &*found;
}

} // namespace

std::int64_t CGNSNode::size() const
{
  std::int64_t product = dimensions.empty() ? 0 : 1;
  for (const std::int64_t one : dimensions)
    product = one > 0 && product > mostValues / one ? mostValues + 1 : product * one;
  return product;
}

const CGNSNode* CGNSNode::childLabelled(const std::string& wanted) const
{
  return firstOf(children, &CGNSNode::label, wanted);
}

const CGNSNode* CGNSNode::childNamed(const std::string& wanted) const
{
  return firstOf(children, &CGNSNode::name, wanted);
}

CGNSNode readCGNSNodes(const std::string& path)
{
  return Nodes(path).read();
}

} // namespace mote
