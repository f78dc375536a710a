#include "IsoCrossing.h"

#include "CubicPiece.h"

#include <algorithm>
#include <cmath>

namespace mote
{

namespace
{

/// How exactly a cubic must tell a cell's values, as a share of their range: surfaces that are met
/// twice within a cell are missed where they are thinner.
constexpr double exactness = 1e-4;

} // namespace

IsoCrossing::IsoCrossing(
  const HexMesh& mesh, const HexField& field, const std::vector<double>& values, const HexRay& ray)
  : values_(values)
  , ray_(ray)
  , line_(ray.origin, ray.direction)
  , cell_(mesh, field)
{
}

bool IsoCrossing::isMet(double low, double high) const
{
  return std::any_of(
    values_.begin(), values_.end(), [&](double v) { return v >= low && v <= high; });
}

/// Goes to a cell. False where it has no surface.
bool IsoCrossing::enter(std::uint32_t cell)
{
  cell_.enter(cell);
  if (cell_.isNaN() || cell_.isConstant())
    return false;
  const auto [low, high] = std::minmax_element(cell_.values().begin(), cell_.values().end());
  range_ = *high - *low;
  return isMet(*low, *high);
}

bool IsoCrossing::operator()(const CellSpan& span)
{
  return !enter(span.cell) ||
         take(span, cell_.entry(line_, span, ray_), cell_.exit(line_, span, ray_),
           bendOf(cell_.mesh().corners(span.cell), cell_.values()));
}

bool IsoCrossing::operator()(const ValuedSpan& valued)
{
  const CellSpan& span = valued.span;
  const bool isIn = span.inFace != noFace, isOut = span.outFace != noFace;
  // Most that a ray meets is told from the ends alone.
  if (isIn && isOut &&
      !isMet(std::min(valued.valueIn, valued.valueOut) - valued.bend,
        std::max(valued.valueIn, valued.valueOut) + valued.bend))
    return true;
  if (!enter(span.cell))
    return true;
  return take(span, isIn ? valued.valueIn : cell_.entry(line_, span, ray_),
    isOut ? valued.valueOut : cell_.exit(line_, span, ray_), valued.bend);
}

bool IsoCrossing::take(const CellSpan& span, double in, double out, double bend)
{
  found_ = search(span.tIn, in, span.tOut, out, bend, 0);
  if (found_)
    hit_.cell = span.cell;
  return !found_;
}

/// `bend` is how far the field may be from the line between the ends.
bool IsoCrossing::search(double t0, double v0, double t1, double v1, double bend, int depth)
{
  if (!isMet(std::min(v0, v1) - bend, std::max(v0, v1) + bend))
    return false;
  if (bend <= exactness * range_)
    return searchPiece(CubicPiece::line(v0, v1), t0, v0, t1, v1);
  const auto at = [&](double x) { return t0 + x * (t1 - t0); };
  const CubicPiece cubic = CubicPiece::through(v0, valueAt(at(0.25)), valueAt(at(0.75)), v1);
  const double middle = valueAt(at(0.5));
  if (depth < 8 && !(std::abs(cubic(0.5) - middle) <= exactness * range_))
    return search(t0, v0, at(0.5), middle, 0.25 * bend, depth + 1) ||
           search(at(0.5), middle, t1, v1, 0.25 * bend, depth + 1);
  return searchPiece(cubic, t0, v0, t1, v1);
}

bool IsoCrossing::searchPiece(const CubicPiece& piece, double t0, double v0, double t1, double v1)
{
  const auto at = [&](double x) { return t0 + x * (t1 - t0); };
  double turns[2];
  const int count = piece.turns(turns);
  double from = 0.0;
  for (int part = 0; part <= count; ++part)
  {
    const double to = part < count ? turns[part] : 1.0;
    // The ends have their own values, not the cubic's: a sign is the same in two cells.
    const double atFrom = from == 0.0 ? v0 : piece(from), atTo = to == 1.0 ? v1 : piece(to);
    double first = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < values_.size(); ++i)
    {
      const double value = values_[i];
      if ((atFrom < value) == (atTo < value))
        continue;
      const double t =
        refine(value, at(from), atFrom, at(to), atTo, at(rootIn(piece, value, from, to)));
      if (t < first)
      {
        first = hit_.t = t;
        hit_.surface = i;
      }
    }
    if (first < std::numeric_limits<double>::infinity())
      return true;
    from = to;
  }
  return false;
}

/// The place between t0 and t1, where the field is on different sides of the value, from a guess:
/// by the rule of false position, after Illinois.
double IsoCrossing::refine(double value, double t0, double v0, double t1, double v1, double t)
{
  double f0 = v0 - value, f1 = v1 - value;
  const double enough = 1e-12 * range_;
  for (int i = 0; i < 24; ++i)
  {
    const double f = valueAt(t) - value;
    if (std::abs(f) <= enough)
      return t;
    if ((f < 0.0) == (f0 < 0.0))
    {
      t0 = t;
      f0 = f;
      f1 *= i > 0 ? 0.5 : 1.0;
    }
    else
    {
      t1 = t;
      f1 = f;
      f0 *= i > 0 ? 0.5 : 1.0;
    }
    const double next = f1 != f0 ? t0 + (t1 - t0) * (f0 / (f0 - f1)) : 0.5 * (t0 + t1);
    if (!(t1 - t0 > 1e-15 * std::abs(t0)))
      break;
    t = next > t0 && next < t1 ? next : 0.5 * (t0 + t1);
  }
  return t;
}

} // namespace mote
