#pragma once

#include <kernels/core/Box.h>
#include <kernels/core/Camera.h>

#include <string>
#include <vector>

namespace mote::bench
{

/// Where the eye stands that looks at the middle of the data.
struct View
{
  std::string name;
  std::string summary;
  Vec3d eye; ///< from the middle, in lengths of the longest side of the bounds
};

/// All of them.
const std::vector<View>& views();

/// Those of these names, or all where there is no name.
std::vector<View> viewsNamed(const std::vector<std::string>& names);

Camera cameraOf(const View& view, const Box& bounds);

} // namespace mote::bench
