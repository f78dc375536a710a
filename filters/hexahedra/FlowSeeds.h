#ifndef MoteFlowSeeds_h
#define MoteFlowSeeds_h

#include "LocatorStructure.h"

#include <cstddef>
#include <memory>
#include <vector>

class vtkUnsignedCharArray;

namespace mote
{

/// A mesh that seeds lie in.
struct SeededMesh
{
  std::shared_ptr<const LocatorStructure> structure;
  Mat4d placement{1.0};                   ///< in the world
  vtkUnsignedCharArray* ghosts = nullptr; ///< of its data set; null: no cell is hidden
};

/// Whether a ghost array hides a cell of the data set.
bool isHiddenCell(vtkUnsignedCharArray* ghosts, std::size_t inputCell);

/// So many places in the world within the cells of some meshes that are not hidden: each stands for
/// as much volume, and they lie as evenly as the order of the cells allows. The same ones every
/// time.
std::vector<Vec3d> seedsWithin(const std::vector<SeededMesh>& meshes, std::size_t count);

/// On a line, both ends included; in the middle where there is but one.
std::vector<Vec3d> seedsAlong(const Vec3d& from, const Vec3d& to, std::size_t count);

} // namespace mote

#endif
