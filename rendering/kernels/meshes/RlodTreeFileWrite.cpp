// Writing a file of triangles: the tree and the arrays are put in order a piece at a time, so that
// no second copy of them is made.

#include "RlodTreeFile.h"

#include "../core/Error.h"
#include "../core/detail/FileWriter.h"
#include "detail/RlodTreeFileHeader.h"
#include "detail/RlodTreeLayout.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

namespace mote
{

namespace
{

using Header = RlodTreeFileHeader;

constexpr std::size_t aPiece = 1 << 16;
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
/// Where their corners begin is a number of 32 bits with a sign in VTK.
constexpr std::size_t mostTriangles = std::numeric_limits<std::int32_t>::max() / 3;

void checkContents(
  const RlodTree& tree, const TriangleMesh& mesh, const RlodTreeFileContents& contents)
{
  if (tree.size() == 0 || !tree.hasLods())
    throw Error("There are no triangles with levels of detail to write.");
  if (tree.size() > mostTriangles)
    throw Error(
      "A file holds 715 million triangles at most, not " + std::to_string(tree.size()) + ".");
  if (contents.places.count() != mesh.pointCount() || contents.places.components() != 3)
    throw Error("The places of the points are not those of the mesh.");
  const ArrayView& of = contents.cellOf;
  double cells = static_cast<double>(mesh.size());
  for (std::size_t k = 0; k < of.count(); ++k)
    cells = std::max(k == 0 ? 0.0 : cells, of.value(k) + 1.0);
  if (!of.empty() && of.count() != mesh.size())
    throw Error("There is not one cell for each triangle of the mesh.");
  // Cells behind the last that has a triangle are none that count.
  std::uint64_t tuples = static_cast<std::uint64_t>(cells);
  for (const NamedArray& array : contents.cells)
    tuples = of.empty() ? tuples : std::max<std::uint64_t>(tuples, array.values.count());
  checkArrays(contents.points, mesh.pointCount(), "points", contents.pointIndices);
  checkArrays(contents.cells, tuples, "cells", contents.cellIndices);
}

} // namespace

/// One file that is written.
class RlodTreeFileWriter
{
public:
  RlodTreeFileWriter(const std::string& name, const RlodTree& tree, const TriangleMesh& mesh,
    const RlodTreeFileContents& contents, const Progress& progress)
    : tree_(tree)
    , a_(*tree.arrays_)
    , mesh_(mesh)
    , contents_(contents)
    , file_(name, progress)
  {
  }

  bool write()
  {
    layout_ = layOut(a_, contents_.order);
    this->orderPoints();
    this->planTable();
    this->planHeader();
    std::uint64_t total = h_.triangles * 16 + h_.points * 3 * h_.placeBytes +
                          a_.nodes.size() * (h_.nodeBytes + h_.wordsBytes + h_.planesBytes) +
                          a_.clusters.size() * h_.clusterBytes;
    for (const FileTableRow& row : table_.rows)
      total += row.entry.section.bytes;
    for (const FileSection& section : table_.more)
      total += section.bytes;
    file_.begin(packHeader(h_, table_), total);
    if (!this->writeTree() || !this->writeMesh())
      return false;
    for (std::size_t k = 0; k < table_.rows.size(); ++k)
      if (!this->writeArray(table_.rows[k]) || !this->writeMeans(table_.rows[k], table_.more[k]))
        return false;
    h_.fileBytes = file_.place();
    file_.end(packHeader(h_, table_));
    return true;
  }

private:
  /// Numbers points in the order in which triangles use them.
  void orderPoints()
  {
    triangles_.resize(tree_.size());
    std::size_t place = 0;
    for (const std::uint32_t cluster : layout_.clusters)
      for (std::uint32_t k = 0; k < a_.clusters[cluster].count; ++k)
        triangles_[place++] =
          static_cast<std::uint32_t>(a_.idOf(a_.clusters[cluster].firstId + std::uint64_t{k}));
    pointPlace_.assign(mesh_.pointCount(), none);
    for (const std::uint32_t triangle : triangles_)
      for (const std::uint32_t point : mesh_.triangles()[triangle])
        if (pointPlace_[point] == none)
        {
          pointPlace_[point] = static_cast<std::uint32_t>(points_.size());
          points_.push_back(point);
        }
  }

