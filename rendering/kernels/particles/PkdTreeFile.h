#pragma once

#include "../core/FileArray.h"
#include "../core/Progress.h"
#include "PkdTree.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace mote
{

struct FileTable;
class MappedFile;
class ScratchSpace;

/// What a file of particles holds besides their places.
struct PkdTreeFileContents
{
  /// One tuple a particle of the input that the tree was built from, in the input's order.
  std::vector<NamedArray> arrays;
  /// About the whole, such as a simulation box; of any length.
  std::vector<NamedArray> facts;
  std::optional<double> time;
  double spacing = 0.0; ///< typical distance between neighbours; 0: not known
  /// Name of one more array for the particles' indices in the input; none if empty.
  std::string indexArray;
  /// Bytes of memory to work in for arrays that lie in a file and are better read from their begin
  /// to their end, some times over; 0 for arrays in memory, which are read here and there.
  std::size_t workBytes = 0;
  /// Where means lie until they are written; null for the heap.
  std::shared_ptr<ScratchSpace> space;
};

/// Writes a tree and what belongs to it as a file (docs/mote-file.md) that PkdTreeFile opens. The
/// file appears under its name complete or not at all; false where `progress` stopped it.
///
/// The file's particles stand in the order of the tree, of coincident ones the first of the input
/// first. Levels of detail are written where the tree has them, with means of the arrays;
/// visibility and ranges are not. Throws WriteError where the file cannot be
/// written, and Error where an array has not one tuple a particle of the input, has two arrays' or
/// no name, or where there are arrays and the tree keeps no indices.
bool writePkdTreeFile(const std::string& name, const PkdTree& tree,
  const PkdTreeFileContents& contents, const Progress& progress = {});

/// A file of particles, opened: a tree and arrays that lie in it, whatever its size. Opening reads
/// the header and a page of each level of the tree; pages come in as rays touch them.
///
/// The file must not be made shorter while it is in use (see MappedFile).
class PkdTreeFile
{
public:
  /// Throws Error, in one sentence that names the file, where it is missing or unreadable, of
  /// another format, version or kind of machine, cut short, or where what the header says does not
  /// fit together. What nodes and rows hold is not looked at, and may, where the file is damaged,
  /// give a wrong picture, but never makes a ray look outside of the file.
  explicit PkdTreeFile(const std::string& name);

  const std::string& name() const;
  std::uint64_t bytes() const;

  /// The tree; each copy is shown in parts (setRanges(), setVisibility()) for itself, and keeps the
  /// file open. Its particles' input indices are their slots. build() makes it forget the file.
  PkdTree tree() const { return tree_; }
  /// The same particles one by one, in the order of slots. Keeps the file open too.
  std::shared_ptr<const ParticleSource> particles() const;
  std::size_t size() const { return tree_.size(); }
  const ParticleStatistics& statistics() const { return tree_.statistics(); }

  /// One tuple a particle, in the order of slots. The views hold while this object, or a tree() of
  /// it, lives.
  const std::vector<FileArray>& arrays() const { return arrays_; }
  const std::vector<FileArray>& facts() const { return facts_; }
  std::optional<double> time() const { return time_; }
  double spacing() const { return spacing_; }

  /// Whether `beginning`, 8 bytes or more, is that of such a file.
  static bool recognises(std::string_view beginning);

private:
  void takeLods(const FileTable& table);
  void checkEnds(const std::string& name) const;

  std::shared_ptr<const MappedFile> file_;
  PkdTree tree_;
  std::vector<FileArray> arrays_, facts_;
  std::optional<double> time_;
  double spacing_ = 0.0;
};

} // namespace mote
