#pragma once

#include "HexMeshes.h"

#include <kernels/hexahedra/RayColor.h>
#include <kernels/scene/Scene.h>

#include <cmath>
#include <functional>
#include <optional>

namespace mote::testing
{

/// All parts of a ray in the cells of a mesh, by asking every cell; in order.
std::vector<CellSpan> allSpans(const HexMesh& mesh, const HexRay& ray);

/// A function of the place as values at the points of a mesh.
std::vector<double> pointValues(
  const HexMesh& mesh, const std::function<double(const Vec3d&)>& function);

/// A volume over cells, with ranges set. The axis is z through the origin unless told.
CloudObject volumeOf(std::shared_ptr<const HexMesh> mesh, const std::vector<double>& values,
  const TransferFunction& transfer, HexStructureKind kind = HexStructureKind::CylindricalBvh,
  bool ofCells = false);

/// Lets the camera's rays go from cell to cell: adds what that takes, and integrates cell by cell.
void addWalk(CloudObject& volume);

/// A transfer function of even opacity per unit, grey.
TransferFunction evenTransfer(float opacity, float grey = 1.0f);

/// A smooth field, and a transfer function for it with a ramp, a peak and steps.
double wave(const Vec3d& p);
TransferFunction colorful();

/// What a ray in the world gathers of a volume, by the definition: every cell's span cut into
/// `parts` steps, each taken as its middle. Slow.
RayColor gatheredByDefinition(const CloudObject& volume, const Vec3d& origin,
  const Vec3d& direction, double tMin, double tMax, int parts = 500);

/// What a ray in the world gathers of a volume, ray by ray.
RayColor gathered(const CloudObject& volume, const Vec3d& origin, const Vec3d& direction,
  double tMin = 0.0, double tMax = INFINITY);
double opticalDepth(const RayColor& color);

} // namespace mote::testing
