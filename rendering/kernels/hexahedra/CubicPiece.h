#pragma once

namespace mote
{

/// A value along a piece of a ray: p[0] + p[1] x + p[2] x^2 + p[3] x^3 for x in [0, 1].
struct CubicPiece
{
  double p[4] = {0.0, 0.0, 0.0, 0.0};

  double operator()(double x) const { return p[0] + x * (p[1] + x * (p[2] + x * p[3])); }
  double slope(double x) const { return p[1] + x * (2.0 * p[2] + x * 3.0 * p[3]); }

  static CubicPiece line(double at0, double at1) { return {{at0, at1 - at0, 0.0, 0.0}}; }
  /// Through the values at 0, 1/4, 3/4 and 1.
  static CubicPiece through(double at0, double at14, double at34, double at1);
  /// The places within (0, 1) where it turns, in order; answers how many.
  int turns(double (&x)[2]) const;
};

/// The root of piece - value in [from, to], where the piece is monotonic; the end that is nearer to
/// one where there is none.
double rootIn(const CubicPiece& piece, double value, double from, double to);

} // namespace mote
