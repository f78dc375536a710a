#pragma once

#include "../scene/Scene.h"

#include <limits>
#include <optional>
#include <vector>

namespace mote
{

/// The cell of a cloud that keeps back more of a ray's light than any other.
struct CloudPick
{
  std::int32_t object = 0; ///< CloudObject::id
  std::uint64_t cell = 0;  ///< of the input
  double value = 0.0;      ///< of the scalar at `position`; NaN where it has none
  double t = 0.0;          ///< in lengths of the direction given
  Vec3d position{0.0};     ///< the most opaque place of the ray in that cell
  double opacity = 0.0;    ///< of all clouds along the ray, in (0, 1]
};

/// Looks along rays through the scene's clouds; surfaces are not looked at.
class CloudPicker
{
public:
  /// The scene must outlive this.
  explicit CloudPicker(const Scene& scene);

  /// What is wanted of a ray.
  enum class Wanted
  {
    All,
    Cell ///< `opacity` may be any that is above a half where that of the whole ray is
  };
  /// Looks along one ray, from tMin to tMax. `direction` may have any length but 0. None where the
  /// clouds let all light through. Any number of threads may ask.
  std::optional<CloudPick> pick(const Vec3d& origin, const Vec3d& direction, double tMin,
    double tMax, Wanted wanted = Wanted::All) const;

private:
  struct Look
  {
    const CloudObject* cloud;
    Mat4d toLocal;
    TransferTable transfer;
  };
  std::vector<Look> looks_;
};

/// One ray of a CloudPicker.
std::optional<CloudPick> pickCloud(const Scene& scene, const Vec3d& origin, const Vec3d& direction,
  double tMin = 0.0, double tMax = std::numeric_limits<double>::infinity());

} // namespace mote
