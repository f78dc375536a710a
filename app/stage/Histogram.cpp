#include "Histogram.h"

#include <ParticleModel.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkMoteParticleMapper.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace mote::app
{

namespace
{

constexpr vtkIdType mostCounted = 1'000'000; // of a part: a hundredth of a second

/// Counts the values of so many places.
void count(Histogram& histogram, vtkIdType values, const std::function<double(vtkIdType)>& valueAt)
{
  const vtkIdType step = std::max<vtkIdType>(1, values / mostCounted);
  const double bins = static_cast<double>(histogram.counts.size());
  const double width = histogram.most - histogram.least;
  for (vtkIdType i = 0; i < values; i += step)
  {
    const double value = valueAt(i);
    if (!std::isfinite(value))
      continue;
    const double at = width > 0.0 ? (value - histogram.least) / width * bins : 0.5 * bins;
    const double bin = std::clamp(std::floor(at), 0.0, bins - 1.0);
    histogram.counts[static_cast<std::size_t>(bin)] += static_cast<double>(step);
  }
  histogram.highest = *std::max_element(histogram.counts.begin(), histogram.counts.end());
}

void widen(Histogram& histogram, double least, double most)
{
  const bool isFirst = histogram.isEmpty();
  histogram.least = isFirst ? least : std::min(histogram.least, least);
  histogram.most = isFirst ? most : std::max(histogram.most, most);
}

} // namespace

Histogram histogramOf(
  const std::vector<std::unique_ptr<Part>>& parts, const ArrayChoice& choice, int bins)
{
  Histogram histogram;
  histogram.counts.resize(static_cast<std::size_t>(bins));
  for (const auto& part : parts)
    if (double range[2]; finiteRange(arrayOf(part->data(), choice), choice.component, range))
      widen(histogram, range[0], range[1]);
  if (histogram.isEmpty())
    return histogram;
  for (const auto& part : parts)
    if (vtkDataArray* array = arrayOf(part->data(), choice))
      count(histogram, array->GetNumberOfTuples(),
        [&](vtkIdType i) { return valueOf(array, choice.component, i); });
  return histogram;
}

Kinds kindsOf(const std::vector<std::unique_ptr<Part>>& parts, const ArrayChoice& choice)
{
  constexpr std::size_t most = 100;
  std::map<int, vtkIdType> counts;
  for (const auto& part : parts)
  {
    if (part->kind() != Part::Kind::Particles || !isTypes(part->data(), choice))
      continue;
    vtkDataArray* array = arrayOf(part->data(), choice);
    // Neighbours are often of one type.
    auto present = counts.end();
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      const double value = array->GetComponent(i, 0);
      if (!std::isfinite(value))
        continue;
      if (present == counts.end() || present->first != value)
        present = counts.try_emplace(static_cast<int>(value), 0).first;
      ++present->second;
      if (counts.size() > most)
        return {};
    }
  }
  return {counts.begin(), counts.end()};
}

namespace
{

/// The radius that all particles have; 0 where they differ.
double commonRadius(const std::vector<std::unique_ptr<Part>>& parts)
{
  double common = 0.0;
  for (const auto& part : parts)
  {
    if (!part->particles() || part->data()->GetNumberOfPoints() == 0)
      continue;
    const ParticleInput input = part->particles()->GetModel().particles();
    const double radius = input.set.hasOneRadius() ? input.set.radiusOf(0) : 0.0;
    if (!(radius > 0.0) || (common > 0.0 && radius != common))
      return 0.0;
    common = radius;
  }
  return common;
}

} // namespace

std::map<int, double> meanRadii(
  const std::vector<std::unique_ptr<Part>>& parts, const ArrayChoice& types, const Kinds& kinds)
{
  std::map<int, double> means;
  if (const double common = commonRadius(parts); common > 0.0)
  {
    for (const auto& [type, number] : kinds)
      means[type] = common;
    return means;
  }
  std::map<int, std::pair<double, double>> sums; // and numbers
  for (const auto& part : parts)
  {
    vtkDataArray* array = arrayOf(part->data(), types);
    if (!array || !part->particles())
      continue;
    const ParticleInput input = part->particles()->GetModel().particles();
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      const double value = array->GetComponent(i, 0);
      const double radius = input.set.radiusOf(static_cast<std::size_t>(i));
      if (!std::isfinite(value) || !(radius > 0.0))
        continue;
      auto& [sum, number] = sums[static_cast<int>(value)];
      sum += radius;
      number += 1.0;
    }
  }
  for (const auto& [type, sum] : sums)
    means[type] = sum.first / sum.second;
  return means;
}

Histogram histogramOfPlaces(const std::vector<std::unique_ptr<Part>>& parts, int axis, int bins)
{
  Histogram histogram;
  histogram.counts.resize(static_cast<std::size_t>(bins));
  const auto hasPlaces = [](const std::unique_ptr<Part>& part)
  { return part->data()->GetNumberOfPoints() > 0; };
  for (const auto& part : parts)
    if (hasPlaces(part))
    {
      const double* bounds = part->data()->GetBounds();
      widen(histogram, bounds[2 * axis], bounds[2 * axis + 1]);
    }
  if (histogram.isEmpty())
    return histogram;
  for (const auto& part : parts)
    if (hasPlaces(part))
      count(histogram, part->data()->GetNumberOfPoints(),
        [&, data = part->data()](vtkIdType i)
        {
          double place[3];
          data->GetPoint(i, place);
          return place[axis];
        });
  return histogram;
}

} // namespace mote::app
