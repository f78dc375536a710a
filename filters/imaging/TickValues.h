/**
 * Round tick values for a scale, and the texts that tell them apart.
 */

#ifndef MoteTickValues_h
#define MoteTickValues_h

#include <string>
#include <vector>

namespace mote::imaging
{

struct Tick
{
  double value = 0.0;
  std::string label;  // UTF-8
  double share = 0.0; // place along the scale, in [0, 1]
};

struct TickScale
{
  double low = 0.0;
  double high = 1.0;
  bool isLogarithmic = false;

  /// Place of a value along the scale, 0 at low and 1 at high.
  double shareOf(double value) const;
  /// The value at a place, the inverse of shareOf().
  double valueAt(double share) const;
};

struct TickSet
{
  std::vector<Tick> ticks;   // from low to high, none closer than the distance asked for
  std::vector<double> minor; // shares of ticks without labels, of a logarithmic scale
  int exponent = 0;          // labels are to be multiplied by 10 to the power of this
};

/**
 * About `count` >= 2 ticks within [low, high]: multiples of 1, 2 or 5 times a power of ten;
 * on a logarithmic scale of a decade or more, powers of ten and, if they are few, 2 and 5 times
 * these, and both ends. No two are closer than `minimumShare` of the scale. Where low == high, that
 * value alone.
 *
 * `format` is a printf format for one double, or empty for the fewest digits that tell
 * the ticks apart. `low` <= `high`, both finite, and positive for a logarithmic scale.
 */
TickSet makeTicks(
  const TickScale& scale, int count, double minimumShare, const std::string& format);

/// Whether a printf format takes exactly one double and nothing else.
bool isDoubleFormat(const std::string& format);

/// 10 to the power of `exponent` in UTF-8, with a raised exponent.
std::string powerOfTen(int exponent);

} // namespace mote::imaging

#endif
