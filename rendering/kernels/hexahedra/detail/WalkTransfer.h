#pragma once

#include "../../core/RawVector.h"
#include "../../shading/TransferFunction.h"

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

  /// The row of a value; the first one for NaN.
  std::uint32_t rowOf(float value) const
  {
    const float at = (value - binsFrom_) * binsPer_;
    const float last = static_cast<float>(bins - 1);
    std::uint32_t row = bins_[at > 0.0f ? static_cast<std::size_t>(at < last ? at : last) : 0];
    while (ends_[row] <= value)
      ++row;
    return row;
  }
  const Row& row(std::uint32_t i) const { return rows_[i]; }
  /// Where the numbers of a row count from.
  float from(std::uint32_t i) const { return from_[i]; }
  /// Different for rows of different pieces of the function; rows that are solid have odd ones.
  std::uint32_t pieceOf(std::uint32_t row) const { return pieces_[row]; }
  /// Whether an extinction without end lies between two rows or in one of them.
  bool isSolid(std::uint32_t a, std::uint32_t b) const
  {
    return solidBefore_[(a > b ? a : b) + 1] != solidBefore_[a < b ? a : b];
  }
  bool hasSolid() const { return solidBefore_.back() > 0; }

private:
  static constexpr std::size_t bins = 1024;
  void cut(const TransferTable& table, std::size_t piece, double from, double to, int depth);
  void add(const TransferTable& table, std::size_t piece, double from, double to);

  std::vector<Row> rows_;
  std::vector<float> from_, ends_;
  std::vector<std::uint32_t> pieces_, solidBefore_;
  std::vector<std::uint32_t> bins_;
  float binsFrom_ = 0.0f, binsPer_ = 0.0f;
};

} // namespace mote
