#pragma once

#include "../core/FileArray.h"
#include "../core/MappedFile.h"
#include "../core/Progress.h"
#include "RlodTree.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mote
{

struct FileTable;
struct RlodTreeFileHeader;

/// What a file of triangles holds besides their tree.
struct RlodTreeFileContents
{
  /// Places of the mesh's points in the input's coordinates: three numbers each. Kept as float, or
  /// as double where they are that.
  ArrayView places;
  /// One tuple a point of the mesh, in its order.
  std::vector<NamedArray> points;
  /// One tuple a cell of the input, in its order; triangles get those of their cells.
  std::vector<NamedArray> cells;
  /// The cell that each triangle of the mesh is of, whole numbers; empty: triangles are cells.
  ArrayView cellOf;
  /// About the whole; of any length.
  std::vector<NamedArray> facts;
  std::optional<double> time;
  /// Names of one more array for the points' and the triangles' cells' indices in the input; none
  /// if empty.
  std::string pointIndices, cellIndices;
  /// Which of `points` are normals that make triangles smooth; none if empty.
  std::string normals;

  /// How nodes stand in the file.
  enum class Order
  {
    ByError, ///< those that err by more first: so few pages hold what pictures read that may err
    // For comparison:
    DepthFirst, ///< as the tree has them
    ByArea,     ///< those whose boxes have more surface first: rays are likelier to meet them
    Blocks      ///< blocks of a page, each with the likeliest nodes below those it begins with
  };
  Order order = Order::ByError;
};

/// Writes a tree with R-LODs, the triangles of the mesh that it was built over, and what belongs to
/// them as a file (docs/mote-file.md) that RlodTreeFile opens. The file appears under its name
/// complete or not at all; false where `progress` stopped it.
///
/// Clusters are in the order of their nodes, triangles in that of their clusters, points in that in
/// which triangles use them; points that no triangle uses are left out.
/// Throws WriteError where the file cannot be written, and Error where an array has not one tuple a
/// point or a cell, has two arrays' or no name, where the tree has no R-LODs, or for more triangles
/// than 715 million.
bool writeRlodTreeFile(const std::string& name, const RlodTree& tree, const TriangleMesh& mesh,
  const RlodTreeFileContents& contents, const Progress& progress = {});

/// A file of triangles, opened: a tree and arrays that lie in it, whatever its size. Opening reads
/// the header and the tree's nodes, not its clusters, planes or arrays; pages come in as rays touch
/// them.
///
/// The file must not be made shorter while it is in use (see MappedFile).
class RlodTreeFile
{
public:
  /// Throws Error, in one sentence that names the file, where it is missing or unreadable, of
  /// another format, version or kind of machine, cut short, or where what the header or the nodes
  /// say does not fit together. What clusters hold is not looked at, and may, where the file is
  /// damaged, give a wrong picture, but never makes a ray look outside of the file.
  explicit RlodTreeFile(
    const std::string& name, MappedFile::Paging paging = MappedFile::Paging::Ahead);

  const std::string& name() const;
  std::uint64_t bytes() const;

  /// The tree, with R-LODs, whose triangles' input indices are those of corners(). Each copy keeps
  /// the file open; none can be refitted. Where pages come one by one it spares memory: see
  /// RlodTree::setSparesMemory().
  std::shared_ptr<RlodTree> tree() const;
  /// The points of each triangle. Keeps the file open.
  const std::shared_ptr<const MeshCorners>& corners() const { return corners_; }
  /// Three times the number of each triangle, and of all: where corners begin, as VTK wants it.
  ArrayView offsets() const { return offsets_; }
  /// Three coordinates a point.
  ArrayView places() const { return places_; }
  std::size_t pointCount() const { return places_.count(); }
  std::size_t size() const { return corners_->size(); } ///< triangles
  /// Of the places of the points.
  const Box& bounds() const { return bounds_; }

  /// The views hold while this object, a tree() or corners() of it live.
  const std::vector<FileArray>& points() const { return points_; } ///< one tuple a point
  const std::vector<FileArray>& cells() const { return cells_; }   ///< one tuple a triangle
  const std::vector<FileArray>& facts() const { return facts_; }
  std::optional<double> time() const { return time_; }
  const std::string& normals() const { return normals_; } ///< name of one of points(), or empty

  /// Parts of the file in bytes, from its begin, for who counts what was read.
  struct Part
  {
    const char* name;
    std::uint64_t offset, bytes;
  };
  const std::vector<Part>& parts() const { return parts_; }

  /// Whether `beginning`, 8 bytes or more, is that of such a file.
  static bool recognises(std::string_view beginning);

private:
  void takeTree(const RlodTreeFileHeader& header);
  void takeTable(const RlodTreeFileHeader& header, FileTable& table);
  void takeMeans(const FileTable& table);

  std::shared_ptr<const MappedFile> file_;
  std::shared_ptr<const RlodTree> tree_;
  std::shared_ptr<const MeshCorners> corners_;
  ArrayView offsets_, places_;
  Box bounds_;
  std::vector<FileArray> points_, cells_, facts_;
  std::optional<double> time_;
  std::string normals_;
  std::vector<Part> parts_;
};

} // namespace mote
