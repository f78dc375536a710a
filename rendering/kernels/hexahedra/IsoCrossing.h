#pragma once

#include "CellSampler.h"
#include "HexRay.h"
#include "LineBundle.h"

#include <vector>

namespace mote
{

struct CubicPiece;

/// Where a ray first meets one of some iso-surfaces of a field.
struct IsoHit
{
  double t = 0.0;
  std::size_t surface = 0; ///< index among the iso-values
  std::uint32_t cell = 0;
};

/// Looks along a ray for the first place where a trilinear field takes one of some values. No
/// surface is missed between cells: the value at a face is the same to the last bit from both
/// sides, where these share their points. Cells with a NaN, and fields of cells, have no surfaces.
class IsoCrossing
{
public:
  /// Everything must outlive this. The values count from the field's offset.
  IsoCrossing(const HexMesh& mesh, const HexField& field, const std::vector<double>& values,
    const HexRay& ray);

  /// Takes the ray's next span. False where a surface was found.
  bool operator()(const CellSpan& span);
  bool operator()(const ValuedSpan& span);

  bool found() const { return found_; }
  const IsoHit& hit() const { return hit_; }

private:
  double valueAt(double t) { return cell_.trilinear(ray_.origin + t * ray_.direction); }
  bool isMet(double low, double high) const;
  bool enter(std::uint32_t cell);
  bool take(const CellSpan& span, double in, double out, double bend);
  bool search(double t0, double v0, double t1, double v1, double bend, int depth);
  bool searchPiece(const CubicPiece& piece, double t0, double v0, double t1, double v1);
  double refine(double value, double t0, double v0, double t1, double v1, double t);

  const std::vector<double>& values_;
  const HexRay& ray_;
  CrossingLine line_;
  CellSampler cell_;
  double range_ = 0.0; ///< of the cell's values
  bool found_ = false;
  IsoHit hit_;
};

} // namespace mote
