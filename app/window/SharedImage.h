#pragma once

#include <X11/Xlib.h>
#include <X11/extensions/XShm.h>

#include <cstdint>
#include <memory>

namespace mote::app
{

/// Pixels of a window in memory that the program shares with the X server.
class SharedImage
{
public:
  /// None where the server is on another machine, or the window has no pixels of 32 bits with red,
  /// green and blue from the third byte down.
  static std::unique_ptr<SharedImage> create(::Display* display, ::Window window);
  ~SharedImage();
  SharedImage(const SharedImage&) = delete;
  SharedImage& operator=(const SharedImage&) = delete;

  /// Makes room for so many pixels: whether there is memory for them. What was there is lost.
  bool fit(int width, int height);
  /// Row y counts from the top; pixels are 0xffrrggbb.
  std::uint32_t* row(int y) const;
  /// Shows columns [first, last) of all rows in the window, and waits until the server has read
  /// them.
  void show(int first, int last) const;

private:
  SharedImage(::Display* display, ::Window window, const XWindowAttributes& attributes);
  void release();

  ::Display* display_;
  ::Window window_;
  ::Visual* visual_;
  unsigned depth_;
  ::GC gc_;
  XShmSegmentInfo segment_{};
  XImage* image_ = nullptr;
};

} // namespace mote::app
