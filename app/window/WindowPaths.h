#pragma once

#include "settings/Settings.h"
#include "stage/ParticlePaths.h"

#include <memory>
#include <string>

namespace mote::app
{

/// Reads the paths of particles through all time steps, for the views to show.
class WindowPaths
{
public:
  /// Reads what --trajectories of the settings asks for, where that is other than before
  /// or the input's steps are. The cache may have steps of the input.
  void follow(const Settings& settings, const Input& input, const std::weak_ptr<StepCache>& cache);
  void clear();

  /// Takes what was read by now; whether there is more than before.
  bool update();
  bool isReading() const { return paths_ && paths_->stepsRead() < paths_->steps(); }
  bool isShown() const { return paths_ != nullptr; }
  const ParticlePaths* paths() const { return paths_.get(); }

private:
  std::unique_ptr<ParticlePaths> paths_;
  IdRanges ids_; ///< that are shown
  std::string positions_;
  std::vector<std::string> files_;
  std::vector<double> times_;
  int shown_ = 0; ///< steps
};

} // namespace mote::app
