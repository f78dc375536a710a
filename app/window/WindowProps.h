#pragma once

#include "WindowLegend.h"
#include "stage/Stage.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

class vtkActor;
class vtkAxesActor;
class vtkOrientationMarkerWidget;
class vtkRenderWindowInteractor;

namespace mote::app
{

/// The ordinary VTK props around the data: simulation box, colour legend, axes, the mark on a
/// picked particle.
class WindowProps
{
public:
  explicit WindowProps(Stage& stage);
  ~WindowProps();

  /// Shows the little axes in the corner; call once, when the interactor is initialized.
  void attach(vtkRenderWindowInteractor* interactor);

  /// Follows the stage's data and settings.
  void update();

  /// Where the view begins, as a share of the window's width.
  void setLeft(double share);

  WindowLegend& legend() { return legend_; }

  /// A cage around a picked particle, never smaller than a few pixels.
  void mark(const double center[3], double radius);
  void unmark();

private:
  void setInk(const Color& ink);
  double pixelSizeAt(const double position[3]);

  Stage& stage_;
  WindowLegend legend_;
  vtkNew<vtkActor> box_;
  vtkNew<vtkActor> mark_;
  vtkNew<vtkAxesActor> axes_;
  vtkNew<vtkOrientationMarkerWidget> corner_;
};

} // namespace mote::app
