#include "Framing.h"

#include "base/Failure.h"
#include "base/Text.h"

#include <vtkCamera.h>
#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace mote::app
{

namespace
{

constexpr double farthest = 1e18; ///< of what is drawn

struct Side
{
  const char* name;
  double direction[3]; // from the data to the camera
  double up[3];
};

constexpr Side sides[] = {
  {"iso", {0.61, -0.61, 0.5}, {0, 0, 1}},
  {"iso-y", {0.45, 0.35, 0.82}, {0, 1, 0}},
  {"+x", {1, 0, 0}, {0, 0, 1}},
  {"-x", {-1, 0, 0}, {0, 0, 1}},
  {"+y", {0, 1, 0}, {0, 0, 1}},
  {"-y", {0, -1, 0}, {0, 0, 1}},
  {"+z", {0, 0, 1}, {0, 1, 0}},
  {"-z", {0, 0, -1}, {0, 1, 0}},
};

/// The corners of the box along the camera's axes (right, up, towards the camera).
struct CornersInView
{
  double right[8], up[8], back[8];

  CornersInView(vtkCamera* camera, const double bounds[6], const double center[3])
  {
    double direction[3], upward[3], sideways[3];
    camera->GetDirectionOfProjection(direction);
    camera->OrthogonalizeViewUp();
    camera->GetViewUp(upward);
    vtkMath::Cross(direction, upward, sideways);
    for (int i = 0; i < 8; ++i)
    {
      const double corner[3] = {bounds[i & 1] - center[0], bounds[2 + ((i >> 1) & 1)] - center[1],
        bounds[4 + ((i >> 2) & 1)] - center[2]};
      right[i] = vtkMath::Dot(corner, sideways);
      up[i] = vtkMath::Dot(corner, upward);
      back[i] = -vtkMath::Dot(corner, direction);
    }
  }
};

/// Where the camera must be along one axis of the picture: the points lie between the planes
/// through the eye with tangents `low` and `high`. With s the eye's shift along that axis and d its
/// distance, a point (p, z) asks p - s <= high * (d - z) and s - p <= low * (d - z).
struct Fit
{
  double reachHigh = -1e300, reachLow = -1e300, high, low;

  Fit(const double* points, const double* back, double low_, double high_)
    : high(high_)
    , low(low_)
  {
    for (int i = 0; i < 8; ++i)
    {
      reachHigh = std::max(reachHigh, points[i] + high * back[i]);
      reachLow = std::max(reachLow, -points[i] + low * back[i]);
    }
  }
  double distance() const { return (reachHigh + reachLow) / (high + low); }
  /// The shift that leaves as much room on both sides.
  double shift(double distance) const
  {
    return 0.5 * ((reachHigh - high * distance) - (reachLow - low * distance));
  }
};

/// Throws Failure for bounds, `size` long, that no camera can look at: spheres are cast in float,
/// and the eye needs a place of its own beside the data.
void requireVisible(const double bounds[6], double size)
{
  const double lowest = *std::min_element(bounds, bounds + 6);
  const double highest = *std::max_element(bounds, bounds + 6);
  const double away = std::max(std::abs(lowest), std::abs(highest));
  if (!std::all_of(bounds, bounds + 6, [](double b) { return std::abs(b) <= farthest; }))
    throw Failure("positions with their radii reach from " + asNumber(lowest, 3) + " to " +
                  asNumber(highest, 3) + ", and what is drawn may reach to " + asNumber(farthest) +
                  "; choose other units or --radius");
  if (size < 1e-14 * away)
    throw Failure("the data lie at " + asNumber(away, 3) + " and are " + asNumber(size, 3) +
                  " long, too little for numbers that large to tell places apart; subtract an "
                  "offset from the coordinates");
}

} // namespace

const std::vector<std::string>& viewNames()
{
  static const std::vector<std::string> names = {
    "auto", "iso", "iso-y", "+x", "-x", "+y", "-y", "+z", "-z"};
  return names;
}

std::string automaticView(const double bounds[6])
{
  const double length[3] = {bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]};
  const double longest = *std::max_element(length, length + 3);
  const int thinnest = length[2] <= std::min(length[0], length[1]) ? 2
                       : length[1] <= length[0]                    ? 1
                                                                   : 0;
  static const char* const faces[] = {"+x", "-y", "+z"};
  return length[thinnest] < 0.04 * longest ? faces[thinnest] : "iso";
}

void lookFrom(vtkCamera* camera, const std::string& view)
{
  const auto side =
    std::find_if(std::begin(sides), std::end(sides), [&](const Side& s) { return view == s.name; });
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition((side == std::end(sides) ? sides : side)->direction);
  camera->SetViewUp((side == std::end(sides) ? sides : side)->up);
}

