// How much what a stage shows may err by, in words.

#include "Stage.h"

#include "base/Text.h"
#include "settings/ErrorBudget.h"

#include <algorithm>
#include <cmath>

namespace mote::app
{

double Stage::lodError() const
{
  double most = 0.0;
  for (const auto& part : parts_)
    most = std::max(most, part->lodError());
  return most;
}

std::string Stage::errorText(double distance, double noise) const
{
  const double lods = this->lodError();
  std::string text;
  if (lods > 0.0)
    text = ", levels of detail within " + asNumber(lods, 2) + " px";
  const double far = (distance > 1.0 ? 0.5 * distance : 0.0) + lods;
  if (isPlaceError(settings_.picture) && far > 0.0)
    text += ", edges within " + asNumber(far, 2) + " px";
  if (!isColorError(settings_.picture))
    return text;
  const bool hasVolumes = std::any_of(parts_.begin(), parts_.end(),
    [](const auto& part) { return part->kind() == Part::Kind::Volume; });
  const ErrorShares shares = errorShares(settings_);
  if (hasVolumes)
    text += ", tolerance " + asNumber(shares.tolerance, 2);
  if (std::isfinite(noise))
    text += ", expected error " +
            asNumber(100.0 * expectedError(shares, noise, hasVolumes, lods), 2) + " %";
  return text;
}

} // namespace mote::app
