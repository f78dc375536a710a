#pragma once

#include "../../hexahedra/RayColor.h"

#include <array>
#include <utility>

namespace mote
{

/// The clouds seen by a square of pixels, of which only some are traced: those between which linear
/// interpolation is not good enough. Source: Levoy, "Volume Rendering by Adaptive Refinement", The
/// Visual Computer 6, 1990; there the corners of a part decide, here what interpolation says of its
/// middle.
class CloudSquare
{
public:
  static constexpr int largest = 16;

  /// Of `side` pixels, 8 or 16; trace(x, y) answers for the pixel (x, y) of the square, also for x
  /// and y of `side`. A square of 16 pixels is traced at its corners and half-way between them;
  /// where interpolation between the corners gives the other five to within `tolerance`, in any
  /// channel, that is enough. Else, and in squares of 8 pixels, each part of 8 is traced in its
  /// middle, and halved where that is off.
  template <typename Trace>
  CloudSquare(int side, double tolerance, const Trace& trace)
  {
    const auto at = [&](int x, int y) -> const RayColor&
    {
      bool& known = known_[index(x, y)];
      if (!known)
        colors_[index(x, y)] = trace(x, y);
      known = true;
      return colors_[index(x, y)];
    };
    const bool isEven = side == largest && isEvenAt(tolerance, at);
    for (int y = 0; y < side; y += first)
      for (int x = 0; x < side; x += first)
        if (isEven)
          fill(
            x, y, first, {at(x, y), at(x + first, y), at(x, y + first), at(x + first, y + first)});
        else
          refine(x, y, first, tolerance, at);
  }

  const RayColor& operator()(int x, int y) const { return colors_[index(x, y)]; }

private:
  static constexpr int first = 8;
  static std::size_t index(int x, int y) { return static_cast<std::size_t>(y * (largest + 1) + x); }

  /// Whether interpolation between the corners of the whole square is good enough half-way.
  template <typename At>
  bool isEvenAt(double tolerance, const At& at)
  {
    const RayColor corners[4] = {at(0, 0), at(largest, 0), at(0, largest), at(largest, largest)};
    for (const auto& [x, y] : {std::pair(1, 1), {1, 0}, {0, 1}, {2, 1}, {1, 2}})
      if (difference(at(x * first, y * first), between(corners, 0.5 * x, 0.5 * y)) > tolerance)
        return false;
    return true;
  }

  template <typename At>
  void refine(int x, int y, int size, double tolerance, const At& at)
  {
    const RayColor corners[4] = {
      at(x, y), at(x + size, y), at(x, y + size), at(x + size, y + size)};
    if (size == 1)
      return;
    const int half = size / 2;
    if (difference(at(x + half, y + half), between(corners, 0.5, 0.5)) <= tolerance)
      return fill(x, y, size, corners);
    for (int part = 0; part < 4; ++part)
      refine(x + (part & 1) * half, y + (part >> 1) * half, half, tolerance, at);
  }
  void fill(int x, int y, int size, const RayColor (&corners)[4]);
  static RayColor between(const RayColor (&corners)[4], double u, double v);
  static double difference(const RayColor& a, const RayColor& b);

  static constexpr std::size_t pixels = (largest + 1) * (largest + 1);
  std::array<RayColor, pixels> colors_;
  std::array<bool, pixels> known_{};
};

} // namespace mote
