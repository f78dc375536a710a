#include "Views.h"

#include <algorithm>

namespace mote::bench
{

const std::vector<View>& views()
{
  static const std::vector<View> all = {
    {"far", "eye at (1.1, 0.7, 1.5) sides from the middle: all of the data in sight",
      {1.1, 0.7, 1.5}},
    {"near", "eye at (0.65, 0.3, 0.7) sides from the middle", {0.65, 0.3, 0.7}}};
  return all;
}

std::vector<View> viewsNamed(const std::vector<std::string>& names)
{
  std::vector<View> chosen;
  for (const View& view : views())
    if (names.empty() || std::find(names.begin(), names.end(), view.name) != names.end())
      chosen.push_back(view);
  return chosen;
}

Camera cameraOf(const View& view, const Box& bounds)
{
  const Vec3d size = bounds.size();
  Camera camera;
  camera.position = bounds.center() + view.eye * std::max({size.x, size.y, size.z});
  camera.forward = bounds.center() - camera.position;
  camera.up = Vec3d(0.0, 1.0, 0.0);
  camera.viewAngle = 35.0;
  return camera;
}

} // namespace mote::bench
