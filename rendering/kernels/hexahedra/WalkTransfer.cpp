#include "detail/WalkTransfer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote
{

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

/// How far a row may be from its line, as a share of the extinction.
constexpr double straight = 1e-4;
constexpr int mostCuts = 10;

Vec4d productOf(const TransferTable::Sample& s)
{
  return {s.extinction, s.extinction * s.color};
}

} // namespace

WalkTransfer::WalkTransfer(const TransferTable& table, double lower, double upper)
  : solidBefore_(1, 0)
{
  // The first and the last piece are even and go on for ever.
  const std::size_t last = table.pieces() - 1;
  const double first = table.upperEnd(0), end = table.lowerEnd(last);
  add(table, 0, first, first);
  for (std::size_t piece = 1; piece < last; ++piece)
    if (table.lowerEnd(piece) < table.upperEnd(piece))
      cut(table, piece, table.lowerEnd(piece), table.upperEnd(piece), 0);
  add(table, last, end, end);
  rows_.back().end = std::numeric_limits<float>::infinity();
  binsFrom_ = static_cast<float>(lower);
  binsPer_ = upper > lower ? static_cast<float>(bins / (upper - lower)) : 0.0f;
  bins_.resize(bins);
  // A bin's row must not come behind that of any value that is rounded into the bin.
  std::uint32_t row = 0;
  for (std::size_t i = 0; i < bins; ++i)
  {
    const double from = binsPer_ > 0.0f ? lower + (double(i) - 0.01) / binsPer_ : -infinity;
    while (row + 1 < rows_.size() && i > 0 && rows_[row].end <= from)
      ++row;
    bins_[i] = row;
    ends_.push_back(rows_[row].end);
    const double to =
      binsPer_ > 0.0f && i + 1 < bins ? lower + (double(i) + 1.01) / binsPer_ : infinity;
    isFine_ = isFine_ && (row + 2 >= rows_.size() || rows_[row + 1].end > to);
  }
  this->findRates(table, lower, upper);
}

void WalkTransfer::findRates(const TransferTable& table, double lower, double upper)
{
  std::array<float, coarseBins> steps{};
  for (std::size_t piece = 1; piece + 1 < table.pieces(); ++piece)
  {
    const double from = table.lowerEnd(piece), to = table.upperEnd(piece);
    const std::size_t first = coarseBinOf(static_cast<float>(from));
    const std::size_t last = coarseBinOf(static_cast<float>(to));
    if (from == to)
    {
      const double near = std::max(1e-9 * (upper - lower), 1e-12 * std::abs(from));
      if (near > 0.0)
        steps[first] += static_cast<float>(table.steepest(from - near, from + near) * 2.0 * near);
      continue;
    }
    const double middle = 0.5 * (from + to);
    const auto rate = static_cast<float>(table.steepest(middle, middle));
    for (std::size_t bin = first; bin <= last; ++bin)
      rates_[0][bin] = std::max(rates_[0][bin], rate);
  }
  for (std::size_t bin = 0; bin < coarseBins; ++bin)
    stepsBefore_[bin + 1] = stepsBefore_[bin] + steps[bin];
  for (std::size_t level = 1; level < levels; ++level)
    for (std::size_t bin = 0; bin + (std::size_t(1) << level) <= coarseBins; ++bin)
      rates_[level][bin] =
        std::max(rates_[level - 1][bin], rates_[level - 1][bin + (std::size_t(1) << (level - 1))]);
}

void WalkTransfer::cut(
  const TransferTable& table, std::size_t piece, double from, double to, int depth)
{
  const double middle = 0.5 * (from + to);
  const Vec4d a = productOf(table.inPiece(piece, from)), b = productOf(table.inPiece(piece, to));
  const Vec4d m = productOf(table.inPiece(piece, middle));
  const Vec4d off = glm::abs(m - 0.5 * (a + b));
  const double most = std::max({off.x, off.y, off.z, off.w});
  const bool isEven = std::isinf(a.x) && std::isinf(b.x);
  if (isEven || most <= straight * m.x || depth == mostCuts || !(from < middle && middle < to))
    return add(table, piece, from, to);
  cut(table, piece, from, middle, depth + 1);
  cut(table, piece, middle, to, depth + 1);
}

void WalkTransfer::add(const TransferTable& table, std::size_t piece, double from, double to)
{
  const TransferTable::Sample a = table.inPiece(piece, from), b = table.inPiece(piece, to);
  const bool isSolid = std::isinf(a.extinction) || std::isinf(b.extinction);
  const double width = to - from;
  Row row{};
  if (!isSolid)
    for (int k = 0; k < 4; ++k)
    {
      const double p = productOf(a)[k], q = productOf(b)[k];
      row.value[k] = static_cast<float>(p);
      row.slope[k] = width > 0.0 ? static_cast<float>((q - p) / width) : 0.0f;
    }
  if (!rows_.empty())
  {
    const Row& before = rows_.back();
    const float whole = before.end - before.from;
    for (int k = 0; k < 4; ++k)
      row.integral[k] =
        before.integral[k] + whole * (before.value[k] + 0.5f * whole * before.slope[k]);
  }
  row.from = static_cast<float>(from);
  row.end = static_cast<float>(to);
  rows_.push_back(row);
  solidBefore_.push_back(solidBefore_.back() + (isSolid ? 1 : 0));
}

} // namespace mote
