#include "Cloud.h"

#include "../hexahedra/CellWalk.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

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

namespace
{

/// What a surface in a cloud has of it.
SurfaceObject surfaceIn(const CloudObject& cloud)
{
  SurfaceObject object;
  object.id = cloud.id;
  object.revision = cloud.revision;
  object.toWorld = cloud.toWorld;
  object.clip = cloud.clip;
  object.material = cloud.material;
  return object;
}

/// The colours of a function, whatever its opacities.
ColorMap colorsOf(const TransferFunction& function)
{
  ColorMap map;
  map.table.clear();
  for (const TransferFunction::Knot& knot : function.knots)
  {
    map.knots.push_back(knot.value);
    map.table.emplace_back(Vec3f(knot.color), 1.0f);
  }
  map.nan = {Vec3f(function.nan), 1.0f};
  return map;
}

/// The same map, clear outside of the ranges.
ColorMap within(const ColorMap& whole, const std::vector<std::array<double, 2>>& ranges)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  ColorMap map;
  map.nan = whole.nan;
  map.knots = whole.knots;
  for (const auto& [low, high] : ranges)
    for (const double end :
      {std::nextafter(low, -infinity), low, high, std::nextafter(high, infinity)})
      if (std::isfinite(end))
        map.knots.push_back(end);
  std::sort(map.knots.begin(), map.knots.end());
  map.table.clear();
  for (const double value : map.knots)
  {
    const bool isShown = std::any_of(ranges.begin(), ranges.end(),
      [&](const auto& range) { return range[0] <= value && value <= range[1]; });
    map.table.emplace_back(Vec3f(whole(value)), isShown ? 1.0f : 0.0f);
  }
  return map;
}

} // namespace

SurfaceObject isoSurfacesOf(
  const CloudObject& cloud, const std::vector<double>& values, const OtherField& followed)
{
  SurfaceObject object = surfaceIn(cloud);
  object.surface = followed.field ? IsoSurface(followed.structure, followed.field, values,
                                      cloud.hidden, followed.isOwn ? nullptr : cloud.field)
                                  : IsoSurface(cloud.structure, cloud.field, values, cloud.hidden);
  object.coloring.map = colorsOf(cloud.transfer);
  return object;
}

SurfaceObject slicesOf(const CloudObject& cloud, const std::vector<SliceShape>& shapes,
  const EdgeLook& edges, const std::vector<std::array<double, 2>>& ranges)
{
  SurfaceObject object = surfaceIn(cloud);
  object.edges = edges;
  object.material = {};
  object.material.isUnlit = true; // colours are to be read
  object.material.ambient = 1.0f;
  object.material.diffuse = object.material.specular = 0.0f;
  object.surface =
    SliceSurface(cloud.structure, cloud.field, shapes, cloud.hidden, cloud.transfer.nan.a > 0.0f);
  object.coloring.map = colorsOf(cloud.transfer);
  if (!ranges.empty())
    object.coloring.map = within(object.coloring.map, ranges);
  return object;
}

} // namespace mote
