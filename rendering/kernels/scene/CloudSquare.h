#pragma once

#include "../hexahedra/RayColor.h"

#include <array>

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
  /// and y of `side`. Parts are of 8 pixels at first, and are halved where their middle is further
  /// from what interpolation gives than `tolerance`, in any channel.
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
    for (int y = 0; y < side; y += first)
      for (int x = 0; x < side; x += first)
        refine(x, y, first, tolerance, at);
  }

  const RayColor& operator()(int x, int y) const { return colors_[index(x, y)]; }

private:
  static constexpr int first = 8;
  static std::size_t index(int x, int y) { return static_cast<std::size_t>(y * (largest + 1) + x); }

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
