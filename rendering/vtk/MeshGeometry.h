#pragma once

#include "ParticleInput.h"
#include "SurfaceSeams.h"

#include "kernels/core/ContentHash.h"
#include "kernels/meshes/RlodTree.h"

#include "vtkType.h"

#include <memory>
#include <string>
#include <vector>

class vtkPointSet;
class vtkUnsignedCharArray;

namespace mote
{

struct SharedFaces;
struct SurfaceTriangles;

/// What of a data set's surface is asked for.
struct SurfaceChoice
{
  vtkUnsignedCharArray* isVisible = nullptr; ///< one value a cell, 0 hides it; null: all
  InputKey visible;                          ///< the key of VisibleCells
  SectorCopies copies;                       ///< that are drawn
  bool withGhosts = false;                   ///< polygons that are copies of another rank's
  bool withOtherSides = false;               ///< of sheets; see innerTree()

  /// Cells of another data set, by which faces may be covered.
  struct Neighbor
  {
    vtkPointSet* data = nullptr;
    vtkUnsignedCharArray* isVisible = nullptr;
    InputKey visible;
  };
  std::vector<Neighbor> neighbors; ///< of cells with a volume
};

/// The triangles of a data set's surface, and the tree over them, which follow a pipeline's output.
///
/// Of a vtkPolyData these are its polygons and strips; of all else with points the faces that no
/// two cells share, and the cells that are flat. Corners are points of the data set. Cells that are
/// not visible are left out, as if they were not there: polygons and strips are hidden in a tree
/// that has all, which builds nothing; of cells with a volume other faces come to light. Of these
/// the faces are left out that copies of a sector cover, or cells of neighbors.
class MeshGeometry
{
public:
  enum class Change
  {
    None,
    Hidden,   ///< other cells are visible, which took no build
    Refitted, ///< the tree took points that have moved
    Built
  };

  /// Whether all that triangles are made of is the very same as at the last update().
  bool fits(vtkPointSet* data, const SurfaceChoice& choice) const;
  /// Whether a tree is there that update() would take, at most with others of its cells visible.
  bool holds(vtkPointSet* data, const SurfaceChoice& choice) const;

  /// Takes the triangles and builds the tree, or does as little of it as it takes: nothing where
  /// points and triangles have the same content or lie in a file, a refit where only points
  /// have moved and it does not make rays much slower; of a copy, where others hold the tree.
  /// Without triangles, or where `progress` stopped it, there is no tree. Throws Error for indices
  /// that are not those of points, and as TriangleMesh and RlodTree do.
  Change update(vtkPointSet* data, const SurfaceChoice& choice, const Progress& progress);

  /// Makes the tree's R-LODs where it has none. Not while another thread casts rays through it.
  void makeLods();

  void forget() { *this = MeshGeometry(); }

  /// Null without triangles that are visible.
  const std::shared_ptr<RlodTree>& tree() const { return part_ ? part_ : tree_; }
  /// For rays that meet inner sides alone: with sheets, flat cells beside cells with a volume, once
  /// more the other way round, where they were asked for. Else as tree().
  const std::shared_ptr<RlodTree>& innerTree() const { return sides_ > 0 ? tree_ : this->tree(); }
  /// The tree that tree() is a part of, or which it is: slots and R-LODs are the same.
  const std::shared_ptr<RlodTree>& whole() const { return tree_; }
  std::shared_ptr<const TriangleMesh> mesh() const { return mesh_; } ///< null for those of files
  std::shared_ptr<const MeshCorners> corners() const { return corners_; }
  /// The cell of the data set that each triangle is of; empty: triangles are cells.
  ArrayView cells() const;
  /// Which sides of each triangle are edges of the data set's cells, as MeshLook::edges; null: all.
  const std::shared_ptr<const std::vector<std::uint8_t>>& edges() const { return edges_; }
  std::size_t bytes() const { return bytes_; } ///< of the whole
  std::size_t bytesOfPart() const { return bytesOfPart_; }
  /// What was left out, as sentences; empty where nothing was.
  std::string report() const;

  vtkIdType linesAndVertices() const { return thin_; } ///< cells that have no area by their kind
  vtkIdType cellsWithoutTriangles() const { return flat_; } ///< polygons with none, and strips
  vtkIdType invalidTriangles() const; ///< triangles with a corner that is not finite

private:
  Change updateAll(vtkPointSet* data, const SurfaceChoice& choice, const Progress& progress);
  SurfaceTriangles uncoveredFaces(vtkPointSet* data, const SurfaceChoice& choice);
  void hide(vtkUnsignedCharArray* isVisible);
  void hideOtherSides();
  bool moveTo(const ArrayView& points);
  bool build(const ArrayView& points, const ArrayView& triangles, const Progress& progress);
  void count();

  InputKey key_;           ///< of the triangles
  InputKey visible_;       ///< of the cells of these that are visible, where part_ is needed
  ContentHash points_;     ///< what they held
  double builtCost_ = 0.0; ///< of the tree when it was built
  std::shared_ptr<TriangleMesh> mesh_;
  std::shared_ptr<const MeshCorners> corners_;
  std::shared_ptr<RlodTree> tree_, part_; ///< of all triangles; of those that are visible
  std::shared_ptr<const std::vector<vtkIdType>> cells_;
  std::shared_ptr<const std::vector<std::uint8_t>> edges_;
  /// Of neighbors and of these cells, for the neighbors: one takes what another has found.
  std::vector<std::shared_ptr<const SharedFaces>> shared_;
  vtkIdType thin_ = 0, flat_ = 0;
  std::size_t sides_ = 0; ///< the last triangles, which are others the other way round
  /// Kept: others that hold the tree may be making its R-LODs.
  std::size_t bytes_ = 0, bytesOfPart_ = 0;
};

/// What one mapper has made of a mesh and another may take over, instead of making it.
struct BuiltMesh
{
  MeshGeometry geometry;
  double buildTime = 0.0; ///< seconds
};

} // namespace mote
