#include "Measure.h"

#include "base/Text.h"

#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkMath.h>
#include <vtkStringArray.h>

#include <cmath>
#include <sstream>

namespace mote::app
{

namespace
{

/// A step in the box's vectors; false for a flat box.
bool inVectors(const SimulationBox& box, const Place& step, Place& shares)
{
  double columns[3][3];
  for (int i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis)
      columns[axis][i] = box.vectors[i][axis];
  const double volume = vtkMath::Determinant3x3(columns);
  double size = 1.0;
  for (const auto& vector : box.vectors)
    size *= vtkMath::Norm(vector);
  if (!(std::abs(volume) > 1e-12 * size))
    return false;
  vtkMath::LinearSolve3x3(columns, step.data(), shares.data());
  return true;
}

Place moved(Place step, const SimulationBox& box, const int counts[3])
{
  for (int i = 0; i < 3; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      step[axis] -= counts[i] * box.vectors[i][axis];
  return step;
}

/// The shortest of all steps that differ by whole periods. Of skewed boxes it is not always the one
/// whose shares are least, but near to that.
Place shortest(const Place& step, const SimulationBox& box, const std::array<bool, 3>& isPeriodic)
{
  constexpr int around = 2;
  Place shares{};
  if (!inVectors(box, step, shares))
    return step;
  int first[3], from[3], to[3];
  for (std::size_t i = 0; i < 3; ++i)
  {
    const bool isUsable = isPeriodic[i] && std::abs(shares[i]) < 1e9;
    first[i] = isUsable ? static_cast<int>(std::lround(shares[i])) : 0;
    from[i] = first[i] - (isUsable ? around : 0);
    to[i] = first[i] + (isUsable ? around : 0);
  }
  Place best = moved(step, box, first);
  double least = vtkMath::Norm(best.data());
  for (int a = from[0]; a <= to[0]; ++a)
    for (int b = from[1]; b <= to[1]; ++b)
      for (int c = from[2]; c <= to[2]; ++c)
      {
        const int counts[3] = {a, b, c};
        const Place other = moved(step, box, counts);
        const double length = vtkMath::Norm(other.data());
        // Of images that are as near the one that is there is meant.
        if (length < least * (1.0 - 1e-12))
          least = length, best = other;
      }
  return best;
}

} // namespace

std::array<bool, 3> periodsOf(vtkDataSet* data)
{
  std::array<bool, 3> isPeriodic{};
  auto* words = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("boundary"));
  if (!words || words->GetNumberOfValues() == 0)
    return isPeriodic;
  std::istringstream text(words->GetValue(0));
  std::string word;
  for (bool& is : isPeriodic)
    is = (text >> word) && word == "pp";
  return isPeriodic;
}

Distance distanceBetween(const Place& from, const Place& to,
  const std::optional<SimulationBox>& box, const std::array<bool, 3>& isPeriodic)
{
  Distance distance;
  distance.from = from;
  distance.to = to;
  vtkMath::Subtract(to, from, distance.step);
  distance.direct = distance.length = vtkMath::Norm(distance.step.data());
  if (!box)
    return distance;
  const Place step = shortest(distance.step, *box, isPeriodic);
  const double length = vtkMath::Norm(step.data());
  if (length < distance.direct * (1.0 - 1e-9))
  {
    distance.step = step;
    distance.length = length;
    distance.isAcross = true;
  }
  return distance;
}

std::optional<Measured> measure(const PickedSet::Parts& parts, const PickedSet& picked)
{
  const auto& items = picked.items();
  if (items.size() < 2 || items.size() > 3)
    return {};
  std::optional<SimulationBox> box;
  std::array<bool, 3> isPeriodic{};
  for (const Picked& one : items)
    if (vtkDataSet* data = parts[static_cast<std::size_t>(one.part)]->data(); !box)
    {
      box = simulationBoxOf(data);
      isPeriodic = periodsOf(data);
    }
  Measured measured;
  for (std::size_t i = 1; i < items.size(); ++i)
    measured.distances.push_back(distanceBetween(
      picked.placeOf(parts, items[i - 1]), picked.placeOf(parts, items[i]), box, isPeriodic));
  if (items.size() == 3 && measured.distances[0].length > 0.0 && measured.distances[1].length > 0.0)
  {
    Place back = measured.distances[0].step;
    vtkMath::MultiplyScalar(back.data(), -1.0);
    measured.angle = vtkMath::DegreesFromRadians(
      vtkMath::AngleBetweenVectors(back.data(), measured.distances[1].step.data()));
  }
  return measured;
}

std::string asText(const Distance& distance)
{
  return asNumber(distance.length) + (distance.isAcross ? " to the nearest image" : "");
}

} // namespace mote::app