  void planTable()
  {
    const auto add = [&](const NamedArray& array, std::uint32_t role, std::uint64_t tuples)
    { table_.rows.push_back(rowFor(array, role, tuples)); };
    const auto addIndices = [&](const std::string& name, std::uint32_t role, std::uint64_t tuples)
    {
      if (!name.empty())
        add({name, ArrayView(nullptr, ArrayView::Type::UInt32, tuples, 1), {}}, role, tuples);
    };
    for (const NamedArray& array : contents_.points)
    {
      add(array, Header::ofPoints, points_.size());
      if (array.name == contents_.normals)
        h_.normals = static_cast<std::uint32_t>(table_.rows.size());
    }
    addIndices(contents_.pointIndices, Header::ofPoints, points_.size());
    for (const NamedArray& array : contents_.cells)
      add(array, Header::ofCells, triangles_.size());
    addIndices(contents_.cellIndices, Header::ofCells, triangles_.size());
    for (const NamedArray& array : contents_.facts)
      if (bytesOf(array.values.type()) > 0)
        add(array, Header::ofWhole, array.values.count());
    for (const FileTableRow& row : table_.rows)
      table_.more.push_back({0, meanRowsOf(row) * this->places() * sizeof(float)});
  }

  std::size_t places() const { return a_.nodes.size() * RlodTree::trianglesPerCluster; }

  /// Rows of means of an array; indices and normals have none.
  std::size_t meanRowsOf(const FileTableRow& row) const
  {
    const ArrayView& values = row.array.values;
    const bool colours =
      row.entry.role != Header::ofWhole && values.data() != nullptr &&
      !(row.entry.role == Header::ofPoints && row.array.name == contents_.normals);
    return colours ? StoredMeans::rowsOf(values.type(), values.components()) : 0;
  }

  /// Writes means of an array over what R-LODs stand for.
  bool writeMeans(const FileTableRow& row, FileSection& section)
  {
    if (section.bytes == 0)
      return true;
    section = file_.section(section.bytes);
    const ArrayView& values = row.array.values;
    for (std::size_t k = 0; k < meanRowsOf(row); ++k)
    {
      const int component = StoredMeans::componentOf(k, values.components());
      const auto ofCells = [&](std::uint64_t triangle, double* value)
      {
        const ArrayView& cell = contents_.cellOf;
        *value = values.value(
          cell.empty() ? triangle : static_cast<std::size_t>(cell.value(triangle)), component);
      };
      const auto ofPoints = [&](std::uint64_t triangle, double* value)
      {
        const MeshCorners::Corners& points = mesh_.triangles()[triangle];
        *value = (values.value(points[0], component) + values.value(points[1], component) +
                   values.value(points[2], component)) /
                 3.0;
      };
      const std::vector<float> means = row.entry.role == Header::ofPoints
                                         ? tree_.lodMeans(1, ofPoints)
                                         : tree_.lodMeans(1, ofCells);
      using OfNode = std::array<float, RlodTree::trianglesPerCluster>;
      const auto* ofNodes = reinterpret_cast<const OfNode*>(means.data());
      if (!this->putPieces<OfNode>(
            a_.nodes.size(), [&](std::size_t i) { return ofNodes[layout_.nodes[i]]; }))
        return false;
    }
    return true;
  }

