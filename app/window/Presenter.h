#pragma once

#include <cstdint>
#include <memory>
#include <vector>

class vtkRenderWindow;

namespace mote::app
{

class SharedImage;

/// Brings the frames of a window of X11 onto the screen. VTK's own way goes over the whole window
/// twice more, for depths that nobody sees. Where the processor does OpenGL's work, pixels are read
/// and handed to the X server: OpenGL's way to the screen takes several times as long there.
class Presenter
{
public:
  /// Other windows than those of X11 stay as they are.
  explicit Presenter(vtkRenderWindow* window);
  ~Presenter();
  Presenter(const Presenter&) = delete;
  Presenter& operator=(const Presenter&) = delete;

  /// Shows what was drawn last, at the end of a frame: false for one that was stopped.
  bool present();
  /// Shows these many columns from the left, where nothing else has changed since the last frame.
  void presentLeft(int columns);

private:
  void present(int columns);
  bool showPixels(int columns);
  void copyToBack();

  vtkRenderWindow* window_;
  bool isOwn_ = false;                 ///< this shows the frames, not VTK
  bool isAsked_ = false;               ///< the driver was asked who does its work
  std::unique_ptr<SharedImage> image_; ///< null where a graphics card does
  std::vector<std::uint32_t> pixels_;  ///< 0xaabbggrr, from the bottom row up
};

} // namespace mote::app
