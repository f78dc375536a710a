#include "Display.h"

#include <vtkRenderWindow.h>

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/keysym.h>

namespace mote::app
{

namespace
{

::Display* displayOf(vtkRenderWindow* window)
{
  return static_cast<::Display*>(window->GetGenericDisplayId());
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

Request takeRequest(vtkRenderWindow* window)
{
  ::Display* display = displayOf(window);
  Request request = Request::Nothing;
  XEvent event;
  while (display && XCheckTypedEvent(display, KeyPress, &event))
  {
    const KeySym key = XLookupKeysym(&event.xkey, 0);
    if (key == XK_q)
      request = Request::Quit;
    else if (key == XK_Escape && request == Request::Nothing)
      request = Request::Stop;
  }
  while (display && XCheckTypedEvent(display, ClientMessage, &event))
    if (static_cast<Atom>(event.xclient.data.l[0]) == XInternAtom(display, "WM_DELETE_WINDOW", 0))
      request = Request::Quit;
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