  void planHeader()
  {
    h_.nodeBytes = sizeof(RlodNode);
    h_.clusterBytes = sizeof(TriangleCluster);
    h_.planesBytes = sizeof(RlodPlanes);
    h_.wordsBytes = sizeof(RlodWords);
    h_.triangles = triangles_.size();
    h_.points = points_.size();
    h_.firstLevel = a_.levels.first;
    h_.levelStep = a_.levels.step;
    h_.hasTime = contents_.time.has_value();
    h_.time = contents_.time.value_or(0.0);
    h_.placeBytes = contents_.places.type() == ArrayView::Type::Float32 ? 4 : 8;
    h_.unit = tree_.unit_;
    h_.cost = tree_.cost_;
    const Box bounds = tree_.bounds();
    for (int k = 0; k < 3; ++k)
    {
      h_.origin[k] = tree_.origin_[k];
      h_.lower[k] = tree_.lower_[k];
      h_.upper[k] = tree_.upper_[k];
      h_.bounds[k] = bounds.lower[k];
      h_.bounds[3 + k] = bounds.upper[k];
    }
  }

  /// Writes a section of `count` values, which fill(piece, first, last) makes in pieces.
  template <typename Value, typename Fill>
  bool writePieces(FileSection& section, std::size_t count, const Fill& fill)
  {
    section = file_.section(count * sizeof(Value));
    return this->putPieces<Value>(count, fill);
  }

  template <typename Value, typename Fill>
  bool putPieces(std::size_t count, const Fill& fill)
  {
    RawVector<Value> piece;
    for (std::size_t first = 0; first < count; first += aPiece)
    {
      const std::size_t last = std::min(count, first + aPiece);
      piece.resize(last - first);
      tbb::parallel_for(tbb::blocked_range<std::size_t>(first, last, 1 << 11),
        [&](const tbb::blocked_range<std::size_t>& range)
        {
          for (std::size_t i = range.begin(); i != range.end(); ++i)
            piece[i - first] = fill(i);
        });
      if (!file_.put(piece.data(), piece.size() * sizeof(Value)))
        return false;
    }
    return true;
  }

  bool writeTree()
  {
    const auto nodeAt = [&](std::size_t i)
    {
      RlodNode node = a_.nodes[layout_.nodes[i]];
      node.firstNode =
        node.children > node.clusters ? layout_.nodePlace[std::uint32_t{node.firstNode}] : 0;
      node.firstCluster =
        node.clusters > 0 ? layout_.clusterPlace[std::uint32_t{node.firstCluster}] : 0;
      return node;
    };
    const auto wordsAt = [&](std::size_t i)
    {
      RlodWords words = a_.words[layout_.nodes[i]];
      for (std::uint32_t k = 0; k < a_.nodes[layout_.nodes[i]].children; ++k)
        words.word[k] =
          words.level(k) << RlodWords::indexBits | layout_.clusterPlace[words.cluster(k)];
      return words;
    };
    const auto planesAt = [&](std::size_t i)
    {
      RlodPlanes planes = a_.planes[layout_.nodes[i]];
      const RlodWords& words = a_.words[layout_.nodes[i]];
      for (std::uint32_t k = 0; k < a_.nodes[layout_.nodes[i]].children; ++k)
      {
        const std::uint32_t speaker = words.cluster(k);
        planes.triangle[k] = layout_.firstTriangle[speaker] + a_.clusters[speaker].count / 2U;
      }
      return planes;
    };
    const auto clusterAt = [&](std::size_t i)
    {
      TriangleCluster cluster = a_.clusters[layout_.clusters[i]];
      cluster.firstId = layout_.firstTriangle[layout_.clusters[i]];
      return cluster;
    };
    return this->writePieces<RlodNode>(h_.nodes, a_.nodes.size(), nodeAt) &&
           this->writePieces<RlodWords>(h_.words, a_.nodes.size(), wordsAt) &&
           this->writePieces<RlodPlanes>(h_.planes, a_.nodes.size(), planesAt) &&
           this->writePieces<TriangleCluster>(h_.clusters, a_.clusters.size(), clusterAt);
  }

