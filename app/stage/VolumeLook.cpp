#include "VolumeLook.h"

#include "Cuts.h"
#include "Turning.h"

#include <vtkBoundingBox.h>
#include <vtkCellArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace mote::app
{

namespace
{

/// How much of some volumes lies in each of a few layers across an axis, about: cells count as
/// their boxes.
struct Layers
{
  static constexpr int count = 63; ///< odd: one lies in the middle
  double low = 0.0, thickness = 0.0;
  std::array<double, count> volume = {};

  void add(double from, double to, double cell)
  {
    const auto at = [&](double place)
    { return std::clamp(static_cast<int>((place - low) / thickness), 0, count - 1); };
    const int first = at(from), last = at(to);
    for (int k = first; k <= last; ++k)
    {
      const double begin = low + k * thickness;
      const double within = std::min(to, begin + thickness) - std::max(from, begin);
      volume[static_cast<std::size_t>(k)] += to > from ? cell * within / (to - from) : 0.0;
    }
  }
  double fullest() const
  {
    return thickness > 0.0 ? *std::max_element(volume.begin(), volume.end()) / thickness : 0.0;
  }
  /// The layer nearest to the middle that has at least this share of the fullest.
  int best(double share) const
  {
    const double least = share * *std::max_element(volume.begin(), volume.end());
    for (int away = 0; away <= count / 2; ++away)
      for (const int k : {count / 2 - away, count / 2 + away})
        if (volume[static_cast<std::size_t>(k)] >= least)
          return k;
    return count / 2;
  }
};

/// Adds a share of the cells: enough to see where there is much.
void addCells(vtkUnstructuredGrid* volume, std::array<Layers, 3>& layers)
{
  constexpr vtkIdType enough = 200'000;
  const vtkIdType step = std::max<vtkIdType>(1, volume->GetNumberOfCells() / enough);
  for (vtkIdType cell = 0; cell < volume->GetNumberOfCells(); cell += step)
  {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    volume->GetCells()->GetCellAtId(cell, count, points);
    vtkBoundingBox box;
    for (vtkIdType k = 0; k < count; ++k)
    {
      double point[3];
      volume->GetPoint(points[k], point);
      box.AddPoint(point);
    }
    double length[3];
    box.GetLengths(length);
    const double size = static_cast<double>(step) * length[0] * length[1] * length[2];
    for (int axis = 0; axis < 3 && size > 0.0 && std::isfinite(size); ++axis)
      layers[static_cast<std::size_t>(axis)].add(
        box.GetMinPoint()[axis], box.GetMaxPoint()[axis], size);
  }
}

/// Where cuts go through cells.
std::vector<ShowRange> facesOf(const CutSettings& cuts)
{
  std::vector<ShowRange> faces;
  for (const ShowRange& cut : cuts.ranges)
  {
    const std::optional<CutKind> kind = cutNamed(cut.name);
    if (!kind)
      continue;
    const Interval shown = cut.intervals.front();
    std::vector<Interval> ends;
    for (const double end : {shown.low, shown.high})
      if (std::isfinite(end) && (kind->of != CutKind::Radius || end > 0.0))
        ends.push_back({end, end});
    if (!ends.empty())
      faces.push_back({cut.name, ends});
  }
  return faces;
}

} // namespace

std::optional<ShowRange> fullestSlice(
  const std::vector<vtkUnstructuredGrid*>& volumes, const std::vector<double>& cutAxis)
{
  vtkBoundingBox all;
  for (vtkUnstructuredGrid* volume : volumes)
    if (volume->GetNumberOfCells() > 0)
      all.AddBounds(volume->GetBounds());
  if (!all.IsValid())
    return {};
  std::array<Layers, 3> layers;
  for (int axis = 0; axis < 3; ++axis)
  {
    Layers& own = layers[static_cast<std::size_t>(axis)];
    own.low = all.GetMinPoint()[axis];
    own.thickness = all.GetLength(axis) / Layers::count;
  }
  if (std::any_of(layers.begin(), layers.end(), [](const Layers& l) { return l.thickness <= 0.0; }))
    return {};
  for (vtkUnstructuredGrid* volume : volumes)
    addCells(volume, layers);
  // Across y, or else z, where others show little more.
  constexpr double more = 1.1;
  std::size_t axis = 1;
  for (const std::size_t other : {2, 0})
    if (layers[other].fullest() > more * layers[axis].fullest())
      axis = other;
  // Along the axis of a machine there is much in one place; across it the middle has the axis.
  constexpr double alongAxis = 0.8, acrossAxis = 0.4;
  const bool isAlong = std::abs(cutAxisOf(cutAxis).direction[axis]) > 0.9;
  const int layer = layers[axis].best(isAlong ? alongAxis : acrossAxis);
  const double away = (layer - Layers::count / 2) * layers[axis].thickness;
  const double low = all.GetMinPoint()[axis], high = all.GetMaxPoint()[axis];
  const double place = shortPlace(0.5 * (low + high) + away, high - low);
  return ShowRange{std::string(1, "xyz"[axis]), {{place, place}}};
}

VolumeSettings lookInForce(const Settings& settings, const ShowRange& slice, bool hidesCells)
{
  VolumeSettings look = settings.volume;
  if (look.cloud == "auto")
    look.cloud = !look.opacity.empty() || look.opacityUnit || look.lit ? "on" : "off";
  const bool hasCloud = look.cloud == "on";
  const bool hasOther = hasCloud || !look.isoValues.empty() || settings.flow.lines > 0 ||
                        (settings.flow.arrows > 0 && settings.flow.arrowsOn != "slices");
  const bool isAsked = look.walls.has_value();
  const bool showsCells = hidesCells && !hasOther && !isAsked && !look.nearWalls && !look.slices;
  if (!look.slices)
  {
    look.slices = std::vector<ShowRange>();
    if (!hasOther)
      look.slices = facesOf(settings.cuts);
    if (!hasOther && look.slices->empty() && !showsCells)
      look.slices = {slice};
  }
  if (showsCells)
  {
    look.nearWalls = 1.0;
    if (look.wallColor == VolumeSettings().wallColor)
      look.wallColor = "data";
  }
  // What is rolled out flat does not lie within the walls.
  if (!isAsked)
    look.walls = hasCloud || look.unroll ? 0.0 : 1.0;
  const bool isFull = hasOther || !look.slices->empty();
  if (!look.nearWalls)
    look.nearWalls = isAsked || !isFull ? *look.walls : 0.0;
  return look;
}

void addRepetitions(const Settings& settings, double bounds[6])
{
  const int count = settings.volume.repeatAround;
  if (count == 1 || bounds[0] > bounds[1])
    return;
  const CutAxis axis = cutAxisOf(settings.cuts.axis);
  vtkBoundingBox all;
  for (int k = 0; k < count; ++k)
  {
    double copy[6];
    std::copy_n(bounds, 6, copy);
    moveBounds(transformOf({axis, 360.0 * k / count}), copy);
    all.AddBounds(copy);
  }
  all.GetBounds(bounds);
}

} // namespace mote::app
