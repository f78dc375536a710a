#include "HexOracle.h"

#include <cmath>

namespace mote::testing
{

namespace
{

using Vec = HexOracle::Vec;
constexpr int signs[8][3] = {
  {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

} // namespace

HexOracle::HexOracle(const HexCorners& corners)
{
  for (int i = 0; i < 8; ++i)
    corners_[i] = Vec(corners[static_cast<std::size_t>(i)]);
}

bool HexOracle::newton(const Vec& target, Vec& x) const
{
  for (int step = 0; step < 40; ++step)
  {
    Vec off = target, j[3] = {Vec(0.0L), Vec(0.0L), Vec(0.0L)};
    for (int i = 0; i < 8; ++i)
    {
      long double f[3], d[3];
      for (int k = 0; k < 3; ++k)
      {
        f[k] = signs[i][k] ? x[k] : 1.0L - x[k];
        d[k] = signs[i][k] ? 1.0L : -1.0L;
      }
      off -= f[0] * f[1] * f[2] * corners_[i];
      j[0] += d[0] * f[1] * f[2] * corners_[i];
      j[1] += f[0] * d[1] * f[2] * corners_[i];
      j[2] += f[0] * f[1] * d[2] * corners_[i];
    }
    const long double determinant = glm::dot(j[0], glm::cross(j[1], j[2]));
    if (determinant == 0.0L)
      return false;
    const Vec delta =
      Vec(glm::dot(off, glm::cross(j[1], j[2])), glm::dot(off, glm::cross(j[2], j[0])),
        glm::dot(off, glm::cross(j[0], j[1]))) /
      determinant;
    x += delta;
    const long double size = glm::dot(delta, delta);
    if (!(size < 1e6L))
      return false;
    if (size < 1e-32L)
      return true;
  }
  return false;
}

bool HexOracle::coordinates(const Vec3d& p, Vec& rst) const
{
  for (int i = 0; i < 27; ++i)
  {
    rst = Vec(0.5L) + 0.45L * Vec((i + 1) % 3 - 1, (i / 3 + 1) % 3 - 1, (i / 9 + 1) % 3 - 1);
    if (newton(Vec(p), rst) && glm::all(glm::greaterThanEqual(rst, Vec(-1e-15L))) &&
        glm::all(glm::lessThanEqual(rst, Vec(1.0L + 1e-15L))))
      return true;
  }
  return false;
}

bool HexOracle::contains(const Vec3d& p) const
{
  Vec rst;
  return coordinates(p, rst);
}

double HexOracle::share(const Vec3d& from, const Vec3d& to, int samples) const
{
  const auto in = [&](double s) { return contains(from + s * (to - from)); };
  double sum = 0.0, begin = 0.0;
  bool inside = in(0.0);
  for (int i = 1; i <= samples; ++i)
  {
    const double s = static_cast<double>(i) / samples;
    if (in(s) == inside)
      continue;
    double a = static_cast<double>(i - 1) / samples, b = s;
    for (int k = 0; k < 50; ++k)
    {
      const double middle = 0.5 * (a + b);
      (in(middle) == inside ? a : b) = middle;
    }
    if (inside)
      sum += b - begin;
    begin = b;
    inside = !inside;
  }
  return inside ? sum + 1.0 - begin : sum;
}

} // namespace mote::testing
