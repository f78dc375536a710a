#pragma once

#include "../core/Camera.h"

#include <memory>
#include <mutex>
#include <vector>

namespace mote
{

class WalkCells;
class WalkView;

/// How cameras last saw the boundary of a mesh, for walks to come: the samples of a picture see the
/// same, and so do time steps over the same mesh.
class WalkViews
{
public:
  /// The mesh as these rays, in its coordinates, see it in an image of so many pixels; made where
  /// it is not among the last. All `cells` must be of the same mesh. Any number of threads may ask.
  std::shared_ptr<const WalkView> view(
    const WalkCells& cells, const CameraRays& rays, int width, int height);

private:
  struct Kept
  {
    CameraRays rays;
    int width, height;
    std::shared_ptr<const WalkView> view;
  };
  static constexpr std::size_t most = 2; ///< a picture that moves and one at rest

  std::shared_ptr<const WalkView> find(const CameraRays& rays, int width, int height);

  std::mutex mutex_;
  std::vector<Kept> kept_; ///< the last one first
};

} // namespace mote
