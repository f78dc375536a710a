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

  /// For the rays of a camera, in the coordinates of the mesh, and an image of so many pixels.
  /// `cells`, `field`, which the cells were made of, `settings` and `lighting`, which may be null,
  /// must outlive this.
  CellWalk(const WalkCells& cells, const HexField& field, const CloudSettings& settings,
    const CloudLighting* lighting, const CameraRays& rays, int width, int height);
  ~CellWalk();

  /// A ray of the camera: through a place in the image, in pixels; what of it is wanted; and the
  /// length in the world of its direction.
  struct Ray
  {
    double x = 0.0, y = 0.0;
    HexRay ray;
    double speed = 1.0;
  };

  /// Gathers colours of 1 to mostRays rays, and, where `runs` is not null, the parts without a gap
  /// of each. Places may lie up to 64 pixels beside the image. Any number of threads may ask.
  void gather(const Ray* rays, int count, RayColor* colors, std::vector<RayRun>* runs) const;

  /// Of all that gather() did.
  WalkSteps counts() const;

private:
  class Seldom;
  double perDepth(const HexRay& ray, int axis) const;
  void addRay(WalkTask& task, const Ray& ray, int index) const;
  void takeAnswers(
    const WalkTask& task, const Ray* rays, RayColor* colors, std::vector<RayRun>* runs) const;

  const WalkCells& cells_;
  const HexField& field_;
  const CloudSettings& settings_;
  const CloudLighting* lighting_;
  std::unique_ptr<const WalkTransfer> transfer_;
  std::unique_ptr<const WalkView> view_;
  float rate_ = 0.0f;
  mutable std::atomic<std::uint64_t> steps_{0}, fallbacks_{0}, seldom_{0};
};

} // namespace mote
