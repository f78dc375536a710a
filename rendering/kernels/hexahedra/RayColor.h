#pragma once

#include "../core/Vec.h"
#include "../shading/TransferFunction.h"

#include <cmath>
#include <functional>
#include <vector>

namespace mote
{

/// Colour that a ray has gathered, front to back: premultiplied, and what still comes through.
struct RayColor
{
  Vec3d color{0.0};
  double transmittance = 1.0;

  /// Goes `length` world units through what looks like this all the way.
  void add(const TransferTable::Sample& sample, double length)
  {
    if (!(sample.extinction > 0.0))
      return;
    const double opacity = -std::expm1(-sample.extinction * length);
    color += transmittance * opacity * sample.color;
    transmittance *= 1.0 - opacity;
  }
  /// Goes on behind what has been gathered.
  void add(const RayColor& behind)
  {
    color += transmittance * behind.color;
    transmittance *= behind.transmittance;
  }
};

/// A part of a ray without a gap, and what it looks like.
struct RayRun
{
  double tIn = 0.0;
  RayColor color;
};

/// Light on a cloud: what a colour becomes at a point with a gradient, seen along a direction, all
/// three in the coordinates of the mesh. Linear in the colour.
using CloudLighting = std::function<Vec3d(
  const Vec3d& color, const Vec3d& point, const Vec3d& gradient, const Vec3d& direction)>;

/// What is integrated along rays, and how.
struct CloudSettings
{
  TransferTable transfer;          ///< of values as the field keeps them
  double step = 1.0;               ///< world units between even samples
  double phase = 0.0;              ///< of the samples, in steps
  double tolerance = 1e-3;         ///< of integration cell by cell
  double size = 1.0;               ///< of the mesh, in world units
  double leastTransmittance = 0.0; ///< rays end where not more comes through
};

/// What a ray has gathered, all in all and in parts.
///
/// Where several volumes are to be put one behind another, parts are needed; else they are not
/// kept.
class RayGatherer
{
public:
  explicit RayGatherer(std::vector<RayRun>* runs)
    : runs_(runs)
  {
  }

  RayColor& color() { return now_; }
  double transmittance() const { return before_.transmittance * now_.transmittance; }
  /// Begins a part.
  void begin(double tIn)
  {
    end();
    tIn_ = tIn;
  }
  /// Ends the last part.
  void end()
  {
    if (runs_ != nullptr && now_.transmittance < 1.0)
      runs_->push_back({tIn_, now_});
    before_.add(now_);
    now_ = {};
  }
  /// All of it, after end().
  const RayColor& total() const { return before_; }

private:
  std::vector<RayRun>* runs_;
  RayColor before_, now_;
  double tIn_ = 0.0;
};

} // namespace mote
