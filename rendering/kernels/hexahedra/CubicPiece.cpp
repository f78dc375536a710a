#include "CubicPiece.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mote
{

CubicPiece CubicPiece::through(double at0, double at14, double at34, double at1)
{
  // Divided differences at 0, 1, 1/4, 3/4.
  const double slope = at1 - at0;
  const double a = (at14 - at0 - 0.25 * slope) / (0.25 * -0.75);
  const double b = (at34 - at0 - 0.75 * slope) / (0.75 * -0.25);
  const double cubic = (b - a) * 2.0, square = a - 0.25 * cubic;
  // at0 + slope x + (square + cubic x) x (x - 1)
  return {{at0, slope - square, square - cubic, cubic}};
}

int CubicPiece::turns(double (&x)[2]) const
{
  // p1 + 2 p2 x + 3 p3 x^2 = 0, the larger root first.
  const double a = 3.0 * p[3], b = p[2], c = p[1];
  const double discriminant = b * b - a * c;
  if (!(discriminant > 0.0))
    return 0;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  int count = 0;
  const auto add = [&](double root)
  {
    if (root > 0.0 && root < 1.0)
      x[count++] = root;
  };
  if (a != 0.0)
    add(q / a);
  if (q != 0.0)
    add(c / q);
  if (count == 2 && x[1] < x[0])
    std::swap(x[0], x[1]);
  return count;
}

double rootIn(const CubicPiece& piece, double value, double from, double to)
{
  const double atFrom = piece(from) - value, atTo = piece(to) - value;
  const bool rises = atTo > atFrom;
  // Where an end is a root, rounding may put it on the wrong side.
  if (rises ? atFrom >= 0.0 : atFrom <= 0.0)
    return from;
  if (rises ? atTo <= 0.0 : atTo >= 0.0)
    return to;
  double x = from + (to - from) * std::clamp(atFrom / (atFrom - atTo), 0.0, 1.0);
  // Newton's method, kept between the ends.
  for (int i = 0; i < 60; ++i)
  {
    const double off = piece(x) - value;
    (off < 0.0) == rises ? from = x : to = x;
    if (off == 0.0)
      return x;
    const double slope = piece.slope(x);
    double next = slope != 0.0 ? x - off / slope : from;
    if (!(next > from && next < to))
      next = 0.5 * (from + to);
    if (std::abs(next - x) < 1e-14 || !(to - from > 1e-15))
      return next;
    x = next;
  }
  return x;
}

} // namespace mote
