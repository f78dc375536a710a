#pragma once

#include "../../core/RawVector.h"
#include "../../shading/TransferFunction.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace mote
{

/// A transfer function cut into rows between which extinction and colour are as good as linear,
/// with its integrals: what a line from one value to another looks like follows from its ends.
class WalkTransfer
{
public:
  /// What the function is from where a row begins. Numbers are those of extinction and of
  /// extinction times red, green and blue; or, in `look`, extinction and red, green and blue.
  struct alignas(16) Row
  {
    float integral[4], value[4], slope[4];
    float look[4], lookSlope[4];
  };

  WalkTransfer() = default;
  /// `lower` and `upper` are the range of the scalar, by which rows are found.
  WalkTransfer(const TransferTable& table, double lower, double upper);

  /// What is needed to look values up.
  struct Table
  {
    const Row* rows;
    const float* from; ///< where the numbers of a row count from
    const float* ends;
    const std::uint32_t* bins;
    float binsFrom, binsPer;

    /// The row of a value; the first one for NaN.
    std::uint32_t rowOf(float value) const
    {
      const float at = (value - binsFrom) * binsPer;
      constexpr float last = static_cast<float>(WalkTransfer::bins - 1);
      std::uint32_t row = bins[at > 0.0f ? static_cast<std::uint32_t>(at < last ? at : last) : 0];
      while (ends[row] <= value)
        ++row;
      return row;
    }
  };
  Table table() const
  {
    return {rows_.data(), from_.data(), ends_.data(), bins_.data(), binsFrom_, binsPer_};
  }
  /// Whether an extinction without end lies between two rows or in one of them.
  bool isSolid(std::uint32_t a, std::uint32_t b) const
  {
    return solidBefore_[(a > b ? a : b) + 1] != solidBefore_[a < b ? a : b];
  }
  /// How fast what is seen changes between two values, at most; see TransferTable::steepest().
  float rateIn(float lower, float upper) const
  {
    const std::size_t first = coarseBinOf(lower), last = coarseBinOf(upper);
    const auto level = static_cast<std::size_t>(std::bit_width(last - first + 1) - 1);
    const float rate =
      std::max(rates_[level][first], rates_[level][last + 1 - (std::size_t(1) << level)]);
    const float steps = stepsBefore_[last + 1] - stepsBefore_[first];
    return steps > 0.0f ? rate + steps / (upper - lower) : rate;
  }
  bool hasSolid() const { return solidBefore_.back() > 0; }

private:
  static constexpr std::size_t bins = 1024, coarseBins = 64, levels = 7;
  std::size_t coarseBinOf(float value) const
  {
    const float at = (value - binsFrom_) * binsPer_ * (float(coarseBins) / float(bins));
    constexpr float last = static_cast<float>(coarseBins - 1);
    return at > 0.0f ? static_cast<std::size_t>(at < last ? at : last) : 0;
  }
  void findRates(const TransferTable& table, double lower, double upper);
  void cut(const TransferTable& table, std::size_t piece, double from, double to, int depth);
  void add(const TransferTable& table, std::size_t piece, double from, double to);

  std::vector<Row> rows_;
  std::vector<float> from_, ends_;
  std::vector<std::uint32_t> solidBefore_;
  /// The greatest rate in 1, 2, 4 and more coarse bins from each on; and steps of the extinction.
  std::array<std::array<float, coarseBins>, levels> rates_{};
  std::array<float, coarseBins + 1> stepsBefore_{};
  std::vector<std::uint32_t> bins_;
  float binsFrom_ = 0.0f, binsPer_ = 0.0f;
};

} // namespace mote
