#include "CoherentGrid.h"

#include "../core/Error.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>

namespace mote
{

void CoherentGrid::setAttributes(const std::vector<ParticleAttribute>& attributes)
{
  values_.clear();
  if (attributes.empty() || count_ == 0)
    return;
  if (attributes.size() > 4)
    throw Error("A particle has at most four attributes for ranges.");
  if (index32_.empty() && index64_.empty())
    throw Error("Attributes need a structure that keeps the particles' input indices.");
  const std::size_t inputs = statistics_.valid + statistics_.badPositions + statistics_.badRadii;
  for (const ParticleAttribute& a : attributes)
  {
    if (a.values.count() != inputs)
      throw Error("An attribute has " + std::to_string(a.values.count()) + " values for " +
                  std::to_string(inputs) + " particles.");
    if (a.component >= a.values.components() || a.component < ArrayView::magnitude)
      throw Error("An attribute has no component " + std::to_string(a.component) + ".");
  }
  values_.resize(count_);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count_, 4096),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t slot = range.begin(); slot != range.end(); ++slot)
      {
        values_[slot].fill(0.0f);
        const std::uint64_t input = inputIndex(slot);
        for (std::size_t k = 0; k < attributes.size(); ++k)
          values_[slot][k] =
            static_cast<float>(attributes[k].values.value(input, attributes[k].component));
      }
    });
}

void CoherentGrid::setRanges(const ParticleRanges& ranges)
{
  ranges_ = ranges;
  setVisibility(
    [&](std::size_t slot)
    {
      const Vec3d c = center(slot);
      double v[8] = {c.x, c.y, c.z, radius(slot), 0.0, 0.0, 0.0, 0.0};
      for (int k = 0; k < 4 && !values_.empty(); ++k)
        v[4 + k] = values_[slot][k];
      for (int k = 0; k < 8; ++k)
        if (ranges.isLimited(k) && !(v[k] >= ranges.lower[k] && v[k] <= ranges.upper[k]))
          return false;
      return true;
    });
}

} // namespace mote
