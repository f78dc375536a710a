#include "TrilinearCell.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote
{

namespace
{

using Coefficients = std::array<Vec3d, 8>;

Coefficients coefficientsOf(const HexCorners& corners, const Vec3d& origin)
{
  std::array<Vec3d, 8> p;
  for (std::size_t i = 0; i < 8; ++i)
    p[i] = corners[i] - origin;
  return {p[0], p[1] - p[0], p[3] - p[0], p[4] - p[0], (p[2] - p[3]) - (p[1] - p[0]),
    (p[7] - p[4]) - (p[3] - p[0]), (p[5] - p[1]) - (p[4] - p[0]),
    ((p[6] - p[7]) - (p[5] - p[4])) - ((p[2] - p[3]) - (p[1] - p[0]))};
}

Mat3d jacobianOf(const Coefficients& c, const Vec3d& x)
{
  return {c[1] + x.y * c[4] + x.z * (c[6] + x.y * c[7]),
    c[2] + x.x * c[4] + x.z * (c[5] + x.x * c[7]), c[3] + x.y * c[5] + x.x * (c[6] + x.y * c[7])};
}

double determinantOf(const Mat3d& m)
{
  return glm::dot(m[0], glm::cross(m[1], m[2]));
}

/// Solves m x = b by Cramer's rule, given the determinant.
Vec3d solve(const Mat3d& m, const Vec3d& b, double determinant)
{
  const Vec3d yz = glm::cross(m[1], m[2]);
  return Vec3d(glm::dot(b, yz), glm::dot(b, glm::cross(m[2], m[0])),
           glm::dot(b, glm::cross(m[0], m[1]))) /
         determinant;
}

double largest(const Vec3d& v)
{
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Whether the determinant says anything, in view of the columns' lengths.
bool isRegular(const Mat3d& m, double determinant)
{
  const double size = glm::dot(m[0], m[0]) * glm::dot(m[1], m[1]) * glm::dot(m[2], m[2]);
  return determinant * determinant > 1e-28 * size && size > 0.0;
}

constexpr double converged = 1e-11;
constexpr int newtonSteps = 16;
constexpr int searchSteps = 60;

} // namespace

TrilinearCell::TrilinearCell(const HexCorners& corners)
  : corners_(corners)
  , origin_(cellCenter(corners))
  , c_(coefficientsOf(corners, origin_))
{
}

Vec3d TrilinearCell::local(const Vec3d& x) const
{
  return c_[0] + x.x * (c_[1] + x.y * c_[4]) + x.y * (c_[2] + x.z * c_[5]) +
         x.z * (c_[3] + x.x * (c_[6] + x.y * c_[7]));
}

Mat3d TrilinearCell::jacobian(const Vec3d& rst) const
{
  return jacobianOf(c_, rst);
}

/// Until it has converged, or isEnough(length of the last step).
template <typename IsEnough>
bool TrilinearCell::newton(const Vec3d& target, Vec3d& rst, const IsEnough& isEnough) const
{
  double last = 0.0;
  for (int i = 0; i < newtonSteps; ++i)
  {
    const Mat3d j = jacobian(rst);
    const double determinant = determinantOf(j);
    if (!isRegular(j, determinant))
      return false;
    Vec3d step = solve(j, target - local(rst), determinant);
    const double size = largest(step);
    if (!(size < 1e6))
      return false;
    // Long steps leave the region where the cell's shape means anything.
    if (size > 1.0)
      step /= size;
    rst += step;
    // The error after a step is about the square of the step, times what the last two steps tell.
    if (size < 1e-7 || size < converged * largest(rst) ||
        (size < 1e-3 && size * size * size < 1e-14 * last * last) || isEnough(size))
      return true;
    last = size;
  }
  return false;
}

bool TrilinearCell::converges(const Vec3d& p, Vec3d& rst) const
{
  return newton(p - origin_, rst, [](double) { return false; });
}

bool TrilinearCell::settles(const Vec3d& p, Vec3d& rst) const
{
  // What is left after such a short step is less than the step.
  const auto isSure = [&rst](double size)
  {
    const Vec3d from = glm::abs(rst - Vec3d(0.5));
    const double side = std::max({from.x, from.y, from.z}) - 0.5;
    return size < 0.03 && std::abs(side) > size;
  };
  return newton(p - origin_, rst, isSure);
}

void TrilinearCell::search(const Vec3d& target, Vec3d& best) const
{
  // Distances are measured in the cell's own mean edges, or flat cells would never be matched
  // across their thin side.
  const Mat3d middle = jacobian(Vec3d(0.5));
  const double determinant = determinantOf(middle);
  const bool regular = isRegular(middle, determinant);
  const double edge =
    std::max({glm::length(middle[0]), glm::length(middle[1]), glm::length(middle[2]), 1e-300});
  const auto scaled = [&](const Vec3d& v)
  { return regular ? solve(middle, v, determinant) : v / edge; };
  double bestError = std::numeric_limits<double>::infinity();
  for (int corner = 0; corner < 9; ++corner)
  {
    Vec3d rst(0.5);
    if (corner < 8)
      rst += 0.3 * Vec3d(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    Vec3d off = scaled(target - local(rst));
    double error = glm::dot(off, off), damping = 1e-3;
    for (int i = 0; i < searchSteps && error > 1e-28 && damping < 1e12; ++i)
    {
      const Mat3d j = jacobian(rst);
      const Mat3d s(scaled(j[0]), scaled(j[1]), scaled(j[2]));
      Mat3d normal = glm::transpose(s) * s;
      for (int k = 0; k < 3; ++k)
        normal[k][k] += damping * (normal[k][k] + 1e-12);
      const Vec3d step = solve(normal, glm::transpose(s) * off, determinantOf(normal));
      const Vec3d next = glm::clamp(rst + step, Vec3d(0.0), Vec3d(1.0));
      const Vec3d nextOff = scaled(target - local(next));
      const double nextError = glm::dot(nextOff, nextOff);
      const bool better = nextError < error;
      damping = better ? std::max(1e-15, damping * 0.1) : damping * 4.0;
      if (!better)
        continue;
      rst = next;
      off = nextOff;
      error = nextError;
    }
    if (error < bestError)
    {
      bestError = error;
      best = rst;
    }
    if (bestError < 1e-24)
      return;
  }
}

bool TrilinearCell::coordinates(const Vec3d& p, Vec3d& rst, const Vec3d& start) const
{
  const Vec3d target = p - origin_;
  rst = start;
  if (converges(p, rst))
    return true;
  search(target, rst);
  Vec3d polished = rst;
  if (converges(p, polished) && largest(polished - rst) < 0.1)
  {
    rst = polished;
    return true;
  }
  return false;
}

CornerValues TrilinearCell::weights(const Vec3d& x)
{
  const double r = 1.0 - x.x, s = 1.0 - x.y, t = 1.0 - x.z;
  return {r * s * t, x.x * s * t, x.x * x.y * t, r * x.y * t, r * s * x.z, x.x * s * x.z,
    x.x * x.y * x.z, r * x.y * x.z};
}

CornerValues TrilinearCell::inverseDistanceWeights(const Vec3d& p) const
{
  CornerValues w;
  std::size_t on = 0;
  for (std::size_t i = 0; i < 8; ++i)
  {
    w[i] = glm::length(p - corners_[i]);
    on += w[i] == 0.0;
  }
  double sum = 0.0;
  for (double& v : w)
  {
    v = on > 0 ? (v == 0.0 ? 1.0 : 0.0) : 1.0 / v;
    sum += v;
  }
  for (double& v : w)
    v /= sum;
  return w;
}

Vec3d TrilinearCell::gradient(const CornerValues& v, const Vec3d& rst) const
{
  Vec3d at = rst;
  Mat3d j = jacobian(at);
  double determinant = determinantOf(j);
  for (double pull = 1e-6;
       pull <= 1.0 &&
       std::abs(determinant) <= 1e-9 * glm::length(j[0]) * glm::length(j[1]) * glm::length(j[2]);
       pull *= 10.0)
  {
    at = rst + pull * (Vec3d(0.5) - rst);
    j = jacobian(at);
    determinant = determinantOf(j);
  }
  const double r = at.x, s = at.y, t = at.z;
  const auto mix = [](double a, double b, double c, double d, double x, double y)
  { return (1.0 - y) * ((1.0 - x) * a + x * b) + y * ((1.0 - x) * c + x * d); };
  const Vec3d own(mix(v[1] - v[0], v[2] - v[3], v[5] - v[4], v[6] - v[7], s, t),
    mix(v[3] - v[0], v[2] - v[1], v[7] - v[4], v[6] - v[5], r, t),
    mix(v[4] - v[0], v[5] - v[1], v[7] - v[3], v[6] - v[2], r, s));
  if (determinant == 0.0)
    return Vec3d(0.0);
  // The inverse's rows are these cross products; the gradient is its transpose times `own`.
  return (own.x * glm::cross(j[1], j[2]) + own.y * glm::cross(j[2], j[0]) +
           own.z * glm::cross(j[0], j[1])) /
         determinant;
}

namespace
{

double rangeOf(const CornerValues& values)
{
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return *most - *least;
}

/// Takes off what is linear in space and has the gradient that the values have in the cell's
/// middle, where the Jacobian is `volume` and its cofactors are `rows`.
CornerValues withoutLinear(
  const CornerValues& v, const HexCorners& corners, const Vec3d (&rows)[3], double volume)
{
  const double slopes[3] = {(v[1] - v[0]) + (v[2] - v[3]) + (v[5] - v[4]) + (v[6] - v[7]),
    (v[3] - v[0]) + (v[2] - v[1]) + (v[7] - v[4]) + (v[6] - v[5]),
    (v[4] - v[0]) + (v[5] - v[1]) + (v[7] - v[3]) + (v[6] - v[2])};
  const Vec3d gradient =
    (slopes[0] * rows[0] + slopes[1] * rows[1] + slopes[2] * rows[2]) / (4.0 * volume);
  CornerValues left;
  for (std::size_t i = 0; i < 8; ++i)
    left[i] = v[i] - glm::dot(gradient, corners[i] - corners[0]);
  return left;
}

} // namespace

double bendOf(const HexCorners& corners, const CornerValues& values)
{
  const Coefficients c = coefficientsOf(corners, corners[0]);
  const Vec3d along[3] = {c[1] + 0.5 * (c[4] + c[6]) + 0.25 * c[7],
    c[2] + 0.5 * (c[4] + c[5]) + 0.25 * c[7], c[3] + 0.5 * (c[5] + c[6]) + 0.25 * c[7]};
  const Vec3d rows[3] = {
    glm::cross(along[1], along[2]), glm::cross(along[2], along[0]), glm::cross(along[0], along[1])};
  const double signedVolume = glm::dot(along[0], rows[0]), determinant = std::abs(signedVolume);
  // What is linear in space has no bend, whatever the cell's shape.
  CornerValues v = withoutLinear(values, corners, rows, signedVolume);
  double range = rangeOf(v);
  if (const double whole = rangeOf(values); !(range < whole)) // flat cells
  {
    v = values;
    range = whole;
  }
  // Along the way x(t) the value's second derivative is grad . x'' + x' . H x', and x'' is
  // -J^-1 (x' . H x') of the places; half of an eighth of it, twice for each mixed derivative.
  const Vec3d half = 0.5 * c[7];
  const Vec3d mixed[4] = {c[4] + half, c[5] + half, c[6] + half, 3.0 * half};
  double q[3] = {0.0, 0.0, 0.0};
  for (std::size_t i = 0; i < 3; ++i)
    for (const Vec3d& m : mixed)
      q[i] += std::abs(glm::dot(rows[i], m));
  const double bends = (q[0] + q[1] + q[2]) / determinant;
  if (!(bends < 0.5))
    return range;
  const double slopes[3] = {std::max({std::abs(v[1] - v[0]), std::abs(v[2] - v[3]),
                              std::abs(v[5] - v[4]), std::abs(v[6] - v[7])}),
    std::max(
      {std::abs(v[3] - v[0]), std::abs(v[2] - v[1]), std::abs(v[7] - v[4]), std::abs(v[6] - v[5])}),
    std::max({std::abs(v[4] - v[0]), std::abs(v[5] - v[1]), std::abs(v[7] - v[3]),
      std::abs(v[6] - v[2])})};
  const double rs = (v[2] - v[3]) - (v[1] - v[0]), st = (v[7] - v[4]) - (v[3] - v[0]);
  const double tr = (v[5] - v[1]) - (v[4] - v[0]);
  const double rst = ((v[6] - v[7]) - (v[5] - v[4])) - rs, own = 0.5 * rst;
  double sum = std::abs(rs + own) + std::abs(st + own) + std::abs(tr + own) + 3.0 * std::abs(own);
  for (std::size_t i = 0; i < 3; ++i)
    sum += slopes[i] * q[i] / determinant;
  return std::min(range, 0.25 * sum / ((1.0 - bends) * (1.0 - bends)));
}

JacobianRange jacobianRange(const HexCorners& corners)
{
  const Coefficients c = coefficientsOf(corners, cellCenter(corners));
  JacobianRange range{
    0.0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const double gauss = 0.5 / std::sqrt(3.0);
  for (int i = 0; i < 16; ++i)
  {
    const double half = i < 8 ? gauss : 0.5;
    const Vec3d side(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    const double d = determinantOf(jacobianOf(c, Vec3d(0.5) + half * side));
    if (i < 8)
      range.volume += 0.125 * d;
    range.smallest = std::min(range.smallest, d);
    range.largest = std::max(range.largest, d);
  }
  return range;
}

} // namespace mote
