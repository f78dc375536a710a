#pragma once

#include "../core/Camera.h"
#include "HexRay.h"
#include "RayColor.h"
#include "WalkCells.h"

#include <atomic>
#include <memory>
#include <vector>

namespace mote
{

class HiddenCells;
class WalkTransfer;
class WalkView;
struct WalkTask;

/// What walks looked at.
struct WalkSteps
{
  std::uint64_t steps = 0;     ///< cells that rays passed
  std::uint64_t fallbacks = 0; ///< of which the exit was found by all crossings with the cell
  std::uint64_t seldom = 0;    ///< that were integrated by CellIntegral
};

/// Camera rays through a mesh from cell to cell: no tree is walked. See docs/hexahedra.md.
///
/// The signs of a cell's edges about a ray tell by which face the ray leaves; adjacency tells the
/// next cell, which sees the same signs. Rays enter by the faces of the mesh's boundary, and enter
/// again, in the order of depth, where they come out. Places are in float, counted from the mesh's
/// middle in units of its size. What a part of a ray in a cell looks like is integrated between the
/// scalar's values on the two faces, where a bound on its bend allows that to the tolerance, and by
/// CellIntegral where not.
class CellWalk
{
public:
  static constexpr int mostRays = 256; ///< that gather() takes at a time

  /// Tolerances below this one are not kept: numbers are float.
  static constexpr double leastTolerance = 1e-5;

  /// Whether this machine has the SIMD that it takes.
  static bool isSupported();

  /// For the rays of a camera in an image of so many pixels; `toLocal` takes the world to the mesh.
  /// `cells`, `field`, which the cells were made of, `settings`, and `lighting` and `hidden`, which
  /// may be null, must outlive this. Rays go through hidden cells and gather nothing there.
  CellWalk(const WalkCells& cells, const HexField& field, const CloudSettings& settings,
    const CloudLighting* lighting, const CameraRays& rays, const Mat4d& toLocal, int width,
    int height, const HiddenCells* hidden = nullptr);
  ~CellWalk();

  /// Where a ray of the camera runs: as its place in the image, in pixels.
  struct Place
  {
    double x = 0.0, y = 0.0;
  };
  /// The part of a ray from t = `from` to t = `to`.
  struct Part
  {
    Place place;
    double from = 0.0, to = 0.0;
  };

  /// Gathers colours of 1 to mostRays parts, and, where `runs` is not null, the runs of each.
  /// Places may lie up to 64 pixels beside the image. Any number of threads may ask.
  void gather(const Part* parts, int count, RayColor* colors, std::vector<RayRun>* runs) const;

  /// Of all that gather() did.
  WalkSteps counts() const;

private:
  class Seldom;
  struct Line;
  Line lineAt(const Place& place) const;
  int commonOrder(double left, double right, double lower, double upper) const;
  void addRay(WalkTask& task, const Part& part, int index) const;
  void takeAnswers(
    const WalkTask& task, const Part* parts, RayColor* colors, std::vector<RayRun>* runs) const;

  const WalkCells& cells_;
  const HexField& field_;
  const CloudSettings& settings_;
  const CloudLighting* lighting_;
  const HiddenCells* hidden_;
  std::unique_ptr<const WalkTransfer> transfer_;
  std::shared_ptr<const WalkView> view_;
  /// The camera's rays in the world, in the mesh, and as WalkCells has places.
  CameraRays world_, local_, own_;
  float rate_ = 0.0f;
  mutable std::atomic<std::uint64_t> steps_{0}, fallbacks_{0}, seldom_{0};
};

} // namespace mote
