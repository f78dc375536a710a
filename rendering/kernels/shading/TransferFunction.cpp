#include "TransferFunction.h"

#include "../core/Error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote
{

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Extinction grows without end towards an opacity of 1, but what hides all behind it hides no more
/// by being denser: opacities above this one change the picture no faster.
constexpr double solid = 0.99;

double largestChannel(const Vec4d& c)
{
  return std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z)});
}

} // namespace

TransferTable::TransferTable(const TransferFunction& function, double offset)
  : perUnit_(1.0 / function.unitDistance)
{
  if (function.knots.empty())
    throw Error("A transfer function needs a knot.");
  if (!(function.unitDistance > 0.0) || !std::isfinite(function.unitDistance))
    throw Error("The distance that a volume's opacity is for must be above 0.");
  for (const TransferFunction::Knot& knot : function.knots)
  {
    const double value = knot.value - offset;
    if (!std::isfinite(value) || (!values_.empty() && value < values_.back()))
      throw Error("The knots of a transfer function must be finite and ascend.");
    values_.push_back(value);
    colors_.push_back(glm::clamp(Vec4d(knot.color), 0.0, 1.0));
  }
  findBins();
  next_.assign(values_.size() + 1, values_.size());
  for (std::size_t i = values_.size(); i-- > 0;)
    next_[i] = colors_[i].w > 0.0 ? i : next_[i + 1];
  rates_.assign(pieces(), 0.0);
  for (std::size_t i = 1; i < values_.size(); ++i)
  {
    const Vec4d &a = colors_[i - 1], &b = colors_[i];
    const double width = values_[i] - values_[i - 1], most = std::min(std::max(a.w, b.w), solid);
    if (width > 0.0)
      rates_[i] = (std::abs(b.w - a.w) / (1.0 - most) - largestChannel(b - a) * std::log1p(-most)) *
                  perUnit_ / width;
  }
  nan_ = {Vec3d(function.nan), extinction(std::clamp<double>(function.nan.w, 0.0, 1.0))};
}

void TransferTable::findBins()
{
  binsFrom_ = values_.front();
  const double width = values_.back() - values_.front();
  binsPer_ = width > 0.0 ? double(bins) / width : 0.0;
  bins_.assign(bins + 1, 0);
  // Knots go into bins by the same rounding that values do: none is passed over.
  for (std::size_t i = 0; i < values_.size(); ++i)
    for (std::size_t bin = binOf(values_[i]) + 1; bin <= bins; ++bin)
      bins_[bin] = static_cast<std::uint32_t>(i + 1);
}

double TransferTable::extinction(double opacity) const
{
  return -std::log1p(-opacity) * perUnit_;
}

double TransferTable::lowerEnd(std::size_t piece) const
{
  return piece == 0 ? -infinity : values_[piece - 1];
}

double TransferTable::upperEnd(std::size_t piece) const
{
  return piece < values_.size() ? values_[piece] : infinity;
}

Vec4d TransferTable::colorIn(std::size_t piece, double value) const
{
  if (piece == 0)
    return colors_.front();
  if (piece == values_.size())
    return colors_.back();
  const double from = values_[piece - 1], width = values_[piece] - from;
  const double share = width > 0.0 ? std::clamp((value - from) / width, 0.0, 1.0) : 0.0;
  return colors_[piece - 1] + share * (colors_[piece] - colors_[piece - 1]);
}

TransferTable::Sample TransferTable::inPiece(std::size_t piece, double value) const
{
  const Vec4d color = colorIn(piece, value);
  return {Vec3d(color), color.w > 0.0 ? extinction(color.w) : 0.0};
}

bool TransferTable::isVisible(double lower, double upper) const
{
  if (lower == -infinity && upper == infinity)
    return next_[0] < values_.size() || nan_.extinction > 0.0;
  const std::size_t first = pieceOf(lower), last = pieceOf(upper);
  return next_[first] < last || colorIn(first, lower).w > 0.0 || colorIn(last, upper).w > 0.0;
}

double TransferTable::steepest(double lower, double upper) const
{
  const std::size_t first = pieceOf(lower), last = pieceOf(upper);
  double rate = 0.0, steps = 0.0;
  for (std::size_t i = first; i <= last; ++i)
  {
    rate = std::max(rate, rates_[i]);
    if (i > first && i > 1 && values_[i - 1] == values_[i - 2])
      steps += extinction(std::min(std::max(colors_[i - 1].w, colors_[i - 2].w), solid));
  }
  return steps > 0.0 ? rate + steps / (upper - lower) : rate;
}

} // namespace mote
