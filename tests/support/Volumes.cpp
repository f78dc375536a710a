#include "Volumes.h"

#include <kernels/hexahedra/CellCrossings.h>
#include <kernels/hexahedra/TrilinearCell.h>
#include <kernels/tracing/detail/CloudTracer.h>

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace mote::testing
{

std::vector<CellSpan> allSpans(const HexMesh& mesh, const HexRay& ray)
{
  std::vector<CellSpan> all;
  const CrossingLine line(ray.origin, ray.direction);
  CellIntervals intervals;
  for (std::uint32_t c = 0; c < mesh.cellCount(); ++c)
    if (line.intersect(mesh, c, intervals))
      for (const CellInterval& i : intervals)
        if (const CellSpan s = i.within(c, ray.tMin, ray.tMax); s.tIn < s.tOut)
          all.push_back(s);
  std::sort(all.begin(), all.end(),
    [](const CellSpan& a, const CellSpan& b)
    { return a.tIn != b.tIn ? a.tIn < b.tIn : a.cell < b.cell; });
  return all;
}

std::vector<double> pointValues(
  const HexMesh& mesh, const std::function<double(const Vec3d&)>& function)
{
  std::vector<double> values;
  for (std::size_t p = 0; p < mesh.pointCount(); ++p)
    values.push_back(function(mesh.point(p)));
  return values;
}

CloudObject volumeOf(std::shared_ptr<const HexMesh> mesh, const std::vector<double>& values,
  const TransferFunction& transfer, HexStructureKind kind, bool ofCells)
{
  HexStructureOptions options;
  options.kind = kind;
  options.axis = CylinderAxis{};
  CloudObject volume;
  volume.field =
    std::make_shared<HexField>(*mesh, HexScalar{{values.data(), values.size(), 1}, 0, ofCells});
  const auto structure = makeHexStructure(mesh, options);
  setRanges(*structure, *volume.field);
  volume.structure = structure;
  volume.transfer = transfer;
  volume.sampling.saturation = 1.0;
  return volume;
}

void addWalk(CloudObject& volume)
{
  const std::shared_ptr<const HexMesh> mesh(volume.structure, &meshOf(*volume.structure));
  volume.walk =
    std::make_shared<WalkCells>(mesh, std::make_shared<FaceAdjacency>(*mesh), *volume.field);
  volume.sampling.integrator = VolumeIntegrator::CellByCell;
}

TransferFunction evenTransfer(float opacity, float grey)
{
  TransferFunction transfer;
  transfer.knots = {{0.0, Vec4f(grey, grey, grey, opacity)}};
  return transfer;
}

double wave(const Vec3d& p)
{
  return std::sin(2.0 * p.x) * std::cos(1.5 * p.y) + 0.5 * p.z;
}

TransferFunction colorful()
{
  TransferFunction f;
  f.knots = {{-1.0, Vec4f(0, 0, 1, 0)}, {-0.2, Vec4f(0, 1, 1, 0.2F)}, {0.1, Vec4f(1, 1, 0, 0)},
    {0.3, Vec4f(1, 0, 0, 0.7F)}, {0.5, Vec4f(1, 0, 0, 0.1F)}, {0.5, Vec4f(1, 1, 1, 0.4F)},
    {1.2, Vec4f(0.2F, 0, 0.4F, 0.05F)}};
  f.unitDistance = 0.6;
  return f;
}

RayColor gatheredByDefinition(const CloudObject& volume, const Vec3d& origin,
  const Vec3d& direction, double tMin, double tMax, int parts)
{
  const Mat4d toLocal = glm::inverse(volume.toWorld);
  const HexRay ray{
    transformPoint(toLocal, origin), transformVector(toLocal, direction), tMin, tMax};
  const TransferTable table(volume.transfer, volume.field->offset());
  const HexField& field = *volume.field;
  const HexMesh& mesh =
    withStructure(*volume.structure, [](const auto& s) -> const HexMesh& { return s.mesh(); });
  RayColor out;
  for (const CellSpan& span : allSpans(mesh, ray))
  {
    const TrilinearCell cell(mesh, span.cell);
    const double width = (span.tOut - span.tIn) / parts;
    Vec3d rst(0.5);
    for (int i = 0; i < parts; ++i)
    {
      const Vec3d p = ray.origin + (span.tIn + (i + 0.5) * width) * ray.direction;
      double value = 0.0;
      if (field.isOfCells())
        value = field.ofCell(span.cell);
      else
      {
        cell.coordinates(p, rst, rst);
        value = weighted(field.corners(mesh.cell(span.cell)), TrilinearCell::weights(rst));
      }
      out.add(std::isnan(value) ? table.ofNaN() : table(value), width * glm::length(direction));
    }
  }
  return out;
}

RayColor gathered(
  const CloudObject& volume, const Vec3d& origin, const Vec3d& direction, double tMin, double tMax)
{
  const std::vector<ShadedLight> lights;
  const CloudTracer tracer(volume, lights, Vec3d(0.0), 0);
  RayGatherer gatherer(nullptr);
  tracer.gather(tracer.ray(origin, direction, tMin, tMax), gatherer);
  return gatherer.total();
}

double opticalDepth(const RayColor& color)
{
  return -std::log(color.transmittance);
}

} // namespace mote::testing
