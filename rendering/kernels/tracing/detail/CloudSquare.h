#pragma once

#include "../../hexahedra/RayColor.h"

#include <array>
#include <functional>
#include <vector>

namespace mote
{

/// The clouds seen by a square of pixels, of which only some are traced: those between which linear
/// interpolation is not good enough. Source: Levoy, "Volume Rendering by Adaptive Refinement", The
/// Visual Computer 6, 1990; there the corners of a part decide, here what interpolation says of its
/// middle.
class CloudSquare
{
public:
  static constexpr int largest = 32;
  static constexpr int mostPixels = 256; ///< that Trace is asked for at a time

  struct Pixel
  {
    int x, y;
  };
  /// Answers for 1 to mostPixels pixels of the square, also for x and y of its side.
  using Trace = std::function<void(const Pixel* pixels, int count, RayColor* colors)>;

  /// Of `side` pixels, 8, 16 or 32. Blocks of 16 pixels are traced at their corners and half-way
  /// between them; where interpolation between the corners gives the other five to within
  /// `tolerance`, in any channel, that is enough. Else, and in squares of 8 pixels, each part of 8
  /// is traced in its middle, and halved where that is off. All blocks are traced together, so that
  /// what asks for rays asks for many.
  CloudSquare(int side, double tolerance, const Trace& trace);

  const RayColor& operator()(int x, int y) const { return colors_[index(x, y)]; }

private:
  /// A part of the square: its lower left pixel and its side.
  struct Part
  {
    int x, y, size;
  };
  using Corners = std::array<RayColor, 4>;

  static std::size_t index(int x, int y) { return static_cast<std::size_t>(y * (largest + 1) + x); }
  void want(int x, int y);
  void wantCorners(const Part& part);
  void traceWanted(const Trace& trace);
  Corners cornersOf(const Part& part) const;
  bool isEven(const Part& block, double tolerance) const;
  void refine(std::vector<Part> parts, double tolerance, const Trace& trace);
  void fill(const Part& part);
  static RayColor between(const Corners& corners, double u, double v);
  static double difference(const RayColor& a, const RayColor& b);

  static constexpr std::size_t pixels = (largest + 1) * (largest + 1);
  std::array<RayColor, pixels> colors_;
  std::array<bool, pixels> known_{}; ///< traced, or about to be
  std::vector<Pixel> wanted_;
  std::vector<Part> even_; ///< interpolation is good enough between the corners of these
};

} // namespace mote
