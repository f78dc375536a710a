#pragma once

#include "WindowLegend.h"
#include "stage/Stage.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

class vtkAxesActor;
class vtkOrientationMarkerWidget;
class vtkRenderWindowInteractor;

namespace mote::app
{

/// The ordinary VTK props over the views: colour legend, axes.
class WindowProps
{
public:
  explicit WindowProps(Stage& stage);
  ~WindowProps();

  /// Shows the little axes in the corner; call once, when the interactor is initialized.
  void attach(vtkRenderWindowInteractor* interactor);

  /// Follows the stage's data and settings.
  void update();

  /// Puts the axes into the corner of the view, wherever that lies in the window by now.
  void placeAxes();

  /// The size of the axes' letters: 1 for a display of 96 dots an inch.
  void setScale(double scale);

  WindowLegend& legend() { return legend_; }

private:
  void setInk(const Color& ink);
  void showAxes();

  Stage& stage_;
  double scale_ = 1.0;
  WindowLegend legend_;
  vtkNew<vtkAxesActor> axes_;
  vtkNew<vtkOrientationMarkerWidget> corner_;
};

} // namespace mote::app
