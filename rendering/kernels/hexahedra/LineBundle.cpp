#include "LineBundle.h"

#include "detail/LineBundlePasses.h"

#include <algorithm>
#include <bit>
#include <cmath>

// This file must be compiled without contraction to fused multiply-adds, see CellFaces.cpp.

namespace mote
{

namespace
{

LineBundle::Lanes::Bounds boundsOf(const std::array<double, LineBundle::capacity>& of)
{
  constexpr std::size_t size = LineBundle::capacity / LineBundle::Lanes::groups;
  LineBundle::Lanes::Bounds bounds;
  for (std::size_t g = 0; g < LineBundle::Lanes::groups; ++g)
  {
    const auto [least, most] =
      std::minmax_element(of.data() + g * size, of.data() + (g + 1) * size);
    bounds.lower[g] = *least;
    bounds.upper[g] = *most;
  }
  return bounds;
}

} // namespace

LineBundle::LineBundle(const HexRay* rays, int count)
  : rays_(rays)
  , count_(count)
  , isCoherent_(hasBundlePasses())
{
  lines_.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    lines_.emplace_back(rays[i].origin, rays[i].direction);
  const LineFrame& first = lines_.front().frame();
  lanes_.axes = {first.kx, first.ky, first.kz};
  lanes_.isFan = true;
  for (std::size_t i = 0; i < capacity; ++i)
  {
    const LineFrame& f = lines_[i < lines_.size() ? i : 0].frame();
    isCoherent_ = isCoherent_ && f.kz == first.kz && f.kx == first.kx;
    lanes_.isFan = lanes_.isFan && f.origin == first.origin;
    lanes_.originX[i] = f.origin.x;
    lanes_.originY[i] = f.origin.y;
    lanes_.originZ[i] = f.origin.z;
    lanes_.shearX[i] = f.shearX;
    lanes_.shearY[i] = f.shearY;
    lanes_.inverse[i] = f.inverse;
  }
  lanes_.groupX = boundsOf(lanes_.originX);
  lanes_.groupY = boundsOf(lanes_.originY);
  lanes_.groupZ = boundsOf(lanes_.originZ);
  lanes_.groupShearX = boundsOf(lanes_.shearX);
  lanes_.groupShearY = boundsOf(lanes_.shearY);
  const auto [x0, x1] = std::minmax_element(lanes_.shearX.begin(), lanes_.shearX.end());
  const auto [y0, y1] = std::minmax_element(lanes_.shearY.begin(), lanes_.shearY.end());
  lanes_.middle = {0.5 * (*x0 + *x1), 0.5 * (*y0 + *y1), 1.0};
  lanes_.reachX = 0.5 * (*x1 - *x0);
  lanes_.reachY = 0.5 * (*y1 - *y0);
  lanes_.farthest = 0.0;
  for (std::size_t i = 0; i < capacity && !lanes_.isFan; ++i)
    lanes_.farthest = std::max({lanes_.farthest, std::abs(lanes_.originX[i]),
      std::abs(lanes_.originY[i]), std::abs(lanes_.originZ[i])});
}

void LineBundle::addSpans(const HexMesh& mesh, std::uint32_t cell, const HexField* field,
  std::uint64_t wanted, BundleSpans& spans) const
{
  CornerValues of;
  if (field != nullptr)
    of = field->corners(mesh.cell(cell));
  const CornerValues* const values = field != nullptr ? &of : nullptr;
  const HexCorners corners = mesh.corners(cell);
  BundlePasses passes;
  passesOf(lanes_, corners, values, wanted, passes);
  if ((passes.passed | passes.seldom) == 0)
    return;
  const double bend = values != nullptr ? bendOf(corners, *values) : 0.0;
  for (std::uint64_t rays = passes.passed; rays != 0; rays &= rays - 1)
  {
    const auto i = static_cast<std::size_t>(std::countr_zero(rays));
    const CellInterval part{passes.in[i], passes.out[i], passes.inFace[i], passes.outFace[i]};
    spans.add(i, {part.within(cell, rays_[i].tMin, rays_[i].tMax), passes.valueIn[i],
                   passes.valueOut[i], bend});
  }
  for (std::uint64_t rays = passes.seldom; rays != 0; rays &= rays - 1)
    addSeldom(mesh, cell, values, bend, static_cast<std::size_t>(std::countr_zero(rays)), spans);
}

void LineBundle::addSeldom(const HexMesh& mesh, std::uint32_t cell, const CornerValues* values,
  double bend, std::size_t ray, BundleSpans& spans) const
{
  const CrossingLine& line = lines_[ray];
  CellIntervals intervals;
  if (!line.intersect(mesh, cell, intervals))
    return;
  const auto value = [&](const FacePoint& point)
  { return point.value([&](std::size_t corner) { return (*values)[corner]; }); };
  for (const CellInterval& part : intervals)
  {
    ValuedSpan span{part.within(cell, rays_[ray].tMin, rays_[ray].tMax), 0.0, 0.0, bend};
    if (values != nullptr && span.span.inFace != noFace)
      span.valueIn = value(line.entry(mesh, cell, span.span.inFace));
    if (values != nullptr && span.span.outFace != noFace)
      span.valueOut = value(line.exit(mesh, cell, span.span.outFace));
    spans.add(ray, span);
  }
}

} // namespace mote
