#pragma once

#include "../hexahedra/HexField.h"
#include "../hexahedra/HexStructure.h"
#include "../shading/Light.h"
#include "../shading/TransferFunction.h"

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
};

/// A scalar on hexahedra placed in a scene: a cloud by its transfer function, opaque iso-surfaces,
/// or both. Where several volumes lie along a ray, their parts without gaps are put one behind
/// another by where they begin.
struct VolumeObject
{
  std::shared_ptr<const HexStructure> structure;
  std::shared_ptr<const HexField> field; ///< on the structure's mesh
  Mat4d toWorld{1.0};                    ///< affine
  bool isCloud = true;                   ///< whether the volume itself is seen
  TransferFunction transfer;             ///< also colours iso-surfaces
  VolumeSampling sampling;
  bool shade = false;            ///< light the cloud by its gradient and the material
  std::vector<double> isoValues; ///< where there is an opaque surface, as the user's scalar has it
  Material material;             ///< of iso-surfaces, and of the cloud where it is lit
};

/// The step of a volume that names none, in world units: half the edge of a cube as large as the
/// mean cell, or 1/2000 of the mesh's size where that is more.
double volumeStep(const VolumeObject& volume);

} // namespace mote
