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
  /// What the function is from one value to another: extinction, and extinction times red, green
  /// and blue; and their integrals up to where the row begins.
  struct alignas(64) Row
  {
    float integral[4], value[4], slope[4];
    float from, end, unused[2];
  };
  static_assert(sizeof(Row) == 64);

  WalkTransfer() = default;
  /// `lower` and `upper` are the range of the scalar, by which rows are found.
  WalkTransfer(const TransferTable& table, double lower, double upper);

  /// The even part of the scalar's range that a value lies in, from 0 to bins - 1; NaN in any.
  static constexpr std::size_t bins = 1024;
  float binsFrom() const { return binsFrom_; }
  float binsPer() const { return binsPer_; }
  std::uint32_t rowOf(float value) const
  {
    std::uint32_t row = bins_[binOf(value)];
    while (row + 1 < rows_.size() && rows_[row].end <= value)
      ++row;
    return row;
  }
  const Row& row(std::uint32_t i) const { return rows_[i]; }
  struct Table
  {
    const Row* rows;
    const std::uint32_t* bins; ///< the row that each bin begins in, or one before
    const float* ends;         ///< of these rows
    bool isFine;               ///< no bin reaches beyond the row behind it
  };
  Table table() const { return {rows_.data(), bins_.data(), ends_.data(), isFine_}; }
  /// Whether an extinction without end lies between two rows or in one of them.
  bool isSolid(std::uint32_t a, std::uint32_t b) const
  {
    return solidBefore_[(a > b ? a : b) + 1] != solidBefore_[a < b ? a : b];
  }
  /// How fast what is seen changes, at most, see TransferTable::steepest(): between two values it
  /// is the greatest rate of their bins and those between, and the sum of the steps over the
  /// difference.
  static constexpr std::size_t coarseBins = 64, levels = 7;
  struct Rates
  {
    const float* most;        ///< in 1, 2, 4 and more coarse bins from each on: coarseBins a level
    const float* stepsBefore; ///< each coarse bin, and all of them
    float binsPer;
    bool hasSteps;
  };
  Rates rates() const
  {
    return {rates_[0].data(), stepsBefore_.data(), binsPer_ * coarseShare,
      stepsBefore_[coarseBins] > 0.0f};
  }
  bool hasSolid() const { return solidBefore_.back() > 0; }

private:
  std::uint32_t binOf(float value) const
  {
    const float at = (value - binsFrom_) * binsPer_;
    constexpr float last = static_cast<float>(bins - 1);
    return at > 0.0f ? static_cast<std::uint32_t>(at < last ? at : last) : 0;
  }
  static constexpr float coarseShare = float(coarseBins) / float(bins);
  std::size_t coarseBinOf(float value) const
  {
    const float at = (value - binsFrom_) * (binsPer_ * coarseShare);
    constexpr float last = static_cast<float>(coarseBins - 1);
    return at > 0.0f ? static_cast<std::size_t>(at < last ? at : last) : 0;
  }
  void findRates(const TransferTable& table, double lower, double upper);
  void cut(const TransferTable& table, std::size_t piece, double from, double to, int depth);
  void add(const TransferTable& table, std::size_t piece, double from, double to);

  std::vector<Row> rows_;
  std::vector<std::uint32_t> solidBefore_;
  /// The greatest rate in 1, 2, 4 and more coarse bins from each on; and steps of the extinction.
  std::array<std::array<float, coarseBins>, levels> rates_{};
  std::array<float, coarseBins + 1> stepsBefore_{};
  std::vector<std::uint32_t> bins_;
  std::vector<float> ends_;
  bool isFine_ = true;
  float binsFrom_ = 0.0f, binsPer_ = 0.0f;
};

} // namespace mote
