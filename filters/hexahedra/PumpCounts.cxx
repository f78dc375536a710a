#include "PumpCounts.h"

#include "PumpShape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace mote::pump
{

namespace
{

using Triple = std::array<int, 3>;

/// Whole numbers near `ideal` times the cube root of the scale, with which a part has nearly
/// `target` cells.
template <class Cells>
Triple fitted(
  double scale, double target, const std::array<double, 3>& ideal, Triple least, const Cells& cells)
{
  const double edge = std::cbrt(scale);
  Triple best = least;
  double bestCost = std::numeric_limits<double>::max();
  const auto tryIt = [&](const Triple& n)
  {
    double cost = 20.0 * std::abs(static_cast<double>(cells(n)) / (scale * target) - 1.0);
    for (int k = 0; k < 3; ++k)
      cost += std::abs(std::log(n[k] / (ideal[k] * edge)));
    if (cost < bestCost)
    {
      bestCost = cost;
      best = n;
    }
  };
  const auto around = [&](int k, int reach, const auto& visit)
  {
    const int middle = static_cast<int>(std::lround(ideal[k] * edge));
    for (int n = std::max(least[k], middle - reach); n <= std::max(least[k], middle + reach); ++n)
      visit(n);
  };
  around(0, 2,
    [&](int a) {
      around(1, 2, [&](int b) { around(2, 12, [&](int c) { tryIt({a, b, c}); }); });
    });
  return best;
}

} // namespace

std::int64_t InletCounts::cells() const
{
  return (std::int64_t{core} * core + std::int64_t{4} * core * rings) * axial;
}

std::int64_t RotorCounts::cells() const
{
  return std::int64_t{bladeCount} * pitch * span * stream;
}

int DiffuserCounts::volute() const
{
  return std::max(3, static_cast<int>(std::lround(0.72 * radial)));
}

int DiffuserCounts::outlet() const
{
  return std::max(4, static_cast<int>(std::lround(0.9 * radial)));
}

std::int64_t DiffuserCounts::cells() const
{
  return std::int64_t{span} * (std::int64_t{vaneCount} * pitch * radial +
                                (std::int64_t{vaneCount - 1} * pitch + outlet()) * volute());
}

InletCounts inletCounts(double scale)
{
  const auto make = [](const Triple& n) { return InletCounts{2 * n[0] + 1, n[1], n[2]}; };
  return make(fitted(scale, inletCells, {16.5, 24.0, 202.0}, {1, 2, 8},
    [&](const Triple& n) { return make(n).cells(); }));
}

RotorCounts rotorCounts(double scale)
{
  const auto make = [](const Triple& n) { return RotorCounts{n[0], n[1], n[2]}; };
  return make(fitted(scale, rotorCells, {48.0, 48.0, 133.0}, {4, 3, 8},
    [&](const Triple& n) { return make(n).cells(); }));
}

DiffuserCounts diffuserCounts(double scale)
{
  const auto make = [](const Triple& n) { return DiffuserCounts{n[0], n[1], n[2]}; };
  return make(fitted(scale, diffuserCells, {40.0, 48.0, 110.0}, {4, 3, 7},
    [&](const Triple& n) { return make(n).cells(); }));
}

} // namespace mote::pump
