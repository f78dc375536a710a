#pragma once

#include "../core/StoredArray.h"
#include "../core/StoredMeans.h"
#include "../core/WeightedSum.h"
#include "IsParticleStructure.h"
#include "RepeatedSpheres.h"
#include "StoredParticles.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace mote
{

class ScratchSpace;
struct StoredRanges;

/// How a PkdTree is built.
struct PkdTreeOptions
{
  enum class Split
  {
    MaximumExtent, ///< across the longest side of what is split
    RoundRobin     ///< across x, y, z in turn
  };
  Split split = Split::MaximumExtent;
  bool keepIndices = true; ///< keep the way back to the input index: 4 or 8 bytes a particle
  /// Where at most one particle in so many is shown, rays meet a tree of those alone, 33 bytes each
  /// (37 where radii differ); 0: never.
  std::size_t sparseShare = 8;
  /// Where the tree lies, in place of the heap; null for the heap.
  std::shared_ptr<ScratchSpace> space;

  /// What centres are kept in; see PkdTree::positionError(). Others than Exact take both while they
  /// build.
  enum class Form
  {
    Exact,  ///< 12 bytes a particle, at least as fine as float
    Bytes8, ///< 8: 20 bits of each coordinate, counted from the treelet's corner
    Bytes4  ///< 4: 10 bits of each, counted from the middle of the bucket
  };
  Form form = Form::Exact;
  /// Largest positionError() of a form that is not exact, as a share of the smallest radius.
  double mostError = 0.05;
};

/// The names of the forms, for options and messages, in the order of PkdTreeOptions::Form.
const std::vector<std::string>& pkdTreeFormNames();

/// A balanced k-d tree over particles, without pointers.
///
/// The particles themselves are reordered, by splits at medians, so that 16 neighbours make a
/// bucket, 16 buckets a treelet, 16 treelets a node above them, and so on: where the children of a
/// node are follows from its number. A node holds the bounds of its 16 children's spheres in 8 bits
/// each, and nothing else; a ray looks at all 16 at once. A bucket holds x, y, z and, where radii
/// differ, r of its particles, each a row of 16 numbers.
///
/// Coordinates are multiples of one power of two, step(), counted from a corner of the treelet: at
/// least as fine as float numbers relative to the middle of the set, and much finer in large sets.
/// Coincident particles stay coincident. Functions without a comment do what IsParticleStructure
/// says.
///
/// Source: Wald, Knoll, Johnson, Usher, Pascucci, Papka, "CPU Ray Tracing Large Particle Data with
/// Balanced P-k-d Trees", IEEE Vis 2015; docs/pkd-tree.md says what is done otherwise.
class PkdTree : public StoredParticles
{
public:
  static constexpr int fanout = 16; ///< children of a node, buckets of a treelet
  static constexpr int bucketSize = 16;
  static constexpr std::size_t treeletSize = std::size_t{fanout} * bucketSize;

  /// Most particles of a tree: casting counts its buckets in 32 bits.
  static constexpr std::size_t mostParticles = std::size_t{bucketSize} << 32;

  static std::string name() { return "pkd-tree"; }
  using Options = PkdTreeOptions;

  /// Takes little memory besides what it leaves. Throws Error also for more than mostParticles, and
  /// where the form asked for would move particles by more than the options allow.
  void build(const ParticleSet& particles, const PkdTreeOptions& options = {},
    const Progress& progress = {});
  void cast(RayPacket& packet, std::int32_t object) const;
  /// `poe` is how many pixels of error are allowed: where there are levels of detail, boxes stand
  /// for particles below nodes whose error is smaller than so many footprints of the rays. A ray
  /// that hits one tells its slot, and where it enters it. 0 is exact.
  void cast(RayBundle& bundle, std::int32_t object, double poe = 0.0) const;
  void occlude(RayPacket& packet, std::int32_t object) const;
  void occlude(RayBundle& bundle, std::int32_t object) const;
  /// The larger a bucket looks, the larger.
  int bundleSide(const CameraRays& rays, int x0, int y0, int size, double poe = 0.0) const;

  /// Makes levels of detail: 64 bytes a node, 0.27 a particle, in the space, or where it is null on
  /// the heap. Reads all particles, in parallel. A tree that has them is neither read nor changed.
  void makeLods(const std::shared_ptr<ScratchSpace>& space = nullptr);
  void dropLods();
  bool hasLods() const { return !lods_.empty(); }

  /// Slots of levels of detail, which cast() tells: 16 times a node, and the place of its child
  /// that the box stands for. No particle has such a slot, and none but the functions below take
  /// one.
  static constexpr std::uint64_t lodBit = std::uint64_t{1} << 62;
  static bool isLod(std::uint64_t slot) { return slot >> 62 == 1; }
  /// A box that stands for particles, in the input's coordinates.
  struct Lod
  {
    Vec3d center, half; ///< of the bounds of the spheres, which the box is a part of
    /// Shares of the bounds' faces across x, y and z behind which there is a sphere, rounded to
    /// a sixteenth of themselves, but up to 1.
    Vec3d coverage;
    double
      error; ///< how far aside of all spheres lines through the box may pass, about; or infinity
  };
  Lod lod(std::uint64_t slot) const;           ///< of a slot of theirs, where hasLods()
  std::vector<std::uint64_t> lodSlots() const; ///< of all that stand for particles
  /// The slots of the particles that it stands for.
  SlotRun slotsBelow(std::uint64_t lodSlot) const;
  /// The slot of a particle that speaks for the others.
  std::uint64_t speaker(std::uint64_t lodSlot) const
  {
    const SlotRun below = slotsBelow(lodSlot);
    return below.first + (below.last - below.first) / 2;
  }

  /// Where a number for each stands in an array that has one for each.
  static std::uint64_t lodPlace(std::uint64_t slot) { return slot & ~lodBit; }
  /// Writes up to mostMeans numbers for a particle of the input; called from several threads.
  using ParticleValues = std::function<void(std::uint64_t particle, double* values)>;
  static constexpr int mostMeans = WeightedSum::most;
  /// Means of them over the particles of each, weighted by the squares of radii: `components`
  /// numbers at lodPlace(). What is not finite does not count; NaN where nothing else is there.
  std::vector<float> lodMeans(int components, const ParticleValues& valuesOf) const;
  /// The same of one component of an array of the file that the tree lies in, from the file; empty
  /// where it holds none.
  ArrayView storedMeans(const ArrayView& values, int component) const
  {
    return storedMeans_ ? storedMeans_->find(values, component) : ArrayView();
  }

  /// Takes 16 bytes a particle, and 0.2 for the least and greatest values below every node.
  void setAttributes(const std::vector<ParticleAttribute>& attributes);
  /// Looks, in parallel, at the particles of those treelets that lie neither inside nor outside as
  /// a whole, and keeps a bit for each particle; rays pass over nodes without any (see also
  /// PkdTreeOptions::sparseShare).
  void setRanges(const ParticleRanges& ranges);
  void setVisibility(const std::function<bool(std::size_t slot)>& shown);
  bool isShown(std::size_t slot) const;
  std::size_t shownCount() const;
  /// Looks at nodes, not at particles.
  std::vector<SlotRun> slotsBetween(int k, double low, double high) const;
  void findNear(const Vec3d& point, double distance, std::vector<NearParticle>& found) const;

  PkdTreeOptions::Form form() const { return static_cast<PkdTreeOptions::Form>(3 - placeRows_); }
  /// Coordinates are multiples of this, in the input's unit of length: a power of two.
  double step() const { return step_; }
  /// Most by which a coordinate of a centre may differ from the input's, in the input's unit of
  /// length and beside the rounding of double: half a step, and what sorting rounded.
  double positionError() const;
  Vec3d center(std::size_t slot) const;
  double radius(std::size_t slot) const;
  std::uint64_t inputIndex(std::size_t slot) const;
  /// Whether indices of the input are known: kept, or those of slots.
  bool knowsInput() const { return indexWords_ > 0 || inOrder_; }
  /// Memory, or, where the particles lie in a file (see PkdTreeFile), their size there.
  std::size_t bytes() const;
  /// Levels of nodes; buckets do not count.
  int levels() const { return static_cast<int>(levels_.size()); }

private:
  struct Builder;
  template <typename Tree>
  friend struct KdBuilder;
  friend struct PkdTreeQuery;
  friend class PkdTreeMeans;
  friend struct PkdTreeView;
  friend class PkdTreeFile;
  friend class PkdTreeFileWriter;

  /// Bounds of 16 children: `lower` + bounds * 2^(exponent - 127), in unit() from origin().
  /// Children that do not exist have low > high.
  struct alignas(64) Node
  {
    std::array<float, 3> lower;
    std::array<float, 3> corner; ///< that coordinates count from; of treelets only
    std::array<std::uint8_t, 3> exponent;
    std::array<std::uint8_t, 5> unused;
    std::array<std::array<std::uint8_t, fanout>, 3> low, high;

    /// The middle of a child's bounds, from `corner` of a treelet.
    float middle(std::size_t axis, std::size_t child) const
    {
      const auto half = std::bit_cast<float>((std::uint32_t{exponent[axis]} - 1) << 23);
      return (lower[axis] - corner[axis]) + half * float(low[axis][child] + high[axis][child]);
    }
  };
  static_assert(sizeof(Node) == 128);

  /// What is known of a node's children, for boxes that stand for what is below them.
  struct alignas(64) Lods
  {
    /// How far aside of all spheres lines through the child's box may pass, in lodStep(), rounded
    /// up.
    std::array<std::uint8_t, fanout> error;
    /// How much what is in its bounds thins light along x, y and z: thicknessOf(), of -log of the
    /// share of the face across that axis which is open.
    std::array<std::array<std::uint8_t, fanout>, 3> thickness;

    /// Three bits of a float's fraction and five of its exponent.
    static float thicknessOf(std::uint8_t bits)
    {
      return std::bit_cast<float>((std::uint32_t{bits} + firstThickness) << 20);
    }
    static std::uint8_t bitsOf(float thickness)
    {
      const std::uint32_t half = 1u << 19,
                          bits = (std::bit_cast<std::uint32_t>(thickness) + half) >> 20;
      return static_cast<std::uint8_t>(
        std::clamp(bits, firstThickness, firstThickness + 255) - firstThickness);
    }
    static constexpr std::uint32_t firstThickness = (127 - 28) << 3; ///< 2^-28
  };
  static constexpr std::uint8_t noLod = 255; ///< an error that is never allowed

  /// One number of each particle of a bucket: a cache line.
  struct alignas(64) Row
  {
    std::array<std::uint32_t, bucketSize> words;
  };

  /// Nodes of one height, in the order of the particles below them.
  struct Level
  {
    std::size_t first; ///< in nodes_
    std::size_t count;
  };

  /// A bit for each of 16 particles or children, the first lowest.
  using Bits = std::uint16_t;

  /// Corners of treelets are multiples of 2^cornerBits of the numbers that are sorted.
  static constexpr int cornerBits = 10;

  /// Least and greatest of spheres' coordinates, in unit() from origin().
  struct Bounds
  {
    std::array<double, 3> lower, upper;

    Bounds();
    void add(const Bounds& b);
    void add(const Vec3d& center, double radius)
    {
      for (int k = 0; k < 3; ++k)
      {
        const auto axis = static_cast<std::size_t>(k);
        lower[axis] = std::min(lower[axis], center[k] - radius);
        upper[axis] = std::max(upper[axis], center[k] + radius);
      }
    }
  };

  /// A tree over the particles that are shown alone. The first three rows of a bucket are places
  /// from the corners of the treelets of the whole tree, then come r, where radii differ, and three
  /// rows with those corners: rays find the same numbers as in the whole tree.
  struct Sparse
  {
    std::size_t count = 0;
    Bounds bounds;
    std::vector<Level> levels;
    RawVector<Node> nodes;
    RawVector<Row> rows;
    RawVector<std::uint64_t> slots; ///< in the whole tree
  };

  /// A particle on its way there.
  struct SparseParticle
  {
    Vec3f place;
    float radius;
    Vec3f corner;
    std::uint64_t slot;
  };

  /// Least and greatest of the radius and the attributes below a node, but for NaN.
  struct ValueBounds
  {
    float smallest = std::numeric_limits<float>::infinity(), largest = 0.0f; ///< radius
    std::array<float, 4> least, greatest;
    std::array<std::uint32_t, 4> hasNaN{};

    ValueBounds();
    void add(const ValueBounds& b);
  };

  void clear();
  /// Levels of a tree over `count` particles. Returns how many nodes it has.
  static std::size_t planLevels(std::size_t count, std::vector<Level>& levels);
  /// Bounds of a node: `all` of it, and its children's, widened by a margin. With a `step`, in
  /// unit(), the bounds and the middles of children's are whole numbers of it.
  static void setBounds(Node& node, const Bounds& all, const std::array<Bounds, fanout>& children,
    double marginOfSet, double step = 0.0);
  /// Sets the bounds of all nodes above treelets, `below` being those of treelets; returns the
  /// root's.
  static Bounds boundNodes(
    const std::vector<Level>& levels, Node* nodes, std::vector<Bounds> below, double marginOfSet);
  /// By which rays may be rounded, in unit().
  double roundingMargin() const;
  ValueBounds boundsOfTreelet(std::size_t treelet) const;
  void findValueBounds();
  void findRepeats();
  bool isOneSphere(std::size_t treelet) const;
  void groupRepeats(const RawVector<std::uint8_t>& isOne);
  void findShown();
  void leaveOutRepeats();
  void findInRange(const StoredRanges& stored);
  void findNodesShown();
  void findNodesWhole();
  template <typename OfBucket, typename OfNode>
  void fillNodeBits(RawVector<Bits>& bits, const OfBucket& ofBucket, const OfNode& ofNode) const;
  Bits visibleIn(std::size_t bucket) const;
  /// Bits of a bucket's particles that rays may meet; none: all.
  const RawVector<Bits>& met() const { return met_.empty() ? shown_ : met_; }
  void makeSparse();
  SparseParticle particleAt(std::size_t slot) const;
  /// Fills a bucket of the sparse tree, and its slots, with what `order` has there.
  Bounds copyBucket(const RawVector<SparseParticle>& shown, const PkdTree& order, Sparse& sparse,
    std::size_t bucket) const;
  std::size_t buckets() const { return (count_ + bucketSize - 1) / bucketSize; }
  const Row* bucketOf(std::size_t slot) const { return &rows_[slot / bucketSize * rowsABucket_]; }
  const Node& treeletOf(std::size_t slot) const
  {
    return nodes_[levels_.front().first + slot / treeletSize];
  }
  /// Number of a particle's row `row`; its coordinates from its treelet's corner.
  float number(std::size_t slot, int row) const;
  Vec3f place(std::size_t slot) const;
  float storedRadius(std::size_t slot) const
  {
    return ownRadii_ ? number(slot, placeRows_) : radius_;
  }

  double step_ = 1.0;
  float coarse_ = 1.0f;         ///< corners of treelets are multiples of this, in unit()
  float radius_ = 0.0f;         ///< of all particles, in unit(), where no row of radii is kept
  std::size_t rowsABucket_ = 3; ///< of places, then r, then the input index in one or two rows
  /// 3: x, y and z as float. 2, with 20 bits a coordinate, in steps: x and the 12 lower bits of z,
  /// y and the 8 upper ones. 1, with 10 bits and a sign in each, in steps from the middle of the
  /// bucket's bounds: x, y, z from the lowest bit on.
  int placeRows_ = 3;
  bool ownRadii_ = false;
  int indexWords_ = 0;        ///< rows of the input index
  bool inOrder_ = false;      ///< the input has the tree's own order, and indices are slots
  std::vector<Level> levels_; ///< treelets first, the root last
  StoredArray<Node> nodes_;   ///< the root first
  StoredArray<Row> rows_;     ///< bucket by bucket

  // What is shown.
  std::size_t sparseShare_ = PkdTreeOptions().sparseShare;
  RawVector<Bits> visible_;   ///< a bucket each, or empty: all are
  RawVector<Bits> shown_;     ///< a bucket each, of what ranges leave; or empty
  RepeatedSpheres repeats_;   ///< whole treelets of one sphere
  RawVector<Bits> met_;       ///< shown_, but one particle of each group of repeats_; or empty
  RawVector<Bits> nodeShown_; ///< children of each node that hold anything met; or empty
  RawVector<Bits> nodeWhole_; ///< those with nothing hidden, where lods_ ask; or empty
  StoredArray<Lods> lods_;    ///< of each node, or empty
  RawVector<ValueBounds> valueBounds_; ///< of each node, once a range asks for them
  std::shared_ptr<const StoredMeans> storedMeans_;
  std::shared_ptr<const Sparse> sparse_; ///< what rays meet instead, where little is shown
};

} // namespace mote
