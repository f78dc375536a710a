#pragma once

#include "settings/Settings.h"
#include "stage/ParticlePaths.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <memory>
#include <string>

namespace mote::app
{

/// The paths of particles through all time steps, as lines in the view.
class WindowPaths
{
public:
  explicit WindowPaths(vtkRenderer* renderer);

  /// Reads and shows what --trajectories of the settings asks for, where that is other than before
  /// or the input's steps are.
  void follow(const Settings& settings, const Input& input);
  void clear();

  /// Takes what was read by now; whether there is more than before.
  bool update();
  bool isReading() const { return paths_ && paths_->stepsRead() < paths_->steps(); }
  bool isShown() const { return paths_ != nullptr; }

private:
  vtkNew<vtkPolyData> lines_;
  vtkNew<vtkActor> actor_;
  std::unique_ptr<ParticlePaths> paths_;
  IdRanges ids_; ///< that are shown
  std::string positions_;
  std::vector<std::string> files_;
  std::vector<double> times_;
  int shown_ = 0; ///< steps
};

} // namespace mote::app
