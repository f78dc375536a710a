#pragma once

#include "CellSampler.h"
#include "CubicPiece.h"
#include "HexRay.h"
#include "LineBundle.h"
#include "RayColor.h"

namespace mote
{

/// Gathers a ray's colour cell by cell, between the exact places of entry and exit. Along a ray the
/// scalar of a cell is a cubic where the cell is a parallelepiped, and nearly so elsewhere: it is
/// taken as a line or a cubic where that changes the picture by less than the tolerance, and halved
/// where not. The pieces are split at the transfer function's knots and integrated by Simpson's
/// rule, corrected for what hides itself, or where that is not enough by Gauss' (the collocation of
/// order 6), as smooth as they then are.
class CellIntegral
{
public:
  /// Everything must outlive this; `lighting` may be null. `speed` is the length in the world of
  /// the ray's direction.
  CellIntegral(const HexMesh& mesh, const HexField& field, const CloudSettings& settings,
    const CloudLighting* lighting, const HexRay& ray, double speed, RayGatherer& gatherer);

  /// Takes the ray's next span. False where nothing behind it can be seen.
  bool operator()(const CellSpan& span) { return take(span, nullptr); }
  bool operator()(const ValuedSpan& span) { return take(span.span, &span); }
  /// To be called behind the last span.
  void finish() { gatherer_.end(); }

private:
  /// Colours are multiplied and added to by the light at a piece's middle.
  struct Light
  {
    bool isOn = false;
    Vec3d times{1.0}, plus{0.0};
  };

  bool take(const CellSpan& span, const ValuedSpan* values);
  double valueAt(double t) { return cell_.trilinear(ray_.origin + t * ray_.direction); }
  void integrate(double t0, double v0, double t1, double v1, double bend, int depth);
  double ownBend() const;
  void light(double t, Light& light);
  void addCubic(const CubicPiece& piece, double length);
  void addMonotonic(const CubicPiece& piece, double from, double to, double length);
  void addPiece(
    const CubicPiece& piece, std::size_t knots, double from, double to, double length, int depth);
  bool addBySimpson(const CubicPiece& piece, std::size_t knots, double from, double to, double h,
    const TransferTable::Sample& a, const TransferTable::Sample& b);
  void addByGauss(const CubicPiece& piece, std::size_t knots, double from, double to, double h);
  TransferTable::Sample look(std::size_t knots, double value) const;

  const CloudSettings& settings_;
  const CloudLighting* lighting_; ///< none: colours are seen as they are
  const HexRay& ray_;
  CrossingLine line_;
  double speed_;
  RayGatherer& gatherer_;
  CellSampler cell_;
  double end_;                       ///< of the last span
  double lower_ = 0.0, upper_ = 0.0; ///< of the cell's values
  Light light_;
};

} // namespace mote
