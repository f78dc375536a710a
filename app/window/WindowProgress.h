#pragma once

#include "base/ProgressRelay.h"
#include "settings/Settings.h"

#include <vtkActor2D.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkTextActor.h>

class vtkRenderWindow;
class vtkRenderer;

namespace mote::app
{

/// A bar in the window while long work goes on, over the last frame of the view, darkened.
class WindowProgress : public ProgressDisplay
{
public:
  /// `above` draws over the view.
  WindowProgress(vtkRenderWindow* window, vtkRenderer* view, vtkRenderer* above);

  void show(const std::string& what, double share) override;
  void hide() override;
  bool wantsStop() override;

  /// The size of its text: 1 for a display of 96 dots an inch.
  void setScale(double scale);
  /// Forgets an earlier wish to stop.
  void reset() { stop_ = false; }
  /// Whether the user wants the program to end, too.
  bool wantsQuit() const { return quit_; }
  /// Whether the window shows the bar now.
  bool shown() const { return shown_; }

private:
  void keepFrame();

  vtkRenderWindow* window_;
  vtkRenderer* view_;
  vtkRenderer* above_;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkTextActor> text_;
  vtkNew<vtkPlaneSource> bar_;
  vtkNew<vtkActor2D> barActor_, grooveActor_;
  bool shown_ = false;
  bool isNew_ = false; ///< the view has been drawn since the bar was there
  bool stop_ = false;
  bool quit_ = false;
};

} // namespace mote::app
