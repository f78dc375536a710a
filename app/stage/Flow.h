#pragma once

#include "Arrays.h"
#include "Cuts.h"
#include "Part.h"
#include "base/ProgressRelay.h"
#include "settings/Settings.h"

#include <vtkActor.h>
#include <vtkGlyph3D.h>
#include <vtkMoteMeshMapper.h>
#include <vtkMoteStreamlines.h>
#include <vtkNew.h>
#include <vtkTubeFilter.h>

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

  /// Whether other settings ask for others.
  static bool areOther(const Settings& a, const Settings& b);

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
  /// What scripts need to make the same.
  double tubeRadius() const { return tubes_->GetRadius(); }
  double arrowFactor() const { return glyphs_->GetScaleFactor(); }

private:
  struct Drawn
  {
    vtkNew<vtkActor> actor;
    vtkNew<vtkMoteMeshMapper> mapper;
  };
  void draw(Drawn& drawn, vtkPolyData* triangles);
  void color(Drawn& drawn);

  const Settings& settings_;
  vtkNew<vtkMoteStreamlines> found_;
  vtkNew<vtkTubeFilter> tubes_;
  vtkNew<vtkGlyph3D> glyphs_;
  Drawn lines_, arrows_;
  double ambient_ = 0.0;
  ArrayChoice choice_;
  vtkSmartPointer<vtkLookupTable> table_;
  FlowSettings built_; ///< by which it was built, and of which data
  std::vector<std::pair<vtkDataSet*, vtkMTimeType>> data_;
};

} // namespace mote::app
