#pragma once

#include "FaceAdjacency.h"
#include "HexMesh.h"
#include "HiddenCells.h"
#include "SliceSurface.h"

#include <functional>
#include <vector>

namespace mote
{

/// A point of a surface in a mesh.
struct SurfacePoint
{
  Vec3d place{0.0};
  Vec3d normal{0.0}; ///< unit length; see the integrals for its side
  std::uint32_t cell = 0;
  CornerValues weights{}; ///< of the cell's corners; together 1
};

/// Writes what is to be integrated; called from several threads.
using Integrand = std::function<void(const SurfacePoint& at, double* values)>;

struct SurfaceIntegrals
{
  std::vector<double> values;
  /// What they may err by, estimated: the differences to a coarser rule, added up.
  std::vector<double> errors;
  std::size_t cells = 0; ///< that the surface meets
};

/// Of two parts of a surface.
SurfaceIntegrals together(SurfaceIntegrals a, const SurfaceIntegrals& b);

/// The integrals of `count` functions over the part of a shape that lies in the mesh, hidden cells
/// left out; null for none. Normals go along the axis, away from it, or with growing angles.
///
/// The shape is met with each trilinear cell as a surface of its coordinates: the cell's unit cube
/// is cut into n^3 cubes of six tetrahedra each, in which the surface is triangles with corners on
/// the shape; n doubles until what changes is less than `tolerance` of the integral of the
/// absolute value in the cell, and the last two are extrapolated. What is linear on a plane in
/// cells with plane faces is exact at once.
///
/// `sizes`, if any, writes for each function the size of what it is made of, such as the speed
/// where that is the velocity along the normal: what changes by less than `tolerance` of the
/// integral of that, over the root of the number of cells, is good enough, too: cells side by side
/// are cut alike, and their errors cancel. Nothing else would end the cutting where there is hardly
/// any flow through a surface, and where a round one only just meets a cell.
SurfaceIntegrals integrateSlice(const HexMesh& mesh, const SliceShape& shape, int count,
  const Integrand& integrand, const HiddenCells* hidden = nullptr, double tolerance = 1e-7,
  const Integrand& sizes = {});

/// The same over the mesh's boundary, whose normals go outwards: bilinear patches, by Gauss' rule
/// with 4 x 4 points each, judged by that with 3 x 3. Faces of coarse cells that finer ones cover,
/// and these, are none of it. Faces between cells that are hidden and such that are not do not
/// become boundary.
SurfaceIntegrals integrateBoundary(const HexMesh& mesh, const FaceAdjacency& adjacency, int count,
  const Integrand& integrand, const HiddenCells* hidden = nullptr);

} // namespace mote