  bool writeMesh()
  {
    using Corners = MeshCorners::Corners;
    const auto cornersAt = [&](std::size_t i)
    {
      Corners corners = mesh_.triangles()[triangles_[i]];
      for (std::uint32_t& corner : corners)
        corner = pointPlace_[corner];
      return corners;
    };
    const auto offsetAt = [](std::size_t i) { return static_cast<std::int32_t>(3 * i); };
    const auto placeAt = [&]<typename T>(std::size_t i, T)
    {
      std::array<T, 3> place;
      for (int k = 0; k < 3; ++k)
        place[static_cast<std::size_t>(k)] = static_cast<T>(contents_.places.value(points_[i], k));
      return place;
    };
    using Narrow = std::array<float, 3>;
    using Wide = std::array<double, 3>;
    return this->writePieces<Corners>(h_.corners, triangles_.size(), cornersAt) &&
           this->writePieces<std::int32_t>(h_.offsets, triangles_.size() + 1, offsetAt) &&
           (h_.placeBytes == 4 ? this->writePieces<Narrow>(h_.places, points_.size(),
                                   [&](std::size_t i) { return placeAt(i, 0.0f); })
                               : this->writePieces<Wide>(h_.places, points_.size(),
                                   [&](std::size_t i) { return placeAt(i, 0.0); }));
  }

  /// The input's index of what has place i.
  std::size_t indexAt(std::uint32_t role, std::size_t i) const
  {
    if (role == Header::ofPoints)
      return points_[i];
    const std::size_t triangle = triangles_[i];
    return contents_.cellOf.empty() ? triangle
                                    : static_cast<std::size_t>(contents_.cellOf.value(triangle));
  }

  bool writeArray(FileTableRow& row)
  {
    if (row.entry.role == Header::ofWhole)
      return file_.putArray(row);
    const ArrayView values = row.array.values;
    const std::size_t count = row.entry.tuples;
    const std::size_t tuple =
      bytesOf(values.type()) * static_cast<std::size_t>(values.components());
    const auto* data = static_cast<const unsigned char*>(values.data());
    row.entry.section = file_.section(row.entry.section.bytes);
    Extremes found(values.components());
    RawVector<unsigned char> piece;
    for (std::size_t first = 0; first < count; first += aPiece)
    {
      const std::size_t last = std::min(count, first + aPiece);
      piece.resize((last - first) * tuple);
      tbb::parallel_for(tbb::blocked_range<std::size_t>(first, last, 1 << 11),
        [&](const tbb::blocked_range<std::size_t>& range)
        {
          for (std::size_t i = range.begin(); i != range.end(); ++i)
          {
            const std::size_t index = this->indexAt(row.entry.role, i);
            const auto number = static_cast<std::uint32_t>(index);
            // Without data the values are the indices themselves.
            const void* from =
              data != nullptr ? data + index * tuple : static_cast<const void*>(&number);
            copyTuple(&piece[(i - first) * tuple], static_cast<const unsigned char*>(from), tuple);
          }
        });
      found.add(
        extremesOf(ArrayView(piece.data(), values.type(), last - first, values.components())));
      if (!file_.put(piece.data(), piece.size()))
        return false;
    }
    complete(row, found);
    return true;
  }

  const RlodTree& tree_;
  const RlodTreeArrays& a_;
  const TriangleMesh& mesh_;
  const RlodTreeFileContents& contents_;
  FileWriter file_;
  RlodTreeLayout layout_;
  RawVector<std::uint32_t> triangles_;  ///< the mesh's triangle at each place
  RawVector<std::uint32_t> points_;     ///< the mesh's point at each place
  RawVector<std::uint32_t> pointPlace_; ///< of each of the mesh's points
  RlodTreeFileHeader h_;
  FileTable table_;
};

bool writeRlodTreeFile(const std::string& name, const RlodTree& tree, const TriangleMesh& mesh,
  const RlodTreeFileContents& contents, const Progress& progress)
{
  checkContents(tree, mesh, contents);
  return RlodTreeFileWriter(name, tree, mesh, contents, progress).write();
}

} // namespace mote
