#include "KeyFrames.h"

#include "base/Text.h"
#include "table/Row.h"

#include <vtkMath.h>
#include <vtkQuaternion.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace mote::app
{

namespace
{

/// A camera as numbers between which it moves as an eye would: what it looks at, the logarithm of
/// the distance, how it is turned as a quaternion, the logarithm of the angle or the height.
using Pose = std::array<double, 9>;

Pose poseOf(const std::vector<double>& camera)
{
  double back[3], up[3], right[3];
  for (int i = 0; i < 3; ++i)
    back[i] = camera[i] - camera[3 + i], up[i] = camera[6 + i];
  const double distance = vtkMath::Normalize(back);
  vtkMath::Cross(up, back, right);
  vtkMath::Normalize(right);
  vtkMath::Cross(back, right, up);
  double axes[3][3];
  for (int i = 0; i < 3; ++i)
    axes[i][0] = right[i], axes[i][1] = up[i], axes[i][2] = back[i];
  vtkQuaternion<double> turn;
  turn.FromMatrix3x3(axes);
  return {camera[3], camera[4], camera[5], std::log(distance), turn[0], turn[1], turn[2], turn[3],
    std::log(camera[9])};
}

std::vector<double> cameraOf(const Pose& pose)
{
  vtkQuaternion<double> turn(pose[4], pose[5], pose[6], pose[7]);
  turn.Normalize();
  double axes[3][3];
  turn.ToMatrix3x3(axes);
  const double distance = std::exp(pose[3]);
  std::vector<double> camera(10);
  for (int i = 0; i < 3; ++i)
  {
    camera[i] = pose[i] + distance * axes[i][2];
    camera[3 + i] = pose[i];
    camera[6 + i] = axes[i][1];
  }
  camera[9] = std::exp(pose[8]);
  return camera;
}

std::vector<Pose> posesOf(const std::vector<Settings>& keys)
{
  std::vector<Pose> poses;
  for (const Settings& key : keys)
  {
    Pose pose = poseOf(key.camera.camera);
    // Two quaternions stand for each turn: the nearer one goes the short way.
    double product = 0.0;
    for (int i = 4; i < 8 && !poses.empty(); ++i)
      product += pose[i] * poses.back()[i];
    for (int i = 4; i < 8 && product < 0.0; ++i)
      pose[i] = -pose[i];
    poses.push_back(pose);
  }
  return poses;
}

/// Of Catmull and Rom: through `b` and `c`, with the slopes that `a` and `d` give.
double onCurve(double a, double b, double c, double d, double t)
{
  return b +
         0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)));
}

double onLine(double a, double b, double t)
{
  return a + t * (b - a);
}

/// Sets a row of numbers to those between; it stays where they differ in kind.
void setBetween(const Row& row, const Settings& a, const Settings& b, double t, Settings& result)
{
  const std::vector<std::string> from = row.get(a), to = row.get(b);
  if (!row.numeric || from == to || from.size() != to.size())
    return;
  std::vector<std::string> words, whole;
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    double x = 0.0, y = 0.0;
    if (!parseNumber(from[i], x) || !parseNumber(to[i], y))
      return;
    const double value = onLine(x, y, t);
    words.push_back(exactText(value));
    whole.push_back(exactText(std::round(value)));
  }
  for (const auto& wanted : {words, whole}) // those of counts are whole
    try
    {
      return row.set(result, wanted);
    }
    catch (const WrongValue&)
    {
    }
}

/// Ranges of the same values, points of the same curve, and backgrounds.
void setListsBetween(const Settings& a, const Settings& b, double t, Settings& result)
{
  const auto& ranges = b.selection.ranges;
  for (std::size_t i = 0; i < std::min(ranges.size(), a.selection.ranges.size()); ++i)
  {
    ShowRange& range = result.selection.ranges[i];
    if (range.name != ranges[i].name || range.intervals.size() != ranges[i].intervals.size())
      continue;
    for (std::size_t k = 0; k < range.intervals.size(); ++k)
      for (const auto end : {&Interval::low, &Interval::high})
        if (const double to = ranges[i].intervals[k].*end; std::isfinite(to))
          if (double& from = range.intervals[k].*end; std::isfinite(from))
            from = onLine(from, to, t);
  }
  const auto& points = b.volume.opacity;
  const auto isAlike = [](const OpacityPoint& p, const OpacityPoint& q)
  { return p.isShare == q.isShare; };
  if (std::equal(
        points.begin(), points.end(), a.volume.opacity.begin(), a.volume.opacity.end(), isAlike))
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      OpacityPoint& point = result.volume.opacity[i];
      point.value = onLine(point.value, points[i].value, t);
      point.opacity = onLine(point.opacity, points[i].opacity, t);
    }
  const auto& colors = b.picture.background;
  if (colors.size() == a.picture.background.size())
    for (std::size_t i = 0; i < colors.size(); ++i)
      for (int c = 0; c < 3; ++c)
        result.picture.background[i][c] = onLine(result.picture.background[i][c], colors[i][c], t);
}

} // namespace

Settings between(const std::vector<Settings>& keys, double share)
{
  const auto last = static_cast<int>(keys.size()) - 1;
  if (last == 0)
    return keys.front();
  const double place = std::clamp(share, 0.0, 1.0) * last;
  const int first = std::min(static_cast<int>(place), last - 1);
  const double t = place - first;
  const Settings &a = keys[first], &b = keys[first + 1];
  if (t == 0.0 || t == 1.0)
    return t == 0.0 ? a : b;
  Settings result = a;
  for (const Row& row : settingsTable())
    if (row.name != "camera" && row.name != "size" && row.name != "threads" && row.name != "time" &&
        row.name != "step" && row.name != "types")
      setBetween(row, a, b, t, result);
  setListsBetween(a, b, t, result);
  const std::vector<Pose> poses = posesOf(keys);
  const auto at = [&](int i, std::size_t k)
  {
    // Beyond the ends the curve goes on straight.
    if (i < 0)
      return 2.0 * poses[0][k] - poses[1][k];
    return i > last ? 2.0 * poses[last][k] - poses[last - 1][k] : poses[i][k];
  };
  Pose pose;
  for (std::size_t k = 0; k < pose.size(); ++k)
    pose[k] = onCurve(at(first - 1, k), at(first, k), at(first + 1, k), at(first + 2, k), t);
  result.camera.camera = cameraOf(pose);
  return result;
}

} // namespace mote::app
