#include "CutHandles.h"

#include "PlaceMath.h"
#include "Slices.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

/// A slice by where it stands and how it lies.
struct SliceFrame
{
  explicit SliceFrame(vtkMoteSlice* slice)
    : radius(slice->GetRadius())
  {
    slice->GetCenter(center.data());
    slice->GetAxis(axis.data());
    slice->GetOutwards(out.data());
    vtkMath::Normalize(axis.data());
    out = sum(out, -dot(out, axis), axis);
    vtkMath::Normalize(out.data());
    vtkMath::Cross(axis.data(), out.data(), side.data());
  }
  double height(const Vec& place) const { return dot(sum(place, -1.0, center), axis); }
  Vec at(double outwards, double sideways, double height) const
  {
    return sum(sum(sum(center, outwards, out), sideways, side), height, axis);
  }
  Vec center{}, axis{}, out{}, side{};
  double radius;
};

Vec cornerOf(const double bounds[6], int corner)
{
  return {bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2 & 1)]};
}

/// Where a plane meets the edges of a box, around its middle.
std::vector<Vec> inBox(const SliceFrame& plane, const double bounds[6])
{
  std::vector<Vec> met;
  for (int corner = 0; corner < 8; ++corner)
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vec a = cornerOf(bounds, corner), b = cornerOf(bounds, corner | 1 << axis);
      const double from = plane.height(a), to = plane.height(b);
      if ((corner >> axis & 1) == 0 && (from < 0.0) != (to < 0.0))
        met.push_back(sum(a, from / (from - to), sum(b, -1.0, a)));
    }
  Vec middle{};
  for (const Vec& place : met)
    middle = sum(middle, 1.0 / static_cast<double>(met.size()), place);
  const auto angle = [&](const Vec& place)
  {
    const Vec from = sum(place, -1.0, middle);
    return std::atan2(dot(from, plane.side), dot(from, plane.out));
  };
  std::sort(
    met.begin(), met.end(), [&](const Vec& a, const Vec& b) { return angle(a) < angle(b); });
  return met;
}

/// What a box takes of an axis: from and to along it, and how far away from it.
struct AboutAxis
{
  double low = HUGE_VAL, high = -HUGE_VAL, radius = 0.0;
  AboutAxis(const SliceFrame& frame, const double bounds[6])
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      const Vec place = cornerOf(bounds, corner);
      const double height = frame.height(place);
      low = std::min(low, height);
      high = std::max(high, height);
      const Vec from = sum(sum(place, -1.0, frame.center), -height, frame.axis);
      radius = std::max(radius, vtkMath::Norm(from.data()));
    }
  }
};

void shape(CutHandle& handle, vtkMoteSlice* slice, const double bounds[6])
{
  const SliceFrame frame(slice);
  if (slice->GetShape() == vtkMoteSlice::PLANE)
  {
    std::vector<Vec> around = inBox(frame, bounds);
    if (around.size() < 3)
      return;
    for (const Vec& place : around)
      handle.middle = sum(handle.middle, 1.0 / static_cast<double>(around.size()), place);
    around.push_back(around.front());
    handle.outlines = {around};
    return;
  }
  const AboutAxis box(frame, bounds);
  const double half = 0.5 * (box.low + box.high);
  if (slice->GetShape() == vtkMoteSlice::HALF_PLANE)
  {
    handle.middle = frame.at(0.5 * box.radius, 0.0, half);
    handle.outlines = {{frame.at(0.0, 0.0, box.low), frame.at(box.radius, 0.0, box.low),
      frame.at(box.radius, 0.0, box.high), frame.at(0.0, 0.0, box.high),
      frame.at(0.0, 0.0, box.low)}};
    return;
  }
  handle.middle = frame.at(frame.radius, 0.0, half);
  constexpr int parts = 96;
  for (const double height : {box.low, box.high})
  {
    std::vector<Vec>& circle = handle.outlines.emplace_back();
    for (int i = 0; i <= parts; ++i)
    {
      const double angle = 2.0 * vtkMath::Pi() * i / parts;
      circle.push_back(
        frame.at(frame.radius * std::cos(angle), frame.radius * std::sin(angle), height));
    }
  }
  for (const double angle : {0.0, 0.5 * vtkMath::Pi(), vtkMath::Pi(), 1.5 * vtkMath::Pi()})
  {
    const double x = frame.radius * std::cos(angle), y = frame.radius * std::sin(angle);
    handle.outlines.push_back({frame.at(x, y, box.low), frame.at(x, y, box.high)});
  }
}

} // namespace

std::vector<CutHandle> cutHandles(const Settings& shown, const double bounds[6])
{
  std::vector<CutHandle> handles;
  const auto add = [&](const std::string& name, double value)
  {
    const std::optional<CutKind> kind = cutNamed(name);
    if (!kind || !std::isfinite(value) || (kind->of == CutKind::Radius && !(value > 0.0)))
      return;
    Settings one;
    one.cuts.axis = shown.cuts.axis;
    one.volume.slices = std::vector<ShowRange>{{name, {{value, value}}}};
    CutHandle handle{name, value, {}, {}};
    shape(handle, slicesOf(one, 1.0).front(), bounds);
    if (!handle.outlines.empty())
      handles.push_back(std::move(handle));
  };
  for (const ShowRange& cut : shown.cuts.ranges)
    for (const double end : {cut.intervals.front().low, cut.intervals.front().high})
      add(cut.name, end);
  for (const ShowRange& slice : shown.volume.slices.value_or(std::vector<ShowRange>()))
    for (const Interval& place : slice.intervals)
      if (!(shown.volume.unroll && slice.name == "r"))
        add(slice.name, place.low);
  return handles;
}

std::optional<CutGrip> CutHandle::heldAt(const Settings& shown, const Vec& place) const
{
  return CutGrip::of(shown, name, value, place);
}

} // namespace mote::app
