#include "Opacity.h"

#include <vtkDataSet.h>
#include <vtkMoteVolumeQuantiles.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>

namespace mote::app
{

namespace
{

/// The opacity of the value that a share of the volume lies below.
struct ShareOpacity
{
  double share, opacity;
};

constexpr ShareOpacity usual[] = {{0.0, 0.9}, {0.01, 0.9}, {0.03, 0.4}, {0.1, 0.08}, {0.3, 0.015},
  {0.7, 0.015}, {0.9, 0.08}, {0.97, 0.4}, {0.99, 0.9}, {1.0, 0.9}};
constexpr double everywhere = 0.3; ///< of one value

/// Cells that the distribution is taken from: enough for a look, and found within a twentieth of a
/// second, so that a key that shows another array is answered soon.
constexpr vtkIdType cellsLookedAt = 10000;

std::vector<std::pair<vtkDataSet*, unsigned long>> keyOf(const std::vector<vtkDataSet*>& data)
{
  std::vector<std::pair<vtkDataSet*, unsigned long>> key;
  for (vtkDataSet* one : data)
    key.emplace_back(one, one->GetMTime());
  return key;
}

} // namespace

std::vector<OpacityPoint> opacitiesFor(
  const std::vector<vtkDataSet*>& data, const ArrayChoice& choice)
{
  vtkNew<vtkMultiBlockDataSet> all;
  for (vtkDataSet* one : data)
    all->SetBlock(all->GetNumberOfBlocks(), one);
  vtkNew<vtkMoteVolumeQuantiles> quantiles;
  quantiles->SetInputData(all);
  quantiles->SetArrayName(choice.name);
  quantiles->SetMaximumNumberOfCells(cellsLookedAt);
  quantiles->SetOfCells(choice.ofCells);
  quantiles->SetComponent(choice.component == ArrayChoice::magnitude ? -1 : choice.component);
  quantiles->Update();
  const double least = quantiles->GetQuantile(0.0), most = quantiles->GetQuantile(1.0);
  if (std::isnan(least))
    return {};
  if (least == most)
    return {{least, false, everywhere}};
  std::vector<OpacityPoint> points;
  for (const auto& [share, opacity] : usual)
  {
    const double value = quantiles->GetQuantile(share);
    // A value that much of the volume has is common, though it be the least of all.
    if (!points.empty() && points.back().value == value)
      points.back().opacity = std::min(points.back().opacity, opacity);
    else
      points.push_back({value, false, opacity});
  }
  return points;
}

const std::vector<OpacityPoint>& UsualOpacity::of(
  const std::vector<vtkDataSet*>& data, const ArrayChoice& choice)
{
  if (keyOf(data) != key_ || choice != found_.choice)
    this->offer(data, {choice, opacitiesFor(data, choice)});
  return found_.points;
}

UsualOpacity::Found UsualOpacity::foundOf(const std::vector<vtkDataSet*>& data) const
{
  return keyOf(data) == key_ ? found_ : Found();
}

void UsualOpacity::offer(const std::vector<vtkDataSet*>& data, const Found& found)
{
  key_ = keyOf(data);
  found_ = found;
}

} // namespace mote::app
