#include "VolumeTracer.h"

#include "../core/Error.h"
#include "../hexahedra/CellIntegral.h"
#include "../hexahedra/EvenSamples.h"
#include "../hexahedra/HexBvhBundle.h"
#include "../shading/CloudLight.h"
#include "RayCaster.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace mote
{

namespace
{

/// Samples are at least so far apart, as a share of the mesh's size: 100,000 on a ray are more
/// than any picture can show.
constexpr double leastStep = 1e-5;

/// How much longer things are in the world.
double scaleOf(const VolumeObject& volume)
{
  return std::cbrt(std::abs(glm::determinant(Mat3d(volume.toWorld))));
}

const HexMesh& meshOf(const VolumeObject& volume)
{
  return withStructure(*volume.structure, [](const auto& s) -> const HexMesh& { return s.mesh(); });
}

} // namespace

double volumeStep(const VolumeObject& volume)
{
  const HexMesh& mesh = meshOf(volume);
  const HexMeshReport& report = mesh.report();
  const double cell =
    report.kept > 0 ? std::cbrt(std::abs(report.volume) / static_cast<double>(report.kept)) : 0.0;
  const double step =
    scaleOf(volume) * std::max(0.5 * cell, glm::length(mesh.bounds().size()) / 2000.0);
  return step > 0.0 && std::isfinite(step) ? step : 1.0;
}

VolumeTracer::VolumeTracer(const VolumeObject& volume, const std::vector<ShadedLight>& lights,
  const Vec3d& reference, int filmSample)
  : volume_(volume)
  , toLocal_(glm::inverse(volume.toWorld))
  , normalToWorld_(glm::transpose(Mat3d(toLocal_)))
{
  if (!volume.structure || !volume.field)
    throw Error("A volume needs a structure and a scalar.");
  const double offset = volume.field->offset();
  const VolumeSampling& sampling = volume.sampling;
  settings_.transfer = TransferTable(volume.transfer, offset);
  settings_.step = sampling.step > 0.0 ? sampling.step : volumeStep(volume);
  settings_.tolerance = sampling.tolerance > 0.0 ? sampling.tolerance : 1e-12;
  settings_.size = scaleOf(volume) * glm::length(meshOf(volume).bounds().size());
  settings_.step = std::max(settings_.step, leastStep * settings_.size);
  settings_.leastTransmittance = std::max(0.0, 1.0 - sampling.saturation);
  double y = 0.0;
  RayCaster::sampleOffset(filmSample, settings_.phase, y);
  settings_.phase -= std::floor(settings_.phase);
  for (const double value : volume.isoValues)
    if (std::isfinite(value))
    {
      values_.push_back(value - offset);
      const TransferTable::Sample sample = settings_.transfer(value - offset);
      colors_.emplace_back(Vec3f(sample.color), 1.0f);
    }
  if (!volume.shade)
    return;
  lighting_ = [light = CloudLight(lights, volume.material), reference, this](const Vec3d& color,
                const Vec3d& point, const Vec3d& gradient, const Vec3d& direction)
  {
    Vec3d normal = normalToWorld_ * gradient;
    const double length = glm::length(normal);
    normal = length > 0.0 ? normal / length : Vec3d(0.0);
    const Vec3d toEye = -glm::normalize(Mat3d(volume_.toWorld) * direction);
    return light(color, transformPoint(volume_.toWorld, point) - reference, normal, toEye);
  };
}

VolumeRay VolumeTracer::ray(
  const Vec3d& origin, const Vec3d& direction, double tMin, double tMax) const
{
  return {{transformPoint(toLocal_, origin), transformVector(toLocal_, direction), tMin, tMax},
    glm::length(direction)};
}

std::uint64_t VolumeTracer::inputCell(const IsoHit& hit) const
{
  return meshOf(volume_).inputCell(hit.cell);
}

Vec3d VolumeTracer::normalOf(const IsoHit& hit) const
{
  const Vec3d normal = normalToWorld_ * hit.gradient;
  const double length = glm::length(normal);
  return length > 0.0 ? normal / length : Vec3d(0.0);
}

template <typename Counts>
std::optional<IsoHit> VolumeTracer::surface(const VolumeRay& ray, Counts&& counts) const
{
  std::optional<IsoHit> hit;
  withStructure(*volume_.structure,
    [&](const auto& s)
    {
      IsoCrossing crossing(s.mesh(), *volume_.field, values_, ray.local);
      s.forCellsAlong(
        ray.local, [&](const CellSpan& span) { return crossing(span); },
        [&](const ScalarRange& range)
        {
          return std::any_of(values_.begin(), values_.end(),
            [&](double v) { return v >= range.lower && v <= range.upper; });
        },
        counts);
      if (crossing.found())
        hit = crossing.hit();
    });
  return hit;
}

/// Makes the integrator that the volume wants: calls with(type, make), where make(integrator, ray,
/// gatherer) puts one into an optional of that type.
template <typename With>
void VolumeTracer::withIntegrator(const HexMesh& mesh, const With& with) const
{
  if (volume_.sampling.integrator == VolumeIntegrator::CellByCell)
    return with(std::type_identity<CellIntegral>(),
      [&](auto& integrator, const VolumeRay& ray, RayGatherer& gatherer)
      {
        integrator.emplace(
          mesh, *volume_.field, settings_, lighting(), ray.local, ray.speed, gatherer);
      });
  const auto interpolation = volume_.sampling.integrator == VolumeIntegrator::Trilinear
                               ? EvenSamples::Interpolation::Trilinear
                               : EvenSamples::Interpolation::InverseDistance;
  with(std::type_identity<EvenSamples>(),
    [&](auto& integrator, const VolumeRay& ray, RayGatherer& gatherer)
    {
      integrator.emplace(
        mesh, *volume_.field, settings_, lighting(), interpolation, ray.local, ray.speed, gatherer);
    });
}

template <typename Counts>
void VolumeTracer::gather(const VolumeRay& ray, RayGatherer& gatherer, Counts&& counts) const
{
  withStructure(*volume_.structure,
    [&](const auto& s)
    {
      withIntegrator(s.mesh(),
        [&]<typename Integrator>(std::type_identity<Integrator>, const auto& make)
        {
          std::optional<Integrator> integrator;
          make(integrator, ray, gatherer);
          s.forCellsAlong(
            ray.local, [&](const CellSpan& span) { return (*integrator)(span); }, keep(), counts);
          integrator->finish();
        });
    });
}

BundleFrustum::Sides VolumeTracer::sidesOf(const CameraRays& rays) const
{
  const CameraRays local = rays.transformed(toLocal_);
  const bool isFan = rays.ox == Vec3d(0.0) && rays.oy == Vec3d(0.0);
  return isFan ? BundleFrustum::Sides{local.dx, local.dy}
               : BundleFrustum::Sides{local.ox, local.oy};
}

/// False where the rays must go one at a time.
template <typename Integrator, typename Make>
bool VolumeTracer::gatherTogether(const CartesianBvh& bvh, const VolumeRay* rays, int count,
  const BundleFrustum::Sides& sides, RayGatherer* const* gatherers, const Make& make) const
{
  std::array<HexRay, BundleSpans::rays> local;
  std::array<std::optional<Integrator>, BundleSpans::rays> integrators;
  for (int i = 0; i < count; ++i)
  {
    const auto k = static_cast<std::size_t>(i);
    local[k] = rays[i].local;
    make(integrators[k], rays[i], *gatherers[i]);
  }
  thread_local BundleSpans spans; // keeps its memory
  const HexField* values = std::is_same_v<Integrator, CellIntegral> && !volume_.field->isOfCells()
                             ? volume_.field.get()
                             : nullptr;
  const bool done = bvh.forCellsAlongBundle(
    local.data(), count, sides, values, spans,
    [&](std::size_t ray, const ValuedSpan& span) { return (*integrators[ray])(span); }, keep());
  for (int i = 0; done && i < count; ++i)
    integrators[static_cast<std::size_t>(i)]->finish();
  return done;
}

void VolumeTracer::gather(const VolumeRay* rays, int count, const BundleFrustum::Sides& sides,
  RayGatherer* const* gatherers) const
{
  bool done = false;
  if (const auto* bvh = std::get_if<CartesianBvh>(volume_.structure.get()); bvh && count > 1)
    withIntegrator(bvh->mesh(),
      [&]<typename Integrator>(std::type_identity<Integrator>, const auto& make)
      { done = gatherTogether<Integrator>(*bvh, rays, count, sides, gatherers, make); });
  for (int i = 0; !done && i < count; ++i)
    gather(rays[i], *gatherers[i]);
}

template std::optional<IsoHit> VolumeTracer::surface(const VolumeRay&, NoCounts&&) const;
template std::optional<IsoHit> VolumeTracer::surface(const VolumeRay&, WalkCounts&) const;
template void VolumeTracer::gather(const VolumeRay&, RayGatherer&, NoCounts&&) const;
template void VolumeTracer::gather(const VolumeRay&, RayGatherer&, WalkCounts&) const;

} // namespace mote
