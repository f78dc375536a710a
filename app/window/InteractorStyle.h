#pragma once

#include <vtkInteractorStyleTrackballCamera.h>

#include <functional>
#include <string>

namespace mote::app
{

/// A trackball whose keys and wheel are the program's own.
class InteractorStyle : public vtkInteractorStyleTrackballCamera
{
public:
  static InteractorStyle* New();
  vtkTypeMacro(InteractorStyle, vtkInteractorStyleTrackballCamera);

  /// An X11 key symbol, such as "bracketleft", with "Control+" before it where that is held down.
  std::function<void(const std::string& key)> onKey;
  std::function<void(double factor)> onZoom; ///< a turn of the wheel

  void OnKeyPress() override;
  void OnMouseWheelForward() override;
  void OnMouseWheelBackward() override;

  /// VTK's own keys are off.
  void OnChar() override {}
  /// Timers are the program's own: VTK would repeat the last motion at each.
  void OnTimer() override {}
};

} // namespace mote::app
