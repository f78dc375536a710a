#pragma once

#include "../core/Vec.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mote
{

/// Colour and opacity of a volume as functions of a scalar, linear between knots.
///
/// Opacity is what `unitDistance` of such a volume covers. A path of length s covers
/// 1 - (1 - opacity)^(s / unitDistance), however it is cut into steps; the extinction is
/// -log(1 - opacity) / unitDistance, and an opacity of 1 hides at once.
struct TransferFunction
{
  struct Knot
  {
    double value = 0.0;
    Vec4f color{0.0f}; ///< red, green, blue, not premultiplied, and opacity; all in [0, 1]

    bool operator==(const Knot&) const = default;
  };

  /// In ascending order; the first and the last go on for ever. Two knots of one value are a step:
  /// the second holds from the value on.
  std::vector<Knot> knots = {{0.0, Vec4f(0.0f)}, {1.0, Vec4f(1.0f)}};
  double unitDistance = 1.0; ///< above 0, in world units
  Vec4f nan{0.0f};           ///< of cells with a NaN; opacity 0 leaves them out

  bool operator==(const TransferFunction&) const = default;
};

/// A transfer function ready to be asked for many values.
class TransferTable
{
public:
  /// What a value looks like: colour, and extinction per world unit, which may be infinite.
  struct Sample
  {
    Vec3d color{0.0};
    double extinction = 0.0;
  };

  TransferTable() = default;
  /// Of values that count from `offset`. Throws Error where there is no knot, where knots do not
  /// ascend, or where the unit distance is not above 0.
  explicit TransferTable(const TransferFunction& function, double offset = 0.0);

  Sample operator()(double value) const { return inPiece(pieceOf(value), value); }
  /// As operator(), for values of the piece `piece` alone: of two at a step, that piece's.
  Sample inPiece(std::size_t piece, double value) const;
  Sample ofNaN() const { return nan_; }

  /// Pieces lie between knots: piece 0 below the first, piece i from knot i - 1 to knot i.
  std::size_t pieces() const { return values_.size() + 1; }
  /// The piece with the value; at a knot the one above it.
  std::size_t pieceOf(double value) const
  {
    std::size_t piece = bins_[binOf(value)]; // of the bin's lower end
    while (piece < values_.size() && values_[piece] <= value)
      ++piece;
    return piece;
  }
  /// Where a piece ends below and above; infinite for the first and last.
  double lowerEnd(std::size_t piece) const;
  double upperEnd(std::size_t piece) const;

  /// Whether any value in the range has an opacity above 0, or, for what has no range, NaN has.
  bool isVisible(double lower, double upper) const;
  /// How much colour times extinction can change in the range, at most, per unit of the scalar:
  /// the rate at which errors of the scalar become errors of the picture. A step counts as if it
  /// were spread over the range.
  double steepest(double lower, double upper) const;

private:
  static constexpr std::size_t bins = 64;
  /// Even parts of the range of knots, to find knots by.
  std::size_t binOf(double value) const
  {
    const double at = (value - binsFrom_) * binsPer_;
    return at > 0.0 ? (at < double(bins) ? static_cast<std::size_t>(at) : bins) : 0;
  }
  void findBins();
  double extinction(double opacity) const;
  Vec4d colorIn(std::size_t piece, double value) const;

  std::vector<double> values_;      ///< of the knots
  std::vector<Vec4d> colors_;       ///< of the knots
  std::vector<std::uint32_t> bins_; ///< a piece each, that begins where the bin does or before
  double binsFrom_ = 0.0, binsPer_ = 0.0;
  std::vector<std::size_t> next_; ///< the first knot from each on with an opacity above 0
  std::vector<double> rates_;     ///< of the pieces, see steepest()
  double perUnit_ = 1.0;          ///< 1 / unitDistance
  Sample nan_;
};

} // namespace mote
