#include "Cloud.h"

#include "../hexahedra/CellWalk.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace mote
{

bool walkServes(const VolumeSampling& sampling)
{
  return sampling.integrator == VolumeIntegrator::CellByCell &&
         sampling.tolerance >= CellWalk::leastTolerance && CellWalk::isSupported();
}

const HexMesh& meshOf(const CloudObject& cloud)
{
  return cloud.structure ? meshOf(*cloud.structure) : cloud.walk->mesh();
}

double volumeStep(const CloudObject& cloud)
{
  const HexMesh& mesh = meshOf(cloud);
  const HexMeshReport& report = mesh.report();
  const double cell =
    report.kept > 0 ? std::cbrt(std::abs(report.volume) / static_cast<double>(report.kept)) : 0.0;
  const double step =
    scaleOf(cloud.toWorld) * std::max(0.5 * cell, glm::length(mesh.bounds().size()) / 2000.0);
  return step > 0.0 && std::isfinite(step) ? step : 1.0;
}

SurfaceObject isoSurfacesOf(const CloudObject& cloud, const std::vector<double>& values)
{
  SurfaceObject object;
  object.id = cloud.id;
  object.revision = cloud.revision;
  object.surface = IsoSurface(cloud.structure, cloud.field, values, cloud.hidden);
  object.toWorld = cloud.toWorld;
  object.clip = cloud.clip;
  object.material = cloud.material;
  const double offset = cloud.field->offset();
  const TransferTable table(cloud.transfer, offset);
  for (const double value : values)
  {
    const auto sample = std::isfinite(value) ? table(value - offset) : table.ofNaN();
    object.coloring.palette.emplace_back(Vec3f(sample.color), 1.0f);
  }
  return object;
}

} // namespace mote
