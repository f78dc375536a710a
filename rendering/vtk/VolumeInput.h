#pragma once

#include "GridCells.h"
#include "ParticleInput.h"
#include "VisibleCells.h"
#include "kernels/hexahedra/HangingPoints.h"
#include "kernels/hexahedra/HexStructure.h"
#include "kernels/hexahedra/HiddenCells.h"
#include "kernels/hexahedra/WalkCells.h"
#include "kernels/scene/Cloud.h"

#include <memory>
#include <utility>
#include <vector>

class vtkUnstructuredGrid;

namespace mote
{

/// The mesh of a volume, and what rays go through it by, which follow a pipeline's output.
class VolumeGeometry
{
public:
  /// Whether the mesh is of the grid's cells: points, types, offsets and connectivity are the same
  /// arrays, unchanged, or have the same content.
  bool hasCellsOf(vtkUnstructuredGrid* grid);

  /// Takes the grid's cells where they are not those that are there. True where it did; there is no
  /// structure and no adjacency then. Throws Error as HexMesh does, and where the grid has no cells
  /// or none that can be drawn, and has no mesh then.
  bool takeCells(vtkUnstructuredGrid* grid);

  /// Whether there is a structure over the mesh as the options want it.
  bool hasStructure(const HexStructureOptions& options) const;
  /// Builds the structure over the mesh. Throws as makeHexStructure() does.
  void build(const HexStructureOptions& options);
  void forgetStructure();

  /// Tells the structure, if there is one, the ranges of a field; a structure that somebody looks
  /// at is left alone, and a copy takes its place.
  void setRanges(const HexField& field);

  /// Finds which cells share faces, which walks need, where that is not known.
  void findNeighbours();
  /// What camera rays need to go from cell to cell, of a field on the mesh.
  std::shared_ptr<const WalkCells> makeWalk(const HexField& field);

  /// The mesh's hanging nodes, found when they are first asked for.
  const std::vector<HangingPoint>& hangingPoints();

  void forget() { *this = VolumeGeometry(); }

  /// Adds what it takes in memory: what there is, and its bytes. Steps over the same mesh share all
  /// but the ranges.
  void addMemory(std::vector<std::pair<const void*, std::size_t>>& pieces) const;

  const std::shared_ptr<const HexMesh>& mesh() const { return mesh_; }
  std::shared_ptr<const HexStructure> structure() const { return structure_; }

private:
  void lookForWelds(vtkUnstructuredGrid* grid);

  InputKey seenKey_; ///< times of the arrays that were looked at last
  ContentHash seen_; ///< and what they held
  /// Of cells that have points of their own, the points that stand for these; null for none. They
  /// hold where all arrays have one value for them.
  std::shared_ptr<const std::vector<vtkIdType>> welds_;
  ContentHash weldsContent_; ///< what they were found for
  InputKey valuesKey_;       ///< times of the arrays whose values were looked at
  bool areWelded_ = false;   ///< by what these hold
  ContentHash content_;
  std::shared_ptr<const HexMesh> mesh_; ///< made of `content_`
  bool isWelded_ = false;               ///< and of `welds_`
  InputKey structureKey_;
  std::shared_ptr<HexStructure> structure_;
  std::shared_ptr<const char> built_;              ///< the same for all copies of the structure
  std::shared_ptr<const FaceAdjacency> adjacency_; ///< of the mesh, once it was asked for
  std::shared_ptr<WalkViews> views_;               ///< the same
  std::shared_ptr<const std::vector<HangingPoint>> hangingPoints_; ///< the same
};

/// The cells of a mesh that are not visible, kept for as long as both stay what they are.
class HiddenOfMesh
{
public:
  /// Null where all are visible. Throws Error as VisibleCells does.
  std::shared_ptr<const HiddenCells> of(
    const std::shared_ptr<const HexMesh>& mesh, VisibleCells& visible);

private:
  std::shared_ptr<const HiddenCells> hidden_;
  std::shared_ptr<const HexMesh> mesh_;
  InputKey key_;
};

/// What one mapper has made of a grid and another may take over, instead of making it.
struct BuiltVolume
{
  VolumeGeometry geometry;
  std::shared_ptr<const HexField> field;
  std::shared_ptr<const WalkCells> walk; ///< of the field, once it was needed
  InputKey fieldKey;                     ///< what the field was taken from
  OtherField followed;                   ///< by isosurfaces, where that is another
  InputKey followedKey;                  ///< the same of it
  double buildTime = 0.0;                ///< seconds, of the structure

  /// What it takes in memory, as VolumeGeometry::addMemory() tells it.
  std::vector<std::pair<const void*, std::size_t>> memory() const;

  void forgetField()
  {
    field = nullptr;
    walk = nullptr;
    fieldKey.clear();
    this->forgetFollowed();
  }
  void forgetFollowed()
  {
    followed = {};
    followedKey.clear();
  }
};

} // namespace mote
