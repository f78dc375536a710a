#include "detail/CloudTracer.h"

#include "../core/Error.h"
#include "../hexahedra/CellIntegral.h"
#include "../hexahedra/EvenSamples.h"
#include "../hexahedra/HexBvhBundle.h"
#include "RayCaster.h"
#include "detail/CloudLight.h"

#include <algorithm>
#include <cmath>

namespace mote
{

namespace
{

/// Samples are at least so far apart, as a share of the mesh's size: 100,000 on a ray are more
/// than any picture can show.
constexpr double leastStep = 1e-5;

} // namespace

CloudTracer::CloudTracer(const CloudObject& cloud, const std::vector<ShadedLight>& lights,
  const Vec3d& reference, int filmSample)
  : cloud_(cloud)
  , toLocal_(glm::inverse(cloud.toWorld))
  , normalToWorld_(glm::transpose(Mat3d(toLocal_)))
{
  const bool hasRays = cloud.structure || (cloud.walk && walkServes(cloud.sampling));
  if (!hasRays || !cloud.field)
    throw Error("A volume needs a structure, or a walk that serves, and a scalar.");
  const double offset = cloud.field->offset();
  const VolumeSampling& sampling = cloud.sampling;
  settings_.transfer = TransferTable(cloud.transfer, offset);
  settings_.step = sampling.step > 0.0 ? sampling.step : volumeStep(cloud);
  settings_.tolerance = sampling.tolerance > 0.0 ? sampling.tolerance : 1e-12;
  settings_.size = scaleOf(cloud.toWorld) * glm::length(meshOf(cloud).bounds().size());
  settings_.step = std::max(settings_.step, leastStep * settings_.size);
  settings_.leastTransmittance = std::max(0.0, 1.0 - sampling.saturation);
  double y = 0.0;
  RayCaster::sampleOffset(filmSample, settings_.phase, y);
  settings_.phase -= std::floor(settings_.phase);
  if (!cloud.shade)
    return;
  lighting_ = [light = CloudLight(lights, cloud.material), reference, this](const Vec3d& color,
                const Vec3d& point, const Vec3d& gradient, const Vec3d& direction)
  {
    Vec3d normal = normalToWorld_ * gradient;
    const double length = glm::length(normal);
    normal = length > 0.0 ? normal / length : Vec3d(0.0);
    const Vec3d toEye = -glm::normalize(Mat3d(cloud_.toWorld) * direction);
    return light(color, transformPoint(cloud_.toWorld, point) - reference, normal, toEye);
  };
}

CloudRay CloudTracer::ray(
  const Vec3d& origin, const Vec3d& direction, double tMin, double tMax) const
{
  return {{transformPoint(toLocal_, origin), transformVector(toLocal_, direction), tMin, tMax},
    glm::length(direction)};
}

/// Makes the integrator that the cloud wants: calls with(type, make), where make(integrator, ray,
/// gatherer) puts one into an optional of that type.
template <typename With>
void CloudTracer::withIntegrator(const HexMesh& mesh, const With& with) const
{
  if (cloud_.sampling.integrator == VolumeIntegrator::CellByCell)
    return with(std::type_identity<CellIntegral>(),
      [&](auto& integrator, const CloudRay& ray, RayGatherer& gatherer)
      {
        integrator.emplace(
          mesh, *cloud_.field, settings_, lighting(), ray.local, ray.speed, gatherer);
      });
  const auto interpolation = cloud_.sampling.integrator == VolumeIntegrator::Trilinear
                               ? EvenSamples::Interpolation::Trilinear
                               : EvenSamples::Interpolation::InverseDistance;
  with(std::type_identity<EvenSamples>(),
    [&](auto& integrator, const CloudRay& ray, RayGatherer& gatherer)
    {
      integrator.emplace(
        mesh, *cloud_.field, settings_, lighting(), interpolation, ray.local, ray.speed, gatherer);
    });
}

template <typename Counts>
void CloudTracer::gather(const CloudRay& ray, RayGatherer& gatherer, Counts&& counts) const
{
  withStructure(*cloud_.structure,
    [&](const auto& s)
    {
      withIntegrator(s.mesh(),
        [&]<typename Integrator>(std::type_identity<Integrator>, const auto& make)
        {
          std::optional<Integrator> integrator;
          make(integrator, ray, gatherer);
          s.forCellsAlong(
            ray.local,
            [&](const CellSpan& span) { return isHidden(span.cell) || (*integrator)(span); },
            keep(), counts);
          integrator->finish();
        });
    });
}

BundleFrustum::Sides CloudTracer::sidesOf(const CameraRays& rays) const
{
  const CameraRays local = rays.transformed(toLocal_);
  const bool isFan = rays.ox == Vec3d(0.0) && rays.oy == Vec3d(0.0);
  return isFan ? BundleFrustum::Sides{local.dx, local.dy}
               : BundleFrustum::Sides{local.ox, local.oy};
}

/// False where the rays must go one at a time.
template <typename Integrator, typename Make>
bool CloudTracer::gatherTogether(const CartesianBvh& bvh, const CloudRay* rays, int count,
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
  const HexField* values = std::is_same_v<Integrator, CellIntegral> && !cloud_.field->isOfCells()
                             ? cloud_.field.get()
                             : nullptr;
  const bool done = bvh.forCellsAlongBundle(
    local.data(), count, sides, values, spans,
    [&](std::size_t ray, const ValuedSpan& span)
    { return isHidden(span.span.cell) || (*integrators[ray])(span); },
    keep());
  for (int i = 0; done && i < count; ++i)
    integrators[static_cast<std::size_t>(i)]->finish();
  return done;
}

void CloudTracer::gather(const CloudRay* rays, int count, const BundleFrustum::Sides& sides,
  RayGatherer* const* gatherers) const
{
  bool done = false;
  if (const auto* bvh = std::get_if<CartesianBvh>(cloud_.structure.get()); bvh && count > 1)
    withIntegrator(bvh->mesh(),
      [&]<typename Integrator>(std::type_identity<Integrator>, const auto& make)
      { done = gatherTogether<Integrator>(*bvh, rays, count, sides, gatherers, make); });
  for (int i = 0; !done && i < count; ++i)
    gather(rays[i], *gatherers[i]);
}

bool CloudTracer::lookFrom(const CameraRays& rays, int width, int height)
{
  const bool isWanted = cloud_.walk && walkServes(cloud_.sampling);
  if (isWanted)
    walk_.emplace(*cloud_.walk, *cloud_.field, settings_, lighting(), rays, toLocal_, width, height,
      cloud_.hidden.get());
  return isWanted;
}

template void CloudTracer::gather(const CloudRay&, RayGatherer&, NoCounts&&) const;
template void CloudTracer::gather(const CloudRay&, RayGatherer&, WalkCounts&) const;

} // namespace mote
