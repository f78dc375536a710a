#pragma once

class vtkRenderWindow;

namespace mote::app
{

/// Whether there is a display to open a window on. VTK itself ends the process where there is none.
bool displayAvailable();

/// How much larger texts should be than on a display of 96 dots an inch: what the resource Xft.dpi
/// says, or the screen's height.
double displayScale();

/// What the user asked for since the last call, while the program was busy and did not handle
/// events. Other keys stay where they are and act later.
enum class Request
{
  Nothing,
  Stop, ///< Escape
  Quit  ///< q, or the window was closed
};
Request takeRequest(vtkRenderWindow* window);

/// Whether a key or a mouse button waits to be handled.
bool inputWaits(vtkRenderWindow* window);

} // namespace mote::app
