#pragma once

#include "VTKTestSupport.h"

#include "vtkMoteRayCastPass.h"
#include "vtkRenderWindow.h"

#include <cstdint>

class vtkPolyDataMapper;

/// What the tests that draw share. They need a display.
namespace mote::testing
{

/// What a window shows: RGB bytes and depth values, row 0 at the bottom.
struct Shot
{
  int width = 0, height = 0;
  std::vector<unsigned char> color;
  std::vector<float> depth;

  const unsigned char* at(int x, int y) const { return &color[3 * (y * width + x)]; }
  float depthAt(int x, int y) const { return depth[y * width + x]; }
};

/// Reads the window without drawing it again.
Shot read(vtkRenderWindow* window);
/// Draws the window, then reads it.
Shot shoot(vtkRenderWindow* window);

/// Pixels that differ by more than `tolerance` of 255 in any channel.
int differentPixels(const Shot& a, const Shot& b, int tolerance = 2);

/// A window off the screen with one renderer, black, with one light from the side, whose camera
/// sees [-1.5, 1.5]^2.
struct Drawing
{
  explicit Drawing(int width = 160, int height = 120, bool withPass = true);

  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkMoteRayCastPass> pass;

  vtkCamera* camera() const;
  /// Adds what Mote draws.
  vtkSmartPointer<vtkActor> addParticles(const std::vector<Ball>& balls, const Point& color);
  /// Adds the same balls as triangles, `resolution` of them around.
  vtkSmartPointer<vtkActor> addTriangles(
    const std::vector<Ball>& balls, const Point& color, int resolution = 96);
  Shot shoot() { return mote::testing::shoot(window); }
};

/// A camera that sees [-1.5, 1.5]^2 at the origin from (0, 0, 10).
void placeCamera(vtkCamera* camera);

/// Paints an actor evenly, so that pixels tell which prop they show.
void paint(vtkActor* actor, const Point& color);

} // namespace mote::testing
