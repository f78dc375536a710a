#pragma once

#include "Cuts.h"
#include "settings/Settings.h"

#include <array>
#include <optional>
#include <vector>

namespace mote::app
{

/// A ray in the world; its direction has any length but 0. `up` is what is up in the view, of unit
/// length and across the ray; 0 where nobody asks.
struct GripRay
{
  std::array<double, 3> origin, direction, up{};
};

/// A slice, or an end of a cut, that is held at a place where it is seen, to be moved.
class CutGrip
{
public:
  /// What lies at a place in the world, by the settings that are shown: an end of a cut before all
  /// slices. `size` is that of the data. None where nothing does, and on what is rolled out.
  static std::optional<CutGrip> at(
    const Settings& shown, const std::array<double, 3>& place, double size);

  /// That of a name which lies there, held at a place on it.
  static std::optional<CutGrip> of(const Settings& shown, const std::string& name, double value,
    const std::array<double, 3>& place);

  /// Where it lies when it is moved to where the ray comes nearest to the way that the place goes,
  /// within the bounds of what is cut. Where one looks along that way as it is taken hold of, it
  /// goes away from the viewer as the ray goes up, as far; none without `up`.
  std::optional<double> valueAt(const GripRay& ray, const double bounds[6]);

  /// The settings with it there; `shown` are those that are shown now.
  Settings moved(Settings settings, const Settings& shown, double value) const;

  bool isAngle() const { return kind_.of == CutKind::Angle; }
  /// "slice z", "cut r"
  std::string name() const { return (isSlice_ ? "slice " : "cut ") + cut_; }

private:
  template <typename IsMeant>
  static std::optional<CutGrip> find(
    const Settings& shown, const std::array<double, 3>& place, const IsMeant& isMeant);

  bool isSlice_ = false, isHigh_ = false; ///< the upper end of a cut
  std::string cut_;
  std::size_t number_ = 0; ///< among the slices of that name
  CutKind kind_;
  CutAxis axis_;
  std::array<double, 3> place_{}, way_{}; ///< of unit length, where the coordinate grows
  double value_ = 0.0, perLength_ = 1.0;  ///< of the coordinate
  std::optional<bool> isAlong_;           ///< one looked along the way; by the first ray
};

} // namespace mote::app
