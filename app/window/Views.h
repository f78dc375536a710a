#pragma once

#include "View.h"
#include "stage/Stage.h"

#include <vtkCamera.h>
#include <vtkMoteRayCastPass.h>
#include <vtkNew.h>
#include <vtkTextActor.h>

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

class vtkActor2D;
class vtkRenderWindow;

namespace mote::app
{

/// Where the window shows the data: all in the stage's renderer, or, with --side-by-side, each view
/// in a renderer of its own below that one, which then has the texts and the legend alone. All have
/// one camera; where data lie elsewhere it is moved aside by as much.
class Views
{
public:
  Views(Stage& stage, vtkRenderWindow* window);
  ~Views();

  /// Follows the stage's data and settings.
  void follow(const ParticlePaths* paths);
  /// Lays the views out and brings them up to date: call before each frame.
  void update(const PickedSet& picked);
  /// Whether slices and faces of cuts have handles where the settings leave it to the panel.
  /// Returns whether other ones are seen.
  bool offerHandles(bool on);
  /// Marks anew, for what is shown has changed.
  void forgetMarks();
  /// The size of texts: 1 for a display of 96 dots an inch.
  void setScale(double scale);

  /// The view at a place of the window in pixels; null where there is none.
  View* at(int x, int y);
  /// How far the camera is moved aside in it.
  std::array<double, 3> asideOf(const View* view) const;
  /// Those that show data.
  std::vector<View*> shown();
  /// For what is drawn over all of them.
  PickedMarks& marks() { return whole_.marks(); }

  /// Of one view: pixels.
  std::array<int, 2> size() const;
  /// What their names take at the upper edge: pixels.
  int heightOfNames() const;

  //@{
  /// The passes of all views as one.
  void setUpPasses(const std::function<void(vtkMoteRayCastPass*)>& set);
  /// Gives each renderer its own.
  void takePasses();
  bool isConverged() const;
  bool isPreview() const;
  double traceTime() const;
  double silhouetteTime() const;      ///< the part of it that silhouettes took
  int numberOfSamples() const;        ///< the least
  double finerShare() const;          ///< the least
  double bakedShare() const;          ///< the least
  double imageSampleDistance() const; ///< the greatest
  double noise() const;               ///< the greatest
  //@}

private:
  struct Column
  {
    vtkNew<vtkRenderer> renderer;
    View view{renderer};
    vtkNew<vtkTextActor> title;
    vtkNew<vtkCamera> camera; ///< where the data lie elsewhere than those of the first
    std::array<double, 3> aside{};
    vtkMTimeType copied = 0;     ///< the time of the camera that it was made of
    std::vector<vtkProp*> props; ///< of the data that it shows
  };
  bool isSideBySide() const { return columns_ > 0; }
  void setColumns(std::size_t count);
  void move(const std::vector<std::vector<std::size_t>>& views);
  void lay();
  void placeCamera(Column& column);
  int pixels(int size) const { return static_cast<int>(std::lround(scale_ * size)); }
  void copyLook(vtkRenderer* to) const;
  std::array<int, 4> area() const;
  std::vector<vtkMoteRayCastPass*> passes() const;

  Stage& stage_;
  vtkRenderWindow* window_;
  View whole_;
  std::array<Column, Stage::mostViews> column_;
  std::array<vtkNew<vtkMoteRayCastPass>, Stage::mostViews> pass_;
  std::array<vtkNew<vtkActor2D>, Stage::mostViews - 1> dividers_;
  vtkNew<vtkRenderer> ground_; ///< below all columns, and beside them
  double scale_ = 1.0;
  bool offersHandles_ = false;
  std::size_t columns_ = 0; ///< 0: one view, the stage's own
};

} // namespace mote::app
