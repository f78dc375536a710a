#pragma once

#include <vtkInteractorStyleTrackballCamera.h>

#include <array>
#include <functional>
#include <string>

namespace mote::app
{

/// A trackball whose keys, wheel, clicks and rectangles are the program's own.
class InteractorStyle : public vtkInteractorStyleTrackballCamera
{
public:
  static InteractorStyle* New();
  vtkTypeMacro(InteractorStyle, vtkInteractorStyleTrackballCamera);

  /// An X11 key symbol, such as "bracketleft", with "Control+" before it where that is held down.
  std::function<void(const std::string& key)> onKey;
  std::function<void(double factor)> onZoom; ///< a turn of the wheel

  /// The left button went down and up at one place; `adds` with Shift or Ctrl.
  std::function<void(bool adds)> onClick;

  /// What is drawn with Ctrl and a button held down, from corner to corner in pixels of the window.
  struct Rectangle
  {
    std::array<int, 2> from, to;
    bool isThrough; ///< by the right button
    bool adds;      ///< with Shift
  };
  std::function<void(const Rectangle&, bool isDone)> onRectangle;
  bool drawsRectangle() const { return draws_; }

  /// The left button goes down, with Alt on something, or without on a handle; whether it was taken
  /// hold of. Then it is dragged until the button goes up.
  std::function<bool(bool withAlt)> onGrab;
  std::function<void(bool isDone)> onDrag;

  void OnKeyPress() override;
  void OnMouseWheelForward() override;
  void OnMouseWheelBackward() override;
  void OnLeftButtonDown() override;
  void OnLeftButtonUp() override;
  void OnRightButtonDown() override;
  void OnRightButtonUp() override;
  void OnMiddleButtonDown() override;
  void OnMiddleButtonUp() override;
  void OnMouseMove() override;

  /// VTK's own keys are off.
  void OnChar() override {}
  /// Timers are the program's own: VTK would repeat the last motion at each.
  void OnTimer() override {}

private:
  std::array<int, 2> cursor() const;
  bool isNearPress() const;
  bool beginRectangle(bool isThrough);
  bool endRectangle(bool isThrough);

  std::array<int, 2> pressed_{};
  bool mayBeClick_ = false; ///< the left button is down and has not moved
  bool holds_ = false;      ///< what onGrab() took hold of
  bool draws_ = false, isThrough_ = false, adds_ = false;
};

} // namespace mote::app
