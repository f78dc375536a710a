#include "Display.h"

#include <vtkRenderWindow.h>

#include <X11/Xlib.h>
#include <X11/keysym.h>

#include <algorithm>
#include <cstdlib>

namespace mote::app
{

namespace
{

::Display* displayOf(vtkRenderWindow* window)
{
  return static_cast<::Display*>(window->GetGenericDisplayId());
}

/// What takeRequest() takes out of the queue. Looked up beforehand: a predicate may not call Xlib.
struct Requests
{
  unsigned int escape, quit;
  Atom close;
};

Bool isRequest(::Display*, XEvent* event, XPointer arg)
{
  const auto& requests = *reinterpret_cast<const Requests*>(arg);
  if (event->type == KeyPress)
    return event->xkey.keycode == requests.escape || event->xkey.keycode == requests.quit;
  return event->type == ClientMessage &&
         static_cast<Atom>(event->xclient.data.l[0]) == requests.close;
}

/// Notes presses in `arg` (a bool) and leaves all events in the queue.
Bool notePress(::Display*, XEvent* event, XPointer arg)
{
  if (event->type == KeyPress || event->type == ButtonPress)
    *reinterpret_cast<bool*>(arg) = true;
  return 0;
}

} // namespace

bool displayAvailable()
{
  ::Display* display = XOpenDisplay(nullptr);
  if (display)
    XCloseDisplay(display);
  return display != nullptr;
}

double displayScale()
{
  ::Display* display = XOpenDisplay(nullptr);
  if (!display)
    return 1.0;
  const char* text = XGetDefault(display, "Xft", "dpi");
  const double dots = text ? std::atof(text) : 0.0;
  const int height = DisplayHeight(display, DefaultScreen(display));
  XCloseDisplay(display);
  // Displays that do not tell are taken for as large as others: more lines are finer ones.
  const double scale = dots > 0.0 ? dots / 96.0 : height / 1080.0;
  return std::clamp(scale, 1.0, 4.0);
}

Request takeRequest(vtkRenderWindow* window)
{
  ::Display* display = displayOf(window);
  Request request = Request::Nothing;
  if (!display)
    return request;
  Requests requests{XKeysymToKeycode(display, XK_Escape), XKeysymToKeycode(display, XK_q),
    XInternAtom(display, "WM_DELETE_WINDOW", 0)};
  XEvent event;
  while (XCheckIfEvent(display, &event, isRequest, reinterpret_cast<XPointer>(&requests)))
  {
    const bool escape = event.type == KeyPress && event.xkey.keycode == requests.escape;
    if (!escape)
      request = Request::Quit;
    else if (request == Request::Nothing)
      request = Request::Stop;
  }
  return request;
}

bool inputWaits(vtkRenderWindow* window)
{
  bool waits = false;
  XEvent event;
  if (::Display* display = displayOf(window))
    XCheckIfEvent(display, &event, notePress, reinterpret_cast<XPointer>(&waits));
  return waits;
}

} // namespace mote::app