std::vector<double> cameraOf(vtkCamera* camera)
{
  std::vector<double> numbers(9);
  camera->GetPosition(numbers.data());
  camera->GetFocalPoint(numbers.data() + 3);
  // A camera makes what it is given of unit length, which may change the last digits of what had it
  // already. Without those, the same view keeps the same numbers however often it is set.
  constexpr double steps = 1e12;
  for (int axis = 0; axis < 3; ++axis)
    numbers[6 + axis] = std::round(camera->GetViewUp()[axis] * steps) / steps;
  numbers.push_back(
    camera->GetParallelProjection() ? camera->GetParallelScale() : camera->GetViewAngle());
  return numbers;
}

void setCamera(vtkCamera* camera, const std::vector<double>& numbers)
{
  camera->SetPosition(numbers.data());
  camera->SetFocalPoint(numbers.data() + 3);
  camera->SetViewUp(numbers.data() + 6);
  if (camera->GetParallelProjection())
    camera->SetParallelScale(numbers[9]);
  else
    camera->SetViewAngle(numbers[9]);
}

void moveAside(vtkCamera* camera, vtkCamera* from, const std::array<double, 3>& aside)
{
  camera->DeepCopy(from);
  double place[3];
  vtkMath::Add(from->GetPosition(), aside.data(), place);
  camera->SetPosition(place);
  vtkMath::Add(from->GetFocalPoint(), aside.data(), place);
  camera->SetFocalPoint(place);
}

std::vector<double> withParallelProjection(std::vector<double> camera)
{
  const double distance = std::sqrt(vtkMath::Distance2BetweenPoints(&camera[0], &camera[3]));
  camera[9] = distance * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera[9]));
  return camera;
}

std::vector<double> withPerspective(std::vector<double> camera)
{
  const double half = std::tan(0.5 * vtkMath::RadiansFromDegrees(usualViewAngle));
  const double distance = std::sqrt(vtkMath::Distance2BetweenPoints(&camera[0], &camera[3]));
  for (int i = 0; i < 3; ++i)
    camera[i] = camera[3 + i] + camera[9] / half / distance * (camera[i] - camera[3 + i]);
  camera[9] = usualViewAngle;
  return camera;
}

void frame(vtkCamera* camera, const double bounds[6], double aspect, const Margins& margins)
{
  double center[3], direction[3], upward[3], sideways[3];
  double size = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    center[i] = 0.5 * (bounds[2 * i] + bounds[2 * i + 1]);
    size = std::max(size, bounds[2 * i + 1] - bounds[2 * i]);
  }
  if (!(size > 0.0))
    size = 1.0;
  requireVisible(bounds, size);
  const CornersInView corners(camera, bounds, center);
  camera->GetDirectionOfProjection(direction);
  camera->GetViewUp(upward);
  vtkMath::Cross(direction, upward, sideways);

  double shift[2] = {0.0, 0.0};
  double distance = size;
  if (camera->GetParallelProjection())
  {
    const auto [left, right] = std::minmax_element(corners.right, corners.right + 8);
    const auto [bottom, top] = std::minmax_element(corners.up, corners.up + 8);
    const double width = (*right - *left) / (1.0 - margins.left - margins.right) / aspect;
    const double height = (*top - *bottom) / (1.0 - margins.bottom - margins.top);
    const double scale = std::max({0.5 * width, 0.5 * height, 1e-3 * size});
    camera->SetParallelScale(scale);
    shift[0] = 0.5 * (*left + *right) + scale * aspect * (margins.right - margins.left);
    shift[1] = 0.5 * (*bottom + *top) + scale * (margins.top - margins.bottom);
    distance = 3.0 * size;
  }
  else
  {
    const double tangent = std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
    const double across = tangent * aspect;
    const Fit x(corners.right, corners.back, across * (1.0 - 2.0 * margins.left),
      across * (1.0 - 2.0 * margins.right));
    const Fit y(corners.up, corners.back, tangent * (1.0 - 2.0 * margins.bottom),
      tangent * (1.0 - 2.0 * margins.top));
    distance = std::max({x.distance(), y.distance(), 0.55 * size});
    shift[0] = x.shift(distance);
    shift[1] = y.shift(distance);
  }
  double focus[3], position[3];
  for (int i = 0; i < 3; ++i)
  {
    focus[i] = center[i] + shift[0] * sideways[i] + shift[1] * upward[i];
    position[i] = focus[i] - distance * direction[i];
  }
  camera->SetFocalPoint(focus);
  camera->SetPosition(position);
}

} // namespace mote::app
