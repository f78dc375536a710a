#pragma once

class vtkRenderWindow;

namespace mote::app
{

/// Whether there is a display to open a window on. VTK itself ends the process where there is none.
bool displayAvailable();

/// What the user did to the window since the last call, while the program was busy and did not
/// handle events. Keys typed meanwhile are forgotten, so that they do not all act later.
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
