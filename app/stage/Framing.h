#pragma once

#include "settings/Settings.h"

#include <array>
#include <string>
#include <vector>

class vtkCamera;
class vtkRenderer;

namespace mote::app
{

/// auto, iso, iso-y, +x, -x, +y, -y, +z, -z.
const std::vector<std::string>& viewNames();

/// Shares of the picture's width and height that data should leave free on each side.
struct Margins
{
  double left = 0.03, right = 0.03, bottom = 0.03, top = 0.03;
};

/// The side that "auto" stands for: where positions with these bounds are flat, the one that shows
/// their face, else iso.
std::string automaticView(const double bounds[6]);

/// Turns the camera to look from a side of viewNames(), other than auto.
void lookFrom(vtkCamera* camera, const std::string& view);

/// Degrees, of cameras that no one has set.
constexpr double usualViewAngle = 30.0;

/// The camera as CameraSettings::camera has it, and the other way.
std::vector<double> cameraOf(vtkCamera* camera);
void setCamera(vtkCamera* camera, const std::vector<double>& numbers);

/// Makes a camera that of another one, moved aside.
void moveAside(vtkCamera* camera, vtkCamera* from, const std::array<double, 3>& aside);

/// The camera of the other projection, in which things at the focal point are as large.
std::vector<double> withParallelProjection(std::vector<double> camera);
std::vector<double> withPerspective(std::vector<double> camera);

/// Moves the camera, without turning it, so that the box of the bounds just fits into a picture of
/// this aspect (width to height) within the margins. Bounds without volume are fine. Throws Failure
/// for those that reach too far, or lie so far away that double precision does not tell their ends
/// apart.
void frame(vtkCamera* camera, const double bounds[6], double aspect, const Margins& margins);

} // namespace mote::app
