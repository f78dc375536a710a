#include "detail/ParticleAttributes.h"

#include "../core/Error.h"

#include <string>

namespace mote
{

void checkAttributes(const std::vector<ParticleAttribute>& attributes,
  const ParticleStatistics& statistics, bool hasIndices, std::size_t inputs)
{
  if (attributes.size() > 4)
    throw Error("A particle has at most four attributes for ranges.");
  if (!attributes.empty() && statistics.valid > 0 && !hasIndices)
    throw Error("Attributes need a structure that keeps the particles' input indices.");
  if (inputs == 0)
    inputs = statistics.valid + statistics.badPositions + statistics.badRadii;
  for (const ParticleAttribute& a : attributes)
  {
    if (a.values.count() != inputs)
      throw Error("An attribute has " + std::to_string(a.values.count()) + " values for " +
                  std::to_string(inputs) + " particles.");
    if (a.component >= a.values.components() || a.component < ArrayView::magnitude)
      throw Error("An attribute has no component " + std::to_string(a.component) + ".");
  }
}

void checkRanges(const ParticleRanges& ranges, bool hasAttributes)
{
  for (int k = 4; k < ParticleRanges::count; ++k)
    if (ranges.isLimited(k) && !hasAttributes)
      throw Error("A range is set on an attribute, and there are no attributes.");
}

} // namespace mote
