#pragma once

#include "../core/Camera.h"
#include "../core/Progress.h"
#include "../core/RayBundle.h"
#include "../core/RayPacket.h"
#include "../core/StoredMeans.h"
#include "../core/WeightedSum.h"
#include "TriangleMesh.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace mote
{

struct RlodNode;
struct RlodTreeArrays;
struct TriangleCluster;

/// A hierarchy of boxes over triangles, 16 children a node with bounds of 8 bits, whose leaves are
/// clusters of up to 16 triangles; after Yoon, Lauterbach, Manocha, "R-LODs: Fast LOD-based Ray
/// Tracing of Massive Models" (2006). See docs/triangles.md.
///
/// Both sides of triangles are hit, and closed meshes have no gaps: the ray that meets an edge or a
/// corner, or passes it by less than rounding, hits one of the triangles there. Where triangles
/// coincide one of them is hit. Const functions may be called from any number of threads.
class RlodTree
{
public:
  static constexpr std::uint64_t noHit = RayBundle::noHit;

  RlodTree(); ///< of no triangles
  ~RlodTree();
  RlodTree(RlodTree&&) noexcept;
  RlodTree& operator=(RlodTree&&) noexcept;

  /// Builds over the valid triangles of the mesh, in parallel, and forgets what was there. The mesh
  /// is not needed afterwards. The result does not depend on the number of threads. Where
  /// `progress` answers false, which stops it early, nothing is held. Throws Error for more
  /// triangles than the tree's indices count, about 1500 million.
  void build(const TriangleMesh& mesh, const Progress& progress = {});

  /// Takes the points of the mesh that it was built over and that have moved since: much faster
  /// than a build, and the boxes are those of the new points, but which triangles share a box
  /// stays. False, with nothing done, where the valid triangles are others: then build.
  bool refit(const TriangleMesh& mesh);
  /// Whether a triangle of the input is to be seen; called from several threads.
  using TriangleChoice = std::function<bool(std::uint64_t triangle)>;
  /// A tree of some of the triangles of `whole`, not null: rays do not meet the others, and size()
  /// and bounds() are those of what is visible. Much faster than a build: boxes stay as they are,
  /// and R-LODs are taken where all is visible that they stand for. Slots, ids and R-LODs are those
  /// of `whole`, which it holds. The memory of `last`, an earlier part of it that nobody else
  /// holds, is taken for the new one.
  static std::shared_ptr<RlodTree> partOf(std::shared_ptr<const RlodTree> whole,
    const TriangleChoice& isVisible, std::shared_ptr<RlodTree> last = nullptr);
  /// Takes R-LODs that the tree which this is a part of was given since. Not while another thread
  /// casts rays through it.
  void takeLodsOfWhole();
  /// The same tree once more, without R-LODs: to be refitted while others use this one. Another
  /// thread may be making R-LODs of this one meanwhile.
  RlodTree copyWithoutLods() const;

  /// How many boxes of nodes and clusters a ray that meets the whole may expect to meet: their
  /// surface areas over that of the whole. 0 where that has none. What refit() makes of it says how
  /// much worse the tree is than when it was built.
  double cost() const { return cost_; }

  /// Makes R-LODs: for every child of every node a plane that stands for all triangles below it,
  /// with a bound of what that errs by. cast() takes them where it is allowed an error. In parallel
  /// and in linear time, from the tree alone; refit() makes them anew. Without them nothing is
  /// larger or slower.
  void makeLods();
  void dropLods();
  bool hasLods() const;
  /// Whether R-LODs of clusters are taken too, or those of nodes alone, as at first. A cluster
  /// takes no longer to test than its plane, and is exact; but 16 planes are read in place of 16
  /// clusters.
  void setSparesMemory(bool spares) { sparesMemory_ = spares; }

  std::size_t size() const; ///< triangles held that are not hidden
  Box bounds() const;
  double unit() const { return unit_; }
  const Vec3d& origin() const { return origin_; }
  std::size_t bytes() const; ///< of a part: what it does not share with the whole
  std::size_t nodeCount() const;
  std::size_t clusterCount() const;

  /// Finds for each ray the nearest hit with tMin < t < its t, and where there is one writes t,
  /// slot and `object`. `poe` is how many pixels of error are allowed: where there are R-LODs,
  /// those whose error radius is smaller than so many footprints of the rays where their triangles
  /// begin stand for these. The hit is then the point of the ray's part in their box that is
  /// nearest to the plane: a ray that meets the triangles is sure to hit, if only one that passes
  /// them by less than the error may hit too. 0 is exact.
  void cast(RayBundle& bundle, std::int32_t object, double poe = 0.0) const;
  void cast(RayPacket& packet, std::int32_t object, double poe = 0.0) const;
  /// The same of triangles that the ray meets from their inner side, the one that their normals
  /// look away from; exact. The others are not there.
  void castInner(RayBundle& bundle, std::int32_t object) const;
  void castInner(RayPacket& packet, std::int32_t object) const;
  /// t of each ray that meets a triangle with tMin < t < its t becomes -infinity; slot and object
  /// stay as they are. `poe` as in cast(), but R-LODs do not count that hold the end of a ray which
  /// lies on a surface within twice their deviation: that surface would be in its own shadow. In
  /// packets it is the end that these name, in bundles the far one.
  void occlude(RayBundle& bundle, std::int32_t object, double poe = 0.0) const;
  void occlude(RayPacket& packet, std::int32_t object, double poe = 0.0) const;

  /// Nodes, clusters and R-LODs that cast() looks at for a bundle, added up.
  struct Counts
  {
    std::uint64_t nodes = 0, clusters = 0, lods = 0;
    /// Which nodes, planes of nodes and clusters these were; each empty, or as long as there are.
    std::vector<bool> seenNodes, seenPlanes, seenClusters;
  };
  void cast(RayBundle& bundle, std::int32_t object, double poe, Counts& counts) const;

  /// Sizes in memory, for who adds up what was seen.
  static constexpr int bytesPerNode = 128, bytesPerCluster = 224;
  static constexpr int bytesPerWords = 64, bytesPerPlanes = 384; ///< of a node's R-LODs

  /// Slots that cast() tells: 16 times the cluster, and the triangle's place in it. For R-LODs
  /// lodBit, and 16 times the node and the child's place in it. All that asks about slots takes
  /// both kinds: what it tells of an R-LOD is about the plane, or a triangle that speaks for it.
  static constexpr std::uint64_t trianglesPerCluster = 16;
  static constexpr std::uint64_t lodBit = std::uint64_t{1} << 31;
  static bool isLod(std::uint64_t slot) { return (slot & lodBit) != 0; }
  static std::uint64_t lodSlot(std::uint64_t node, unsigned child)
  {
    return lodBit | (node * trianglesPerCluster + child);
  }

  /// A plane that stands for triangles, in the tree's coordinates (see localCorners()).
  struct Lod
  {
    Vec3f normal;    ///< of unit length, turned to the mean normal of the triangles
    float evenness;  ///< length of the mean of the triangles' unit normals, by area; 0.25 at least
    float offset;    ///< dot(normal, p) of the plane's points
    float deviation; ///< no point of the triangles is farther from the plane
    float error;     ///< radius of a sphere about the triangles, and the deviation; rounded up
  };
  Lod lod(std::uint64_t slot) const;           ///< of an R-LOD's slot, where hasLods()
  std::vector<std::uint64_t> lodSlots() const; ///< of all R-LODs
  /// Slots of all triangles that an R-LOD stands for; of a triangle itself. In no order.
  std::vector<std::uint64_t> slotsBelow(std::uint64_t slot) const;

  /// Where a number for each R-LOD stands in an array that has one for each.
  static std::uint64_t lodPlace(std::uint64_t slot) { return slot & ~lodBit; }
  /// Writes up to mostMeans numbers for a triangle of the input; called from several threads.
  using TriangleValues = std::function<void(std::uint64_t triangle, double* values)>;
  static constexpr int mostMeans = WeightedSum::most;
  /// Means of them over the triangles of each R-LOD, weighted by area: `components` numbers at
  /// lodPlace(). What is not finite does not count; NaN where nothing else is there. In parallel
  /// and linear time.
  std::vector<float> lodMeans(int components, const TriangleValues& valuesOf) const;
  /// The same of one component of an array of the file that the tree lies in, from the file; empty
  /// where it holds none. Triangles have the means of their corners' values.
  ArrayView storedMeans(const ArrayView& values, int component) const;

  /// The triangle's index in the input.
  std::uint64_t inputIndex(std::uint64_t slot) const;
  /// Its corners in the tree's coordinates, which count from origin() in units of unit().
  std::array<Vec3f, 3> localCorners(std::uint64_t slot) const;
  /// Normal by the right-hand rule, in the input's coordinates, of any length; 0 for degenerate
  /// triangles. For R-LODs its length is their evenness.
  Vec3f normal(std::uint64_t slot) const;
  /// Normals of many hits, likewise; `normals` are three rows.
  void normals(const std::uint64_t* slots, int count, float* const normals[3]) const;
  void inputIndices(const std::uint64_t* slots, int count, std::uint64_t* indices) const;

private:
  friend struct RlodTreeView;
  friend class RlodTreeFile;
  friend class RlodTreeFileWriter;

  void clear();
  std::uint64_t triangleOf(std::uint64_t slot) const;
  void fill(const TriangleMesh& mesh);

  std::unique_ptr<RlodTreeArrays> arrays_;
  Vec3d origin_{0.0};
  double unit_ = 1.0;
  Vec3f lower_{0.0f}, upper_{0.0f}; ///< of all triangles, in the tree's coordinates
  int depth_ = 0;                   ///< nodes from the root to a leaf, at most
  double cost_ = 0.0;
  bool sparesMemory_ = false;
  std::shared_ptr<const RlodTree> whole_; ///< of which this is a part
};

} // namespace mote
