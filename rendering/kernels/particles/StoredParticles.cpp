#include "StoredParticles.h"

#include "../core/Error.h"
#include "detail/RadiusGroups.h"

#include <cmath>
#include <string>

namespace mote
{

void StoredParticles::placeByCells(double cells)
{
  origin_ = statistics_.centers.center();
  const double edge =
    particleGridEdge(statistics_.centers.size(), cells, statistics_.largestRadius);
  unit_ = std::exp2(std::round(std::log2(edge)));
}

void StoredParticles::checkAttributes(
  const std::vector<ParticleAttribute>& attributes, bool hasIndices, std::size_t inputs) const
{
  if (attributes.size() > 4)
    throw Error("A particle has at most four attributes for ranges.");
  if (!attributes.empty() && statistics_.valid > 0 && !hasIndices)
    throw Error("Attributes need a structure that keeps the particles' input indices.");
  if (inputs == 0)
    inputs = statistics_.valid + statistics_.badPositions + statistics_.badRadii;
  for (const ParticleAttribute& a : attributes)
  {
    if (a.values.count() != inputs)
      throw Error("An attribute has " + std::to_string(a.values.count()) + " values for " +
                  std::to_string(inputs) + " particles.");
    if (a.component >= a.values.components() || a.component < ArrayView::magnitude)
      throw Error("An attribute has no component " + std::to_string(a.component) + ".");
  }
}

std::vector<SlotRun> StoredParticles::slotsBetween(int, double, double) const
{
  std::vector<SlotRun> runs;
  addRun(runs, 0, count_);
  return runs;
}

void StoredParticles::addRun(std::vector<SlotRun>& runs, std::size_t first, std::size_t last)
{
  if (!runs.empty() && runs.back().last == first)
  {
    first = runs.back().first;
    runs.pop_back();
  }
  for (; last - first > SlotRun::longest; first += SlotRun::longest)
    runs.push_back({first, first + SlotRun::longest});
  if (first < last)
    runs.push_back({first, last});
}

void StoredParticles::keepRanges(const ParticleRanges& ranges)
{
  for (int k = 4; k < ParticleRanges::count; ++k)
    if (ranges.isLimited(k) && values_.empty() && count_ > 0)
      throw Error("A range is set on an attribute, and there are no attributes.");
  ranges_ = ranges;
}

} // namespace mote
