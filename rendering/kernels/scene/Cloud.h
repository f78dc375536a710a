#pragma once

#include "../hexahedra/HexField.h"
#include "../hexahedra/HexStructure.h"
#include "../hexahedra/HiddenCells.h"
#include "../hexahedra/WalkCells.h"
#include "../shading/TransferFunction.h"
#include "Surface.h"

#include <array>
#include <memory>
#include <vector>

namespace mote
{

/// How a volume's colour is integrated along rays.
enum class VolumeIntegrator
{
  /// Even samples, each the mean of the cell's eight corners by inverse distance, after Wang,
  /// Elshehaly and Cao. Not continuous between cells.
  InverseDistance,
  /// Even samples of the trilinear cell.
  Trilinear,
  /// Cell by cell between the exact places of entry and exit, split at the transfer function's
  /// knots, to a tolerance.
  CellByCell
};

struct VolumeSampling
{
  VolumeIntegrator integrator = VolumeIntegrator::Trilinear;
  /// World units between samples; 0 or less: volumeStep(). At least 1e-5 of the mesh's size.
  double step = 0.0;
  double tolerance = 1e-3;   ///< of CellByCell: error of a pixel's colour, of about 1, at most
  double saturation = 0.999; ///< rays end at this opacity; 1 or more: never

  bool operator==(const VolumeSampling&) const = default;
};

/// A scalar on hexahedra placed in a scene, as a cloud by its transfer function. Where several
/// clouds lie along a ray, their parts without gaps are put one behind another by where they begin.
struct CloudObject
{
  std::int32_t id = 0;        ///< as SurfaceObject::id
  std::uint64_t revision = 0; ///< as SurfaceObject::revision
  /// May be null where the walk serves, see walkServes().
  std::shared_ptr<const HexStructure> structure;
  std::shared_ptr<const HexField> field; ///< on the structure's mesh
  /// Of the structure's mesh and the field: the camera's rays then go from cell to cell where that
  /// serves. Null: all rays go through the structure.
  std::shared_ptr<const WalkCells> walk;
  std::shared_ptr<const HiddenCells> hidden; ///< of the structure's mesh; null: none
  Mat4d toWorld{1.0};                        ///< affine
  ClipRegion clip;                           ///< where in the world it is shown
  TransferFunction transfer;
  VolumeSampling sampling;
  bool shade = false; ///< light it by its gradient and the material
  Material material;

  bool operator==(const CloudObject&) const = default;
};

/// Whether the camera's rays can go from cell to cell, and need no structure.
bool walkServes(const VolumeSampling& sampling);

/// The mesh of its structure or its walk, of which it has one at least.
const HexMesh& meshOf(const CloudObject& cloud);

/// The step of a cloud that names none, in world units: half the edge of a cube as large as the
/// mean cell, or 1/2000 of the mesh's size where that is more.
double volumeStep(const CloudObject& cloud);

/// A scalar on a cloud's mesh beside its own, and a structure that knows the ranges of that.
struct OtherField
{
  std::shared_ptr<const HexStructure> structure;
  std::shared_ptr<const HexField> field;
  bool isOwn = false; ///< the cloud's own one, of cells, as one of points
};

/// The opaque surfaces, for which it must have a structure, where the cloud's scalar has these
/// values, in the colours that its transfer function gives them, with its placement, material, id,
/// revision and hidden cells. Where there is another field the values are of that, and the colours
/// those of the cloud's scalar at the same place, unless that is its own.
SurfaceObject isoSurfacesOf(
  const CloudObject& cloud, const std::vector<double>& values, const OtherField& followed = {});

/// The slices of the cloud's cells, for which it must have a structure, opaque, unlit and in the
/// colours that its transfer function gives to their values, with its placement, id, revision and
/// hidden cells. Cells with a NaN are there where their opacity is not 0. Of values there are those
/// in any of the ranges, ends included; all without any.
SurfaceObject slicesOf(const CloudObject& cloud, const std::vector<SliceShape>& shapes,
  const EdgeLook& edges = {}, const std::vector<std::array<double, 2>>& ranges = {});

} // namespace mote
