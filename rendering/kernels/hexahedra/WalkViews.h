#pragma once

#include "../core/Camera.h"
#include "CellRuns.h"

#include <memory>
#include <mutex>
#include <vector>

namespace mote
{

class WalkCells;
class WalkView;

/// What walks through a mesh share, whatever the scalar: how cameras last saw its boundary, as the
/// samples of a picture and time steps over the same mesh see the same, and where its cells are.
class WalkViews
{
public:
  /// The mesh as these rays, in its coordinates, see it in an image of so many pixels; made where
  /// it is not among the last. All `cells` must be of the same mesh. Any number of threads may ask.
  std::shared_ptr<const WalkView> view(
    const WalkCells& cells, const CameraRays& rays, int width, int height);

  /// Where cells are, for single rays of other origins; found when it is first asked for.
  const CellRuns& runs(const HexMesh& mesh);
  /// Of what runs() keeps.
  std::size_t bytes() const;

private:
  struct Kept
  {
    CameraRays rays;
    int width, height;
    std::shared_ptr<const WalkView> view;
  };
  static constexpr std::size_t most = 2; ///< a picture that moves and one at rest

  std::shared_ptr<const WalkView> find(const CameraRays& rays, int width, int height);

  mutable std::mutex mutex_;
  std::unique_ptr<const CellRuns> runs_;
  std::vector<Kept> kept_; ///< the last one first
};

} // namespace mote
