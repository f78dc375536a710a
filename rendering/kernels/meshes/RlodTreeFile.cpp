// Opening a file of triangles.

#include "RlodTreeFile.h"

#include "../core/Error.h"
#include "detail/RlodTreeArrays.h"
#include "detail/RlodTreeFileHeader.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <type_traits>

namespace mote
{

namespace
{

using Header = RlodTreeFileHeader;

bool areFinite(const double* values, int count)
{
  return std::all_of(values, values + count, [](double v) { return std::isfinite(v); });
}

/// Whether the numbers that rays are turned into the tree's with are any.
void checkNumbers(const std::string& name, const Header& h)
{
  bool good = areFinite(h.origin, 3) && areFinite(h.bounds, 6) && areFinite(&h.unit, 1) &&
              h.unit > 0.0 && std::isfinite(1.0 / h.unit) && std::isfinite(h.cost);
  for (int k = 0; k < 3; ++k)
    good = good && h.lower[k] >= -2.0 && h.lower[k] <= h.upper[k] && h.upper[k] <= 2.0 &&
           h.bounds[k] <= h.bounds[3 + k];
  const auto largest = std::uint64_t{h.firstLevel} + 31 * std::uint64_t{h.levelStep};
  good = good && largest < std::bit_cast<std::uint32_t>(1e30f);
  if (!good)
    failDamaged(name, "its numbers on places are none");
}

/// Checks that children of nodes are nodes and clusters that there are, and come after their
/// parents: with this good no other byte leads a ray outside of the file. Answers how many nodes a
/// ray passes from the root down to a cluster, at most.
int depthOf(const std::string& name, const StoredArray<RlodNode>& nodes, std::size_t clusters)
{
  std::vector<std::uint16_t> depths(nodes.size());
  depths[0] = 1;
  int deepest = 1;
  for (std::size_t k = 0; k < nodes.size(); ++k)
  {
    const RlodNode& node = nodes[k];
    const std::size_t below = node.children - std::min(node.clusters, node.children);
    if (depths[k] == 0 || depths[k] > 1000 || node.clusters > node.children ||
        node.children > RlodNode::fanout || node.children == 0 ||
        node.firstCluster + std::size_t{node.clusters} > clusters ||
        (below > 0 && (node.firstNode <= k || node.firstNode + below > nodes.size())))
      failDamaged(name, "its tree is none");
    for (std::size_t c = 0; c < below; ++c)
      depths[node.firstNode + c] = static_cast<std::uint16_t>(depths[k] + 1);
    deepest = std::max<int>(deepest, depths[k]);
  }
  return deepest;
}

} // namespace

bool RlodTreeFile::recognises(std::string_view beginning)
{
  return beginning.starts_with(std::string_view(Header::theMagic.data(), Header::theMagic.size()));
}

RlodTreeFile::RlodTreeFile(const std::string& name, MappedFile::Paging paging)
  : file_(std::make_shared<const MappedFile>(name, paging))
{
  FileTable table;
  const auto h = unpackHeader<Header>(name, file_->data(), file_->size(), table);
  checkSections(
    name, h, {h.nodes, h.words, h.planes, h.clusters, h.corners, h.offsets, h.places}, table);
  if (h.nodeBytes != sizeof(RlodNode) || h.clusterBytes != sizeof(TriangleCluster) ||
      h.planesBytes != sizeof(RlodPlanes) || h.wordsBytes != sizeof(RlodWords))
    throw Error(name + ": this file has nodes of another shape than is read here");
  const std::uint64_t nodes = h.nodes.bytes / sizeof(RlodNode),
                      clusters = h.clusters.bytes / sizeof(TriangleCluster);
  // Below this no product that follows can overflow.
  if (h.triangles == 0 || h.triangles > file_->size() || h.points == 0 ||
      h.points > file_->size() || nodes == 0 || clusters == 0 ||
      clusters >= RlodNode::mostIndices || (h.placeBytes != 4 && h.placeBytes != 8))
    failDamaged(name, "its numbers of triangles and points are none");
  if (h.nodes.bytes != nodes * sizeof(RlodNode) || h.words.bytes != nodes * sizeof(RlodWords) ||
      h.planes.bytes != nodes * sizeof(RlodPlanes) ||
      h.clusters.bytes != clusters * sizeof(TriangleCluster) ||
      h.corners.bytes != h.triangles * sizeof(MeshCorners::Corners) ||
      h.offsets.bytes != (h.triangles + 1) * sizeof(std::int32_t) ||
      h.places.bytes != h.points * 3 * h.placeBytes)
    failDamaged(name, "its parts have not the size that its triangles ask for");
  checkNumbers(name, h);
  file_->fetch(h.nodes.offset, h.nodes.bytes);
  this->takeTable(h, table);
  this->takeTree(h);
  this->takeMeans(table);
}

/// Takes the means of arrays over what R-LODs stand for, where there are any.
void RlodTreeFile::takeMeans(const FileTable& table)
{
  if (table.more.empty())
    return;
  if (table.more.size() != table.rows.size())
    failDamaged(file_->name(), "its mean values are not those of its arrays");
  const std::size_t places = tree_->nodeCount() * RlodTree::trianglesPerCluster;
  const auto means = std::make_shared<StoredMeans>();
  for (std::size_t k = 0; k < table.rows.size(); ++k)
  {
    const FileEntry& e = table.rows[k].entry;
    const FileSection& section = table.more[k];
    if (section.bytes == 0)
      continue;
    const auto type = static_cast<ArrayView::Type>(e.type);
    const auto components = static_cast<int>(e.components);
    if (e.role == Header::ofWhole ||
        section.bytes != StoredMeans::rowsOf(type, components) * places * sizeof(float))
      failDamaged(file_->name(), "its mean values have not the size that its tree asks for");
    means->add(ArrayView(file_->data() + e.section.offset, type, e.tuples, components),
      reinterpret_cast<const float*>(file_->data() + section.offset), places);
    parts_.push_back({"means", section.offset, section.bytes});
  }
  tree_->arrays_->means = means;
}

void RlodTreeFile::takeTable(const Header& h, FileTable& table)
{
  const std::string& name = file_->name();
  for (FileTableRow& row : table.rows)
  {
    const FileEntry& e = row.entry;
    if ((e.role == Header::ofPoints && e.tuples != h.points) ||
        (e.role == Header::ofCells && e.tuples != h.triangles))
      failDamaged(name, "an array in its table has not one tuple a point or triangle");
    row.array.values = ArrayView(file_->data() + e.section.offset,
      static_cast<ArrayView::Type>(e.type), e.tuples, static_cast<int>(e.components));
    parts_.push_back({"arrays", e.section.offset, e.section.bytes});
    auto& arrays = e.role == Header::ofPoints  ? points_
                   : e.role == Header::ofCells ? cells_
                                               : facts_;
    arrays.push_back(std::move(row.array));
  }
  if (h.normals > points_.size())
    failDamaged(name, "its normals are no array of points");
  if (h.normals > 0)
    normals_ = points_[h.normals - 1].name;
  time_ = h.hasTime ? std::optional(h.time) : std::nullopt;
  const auto addPart = [&](const char* what, const FileSection& s) {
    parts_.push_back({what, s.offset, s.bytes});
  };
  addPart("nodes", h.nodes);
  addPart("words", h.words);
  addPart("planes", h.planes);
  addPart("clusters", h.clusters);
  addPart("corners", h.corners);
  addPart("points", h.places);
}

void RlodTreeFile::takeTree(const Header& h)
{
  const unsigned char* begin = file_->data();
  const auto tree = std::make_shared<RlodTree>();
  RlodTreeArrays& a = *tree->arrays_;
  const auto view = [&](auto& array, const FileSection& section)
  {
    using Value = std::remove_cvref_t<decltype(array[0])>;
    array.view(
      reinterpret_cast<const Value*>(begin + section.offset), section.bytes / sizeof(Value), file_);
  };
  view(a.nodes, h.nodes);
  view(a.words, h.words);
  view(a.planes, h.planes);
  view(a.clusters, h.clusters);
  a.triangles = h.triangles;
  a.levels.first = h.firstLevel;
  a.levels.step = h.levelStep;
  tree->sparesMemory_ = file_->paging() == MappedFile::Paging::Single;
  tree->origin_ = {h.origin[0], h.origin[1], h.origin[2]};
  tree->unit_ = h.unit;
  tree->cost_ = h.cost;
  for (int axis = 0; axis < 3; ++axis)
  {
    tree->lower_[axis] = static_cast<float>(h.lower[axis]);
    tree->upper_[axis] = static_cast<float>(h.upper[axis]);
  }
  tree->depth_ = depthOf(file_->name(), a.nodes, a.clusters.size());
  tree_ = tree;
  StoredArray<MeshCorners::Corners> corners;
  view(corners, h.corners);
  corners_ = std::make_shared<const MeshCorners>(std::move(corners), h.points);
  offsets_ = ArrayView(begin + h.offsets.offset, ArrayView::Type::Int32, h.triangles + 1, 1);
  places_ = ArrayView(begin + h.places.offset,
    h.placeBytes == 4 ? ArrayView::Type::Float32 : ArrayView::Type::Float64, h.points, 3);
  bounds_ = {{h.bounds[0], h.bounds[1], h.bounds[2]}, {h.bounds[3], h.bounds[4], h.bounds[5]}};
}

std::shared_ptr<RlodTree> RlodTreeFile::tree() const
{
  auto tree = std::make_shared<RlodTree>(tree_->copyWithoutLods());
  tree->arrays_->planes = tree_->arrays_->planes;
  tree->arrays_->words = tree_->arrays_->words;
  tree->arrays_->levels = tree_->arrays_->levels;
  tree->arrays_->means = tree_->arrays_->means;
  return tree;
}

const std::string& RlodTreeFile::name() const
{
  return file_->name();
}

std::uint64_t RlodTreeFile::bytes() const
{
  return file_->size();
}

} // namespace mote
