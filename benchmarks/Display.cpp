#include "Display.h"

#include <X11/Xlib.h>

namespace mote::bench
{

bool hasDisplay()
{
  Display* display = XOpenDisplay(nullptr);
  if (display != nullptr)
    XCloseDisplay(display);
  return display != nullptr;
}

} // namespace mote::bench
