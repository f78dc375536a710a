#pragma once

#include "Calculated.h"
#include "Coloring.h"
#include "Flow.h"
#include "Framing.h"
#include "Input.h"
#include "Lighting.h"
#include "Part.h"
#include "ReadyStep.h"
#include "Selection.h"

#include <vtkMoteSilhouettes.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace mote::app
{

/// What is seen, in the window as in a file: the parts of the present time step in a renderer, with
/// background, lights, camera and colours as the settings say.
class Stage
{
public:
  explicit Stage(const Settings& settings);

  /// As they were given.
  const Settings& settings() const { return asked_; }
  /// The same, with what is chosen of itself of how volumes look; see lookInForce().
  const Settings& shown() const { return settings_; }

  /// Takes other settings and follows them, but for the data, size and camera. Returns whether
  /// build() must follow. Throws Failure where they do not fit the data; then apply() with the
  /// former ones brings those back.
  bool apply(const Settings& settings);

  /// The settings with what was chosen of itself said outright: array and range of the colours, the
  /// radius that is kept over time steps, the camera.
  Settings settingsInForce() const;

  /// Takes the data away, and forgets what was learnt of them: files of other data may follow.
  void clear();

  /// Shows other data; build() must follow, and takes what is ready.
  void setData(const std::vector<NamedData>& original, const ReadyStep* ready = nullptr);

  /// What was built of the data, but for previews.
  ReadyStep ready() const;
  /// How steps are to be made ready, to fit this stage.
  ReadyPlan readyPlan() const;

  /// Brings all structures up to date. Throws Failure and Interrupted.
  void build(ProgressRelay& progress);

  /// As Part::setPreview(), update() and finishBuild().
  void setPreview(bool on);
  std::string update();
  void finishBuild(ProgressRelay& progress);
  /// Stops what other threads build, before data change.
  void stopBuild();

  /// Whether other threads build.
  bool isBuilding() const;
  /// "Preview: 1,000,000 of 80,000,000 particles, enlarged"; empty where all that is shown is
  /// exact.
  std::string preview() const;

  /// Colours by the settings' array, or the most telling one, and hides what they hide.
  void applyColors();
  void applyCuts();

  /// Looks as the settings' camera says; without one from the settings' side, with all that is
  /// shown in the frame, spheres and all.
  void look(double aspect, const Margins& margins);

  vtkRenderer* renderer() const { return renderer_; }
  Coloring& coloring() { return coloring_; }
  const Coloring& coloring() const { return coloring_; }
  const Lighting& lighting() const { return lighting_; }
  const Flow& flow() const { return flow_; }
  vtkMoteSilhouettes* silhouettes() const { return silhouettes_; }
  const std::vector<std::unique_ptr<Part>>& parts() const { return parts_; }

  /// The file that a part is of.
  std::string fileOf(std::size_t part) const
  {
    return part < data_.size() ? data_[part].file : std::string();
  }

  /// What parts() show, without what is calculated.
  const std::vector<NamedData>& data() const { return data_; }

  /// What is seen beside one another, as numbers of parts(): those of each file that are not hidden
  /// have a view of their own, or those of one file one each. All parts together where the settings
  /// do not ask for that, and where there is nothing to be set beside another.
  std::vector<std::vector<std::size_t>> views() const;
  static constexpr std::size_t mostViews = 4; ///< what is too much for them shares the last
  /// "copper.dump": what the view of these parts is called; "copper.dump, step 3/7" where other
  /// data are at another step of theirs.
  std::string viewName(const std::vector<std::size_t>& view) const;
  /// How far from where the first view looks that of these parts does, so that data which do not
  /// meet those of the first are seen in the middle of theirs: 0 where they do.
  std::array<double, 3> asideOf(const std::vector<std::size_t>& view) const;
  /// What is drawn in the view of these parts. Streamlines and arrows are where all volumes are.
  std::vector<vtkProp3D*> propsOf(const std::vector<std::size_t>& view) const;

  /// Bounds of all that is built; else of the simulation box; of a unit cube where there is
  /// nothing.
  void bounds(double bounds[6]) const;

  /// Bounds of what is not hidden, by the camera of the first view; of all where everything is.
  void shownBounds(double bounds[6]) const;

  vtkIdType numberOfParticles() const;
  vtkIdType numberShown() const;        ///< of the particles, those that are not hidden
  vtkIdType numberOfCells() const;      ///< of volumes, and of surfaces that hide some
  vtkIdType numberOfCellsShown() const; ///< of those of them that are not hidden
  vtkIdType numberOfTriangles(bool shownOnly) const; ///< of surfaces, as drawn; not of lines
  vtkIdType numberOfLines(bool shownOnly) const;     ///< that are drawn as tubes
  vtkTypeInt64 structureBytes() const;
  double buildTime() const;

  /// "84,270 particles", "12 of 84,270 particles shown", "33,600 cells", "600 of
  /// 33,600 cells shown"...
  std::string contents() const;

  /// Pixels that levels of detail may err by, at most.
  double lodError() const;
  /// What was chosen for an error budget, and the error that a picture with rays so many pixels
  /// apart and with this noise most likely has: ", tolerance 0.004, expected error 0.8 %".
  std::string errorText(double distance, double noise) const;

private:
  std::string automaticSide() const;
  void setSizes();
  void checkImages() const;
  void turnParts();
  void chooseLook();
  void placeSlice(const std::vector<NamedData>& data);

  Settings asked_, settings_;           ///< as given; shown(), which all below refer to
  std::optional<ShowRange> usualSlice_; ///< of volumes, which stays over time steps
  bool hidesCells_ = false;             ///< whether a selection hides cells of volumes
  vtkNew<vtkRenderer> renderer_;
  KnownExpressions known_;
  std::vector<NamedData> data_; // one for each of parts_
  std::vector<std::unique_ptr<Part>> parts_;
  Lighting lighting_;
  vtkNew<vtkMoteSilhouettes> silhouettes_;
  Coloring coloring_;
  Selection selection_;
  Cuts cuts_;
  Flow flow_;
  bool preview_ = false;
  std::string toldTurns_; ///< of those that do not turn
};

} // namespace mote::app
