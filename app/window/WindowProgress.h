#pragma once

#include "base/ProgressRelay.h"
#include "settings/Settings.h"

#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkTextActor.h>

class vtkRenderWindow;
class vtkRenderer;

namespace mote::app
{

/// A bar in the window, in place of the view while long work goes on.
class WindowProgress : public ProgressDisplay
{
public:
  WindowProgress(vtkRenderWindow* window, vtkRenderer* view);

  void show(const std::string& what, double share) override;
  void hide() override;
  bool wantsStop() override;

  /// Forgets an earlier wish to stop.
  void reset() { stop_ = false; }
  /// Whether the user wants the program to end, too.
  bool wantsQuit() const { return quit_; }
  /// Whether the window shows the bar now.
  bool shown() const { return shown_; }

private:
  vtkRenderWindow* window_;
  vtkRenderer* view_;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkTextActor> text_;
  vtkNew<vtkPlaneSource> bar_;
  bool shown_ = false;
  bool stop_ = false;
  bool quit_ = false;
};

} // namespace mote::app
