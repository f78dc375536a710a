#pragma once

#include "Arrays.h"
#include "Cuts.h"
#include "FlowFinder.h"
#include "Part.h"
#include "base/ProgressRelay.h"
#include "settings/Settings.h"

#include <vtkActor.h>
#include <vtkMoteMeshMapper.h>
#include <vtkNew.h>

#include <memory>
#include <vector>

class vtkLookupTable;

namespace mote::app
{

/// Streamlines and arrows of what flows in all volumes that are not hidden, as the settings say:
/// triangles of the scene, which are not picked.
class Flow
{
public:
  /// The settings are those of the scene.
  explicit Flow(const Settings& settings);

  /// What is drawn: lines, then arrows.
  std::vector<vtkActor*> actors() const { return {lines_.actor, arrows_.actor}; }

  /// Whether any are asked for.
  static bool isAny(const Settings& settings)
  {
    return settings.flow.lines > 0 || settings.flow.arrows > 0;
  }
  /// Whether other settings ask for others.
  static bool areOther(const Settings& a, const Settings& b);

  /// The next build() takes this where it fits data and settings.
  void offer(const BuiltFlow& built) { offered_ = built; }
  const BuiltFlow& built() const { return built_; }

  /// Finds lines and arrows anew, where settings or data are others. Throws Failure and
  /// Interrupted.
  void build(const std::vector<std::unique_ptr<Part>>& parts, const Runner& runner);
  /// Shows nothing.
  void clear();

  void setAmbient(double ambient);
  void setColors(const ArrayChoice& choice, vtkLookupTable* table);
  void setCuts(const Cuts& cuts);

  /// Those that are shown; one goes both ways from its place.
  vtkIdType numberOfLines() const;

private:
  struct Drawn
  {
    vtkNew<vtkActor> actor;
    vtkNew<vtkMoteMeshMapper> mapper;
  };
  void show(const BuiltFlow& built);
  void draw(Drawn& drawn, vtkPolyData* triangles);
  void color(Drawn& drawn);

  const Settings& settings_;
  FlowFinder finder_;
  Drawn lines_, arrows_;
  double ambient_ = 0.0;
  ArrayChoice choice_;
  vtkSmartPointer<vtkLookupTable> table_;
  BuiltFlow built_, offered_; ///< what is shown; and what another thread has found
};

} // namespace mote::app
