#pragma once

class vtkRenderWindow;

namespace mote::app
{

/// Brings the frames of a window of X11 onto the screen. VTK's own way goes over the whole window
/// twice more, for depths that nobody sees: a third of a frame of the panel, where the processor
/// does OpenGL's work.
class Presenter
{
public:
  /// Other windows than those of X11 stay as they are.
  explicit Presenter(vtkRenderWindow* window);

  /// Shows what was drawn last; at the end of each frame that was not stopped.
  void present();
  /// Shows these many columns from the left, where nothing else has changed since the last frame.
  void presentLeft(int columns);

private:
  bool copyToBack(int columns);

  vtkRenderWindow* window_;
  bool isOwn_ = false; ///< this shows the frames, not VTK
  using CopySubBuffer = void (*)(void* display, unsigned long window, int, int, int, int);
  CopySubBuffer copySubBuffer_ = nullptr; ///< where the driver has it
  bool isAsked_ = false;                  ///< the driver was asked for it
};

} // namespace mote::app
