#include "WindowPaths.h"

namespace mote::app
{

void WindowPaths::follow(
  const Settings& settings, const Input& input, const std::weak_ptr<StepCache>& cache)
{
  const IdRanges& wanted = settings.marks.trajectories;
  if (wanted.empty() || input.files().empty())
    return this->clear();
  if (paths_ && wanted == ids_ && settings.data.positions == positions_ &&
      input.files() == files_ && input.times() == times_)
    return;
  ids_ = wanted;
  positions_ = settings.data.positions;
  files_ = input.files();
  times_ = input.times();
  shown_ = 0;
  paths_ = nullptr; // before the next one reads
  paths_ = std::make_unique<ParticlePaths>(input.again(), wanted, settings, cache);
}

void WindowPaths::clear()
{
  paths_ = nullptr;
}

bool WindowPaths::update()
{
  if (!paths_ || paths_->stepsRead() == shown_)
    return false;
  shown_ = paths_->stepsRead();
  return true;
}

} // namespace mote::app
