#include "TickValues.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace mote::imaging
{
namespace
{

constexpr const char* Minus = "\u2212";

/// A value mantissa * 10^exponent, kept apart so that labels have no rounding error.
struct RoundValue
{
  double mantissa;
  int exponent;
  double value() const
  {
    return exponent < 0 ? mantissa / std::pow(10.0, -exponent)
                        : mantissa * std::pow(10.0, exponent);
  }
};

std::string withMinusSign(std::string text)
{
  for (std::size_t at = text.find('-'); at != std::string::npos; at = text.find('-', at + 1))
    text.replace(at, 1, Minus);
  return text;
}

std::string formatted(const char* format, double value)
{
  char text[512];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

std::string fixed(double value, int decimals)
{
  char text[512];
  std::snprintf(text, sizeof(text), "%.*f", decimals, value == 0.0 ? 0.0 : value);
  return withMinusSign(text);
}

/// The multiples of mantissa * 10^exponent in [low, high].
std::vector<RoundValue> multiples(const TickScale& scale, double mantissa, int exponent)
{
  const double step = RoundValue{mantissa, exponent}.value();
  // Ends that are multiples but for rounding belong to the scale.
  const double first = std::ceil(scale.low / step - 1e-6);
  const double last = std::floor(scale.high / step + 1e-6);
  std::vector<RoundValue> values;
  for (double i = first; i <= last && values.size() < 1000; i += 1.0)
    values.push_back({i * mantissa + 0.0, exponent}); // no negative zero
  return values;
}

std::vector<RoundValue> linearValues(const TickScale& scale, int count)
{
  const int magnitude =
    static_cast<int>(std::floor(std::log10(scale.high / count - scale.low / count)));
  std::vector<RoundValue> best;
  for (int exponent = magnitude - 1; exponent <= magnitude + 1; ++exponent)
  {
    for (const double mantissa : {1.0, 2.0, 5.0})
    {
      std::vector<RoundValue> values = multiples(scale, mantissa, exponent);
      const auto miss = [&](const auto& v) { return std::abs(static_cast<int>(v.size()) - count); };
      if (best.empty() || miss(values) < miss(best))
        best = std::move(values);
    }
  }
  return best;
}

/// Powers of ten, each times those of `factors`, in steps of `stride` decades.
std::vector<RoundValue> decadeValues(
  const TickScale& scale, const std::vector<double>& factors, int stride)
{
  const int first = static_cast<int>(std::floor(std::log10(scale.low)));
  const int last = static_cast<int>(std::ceil(std::log10(scale.high)));
  const double slack = 1e-9;
  std::vector<RoundValue> values;
  for (int exponent = first; exponent <= last; ++exponent)
  {
    for (const double factor : factors)
    {
      const RoundValue value{factor, exponent};
      const bool isInside =
        value.value() >= scale.low * (1.0 - slack) && value.value() <= scale.high * (1.0 + slack);
      if (exponent % stride == 0 && isInside)
        values.push_back(value);
    }
  }
  return values;
}

std::vector<RoundValue> logarithmicValues(const TickScale& scale, int count)
{
  const double decades = std::log10(scale.high) - std::log10(scale.low);
  const std::vector<RoundValue> dense = decadeValues(scale, {1.0, 2.0, 5.0}, 1);
  if (decades < 3.0 && static_cast<int>(dense.size()) <= count + 2)
    return dense.size() > 2 ? dense : linearValues(scale, count);
  for (int stride = 1;; ++stride)
  {
    std::vector<RoundValue> values = decadeValues(scale, {1.0}, stride);
    if (static_cast<int>(values.size()) <= count + 1)
      return values.size() > 1 ? values : dense;
  }
}

double smallestGap(const TickScale& scale, const std::vector<RoundValue>& values)
{
  double gap = 1.0;
  for (std::size_t i = 1; i < values.size(); ++i)
    gap = std::min(gap, scale.shareOf(values[i].value()) - scale.shareOf(values[i - 1].value()));
  return gap;
}

int exponentOf(double value)
{
  return value == 0.0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-9));
}

/// Digits behind the point that the values need when written as multiples of 10^exponent.
int decimalsOf(const std::vector<RoundValue>& values, int exponent)
{
  int decimals = 0;
  for (const RoundValue& value : values)
  {
    const bool isTen = std::fmod(value.mantissa, 10.0) == 0.0;
    decimals = std::max(decimals, exponent - value.exponent - (isTen ? 1 : 0));
  }
  return decimals;
}

std::string powerLabel(const RoundValue& value)
{
  const int digits = exponentOf(value.mantissa);
  const std::string power = powerOfTen(value.exponent + digits);
  return value.mantissa == 1.0
           ? power
           : fixed(value.mantissa / std::pow(10.0, digits), digits) + "\u00d7" + power;
}

/// A value with three digits at most, and no zeros behind them.
RoundValue threeDigits(double value)
{
  RoundValue rounded{0.0, exponentOf(value) - 2};
  rounded.mantissa = std::round(rounded.exponent < 0 ? value * std::pow(10.0, -rounded.exponent)
                                                     : value / std::pow(10.0, rounded.exponent));
  while (rounded.mantissa != 0.0 && std::fmod(rounded.mantissa, 10.0) == 0.0)
  {
    rounded.mantissa /= 10.0;
    ++rounded.exponent;
  }
  return rounded;
}

/// The ends of a logarithmic scale, which no round step leads to, take the place of what is too
/// near to them.
void addEnds(const TickScale& scale, double minimumShare, std::vector<RoundValue>& values)
{
  constexpr double same = 1e-6;
  const auto isAt = [&](const RoundValue& value, double end, double within)
  { return std::abs(scale.shareOf(value.value()) - end) < within; };
  if (!values.empty() && !isAt(values.front(), 0.0, same))
  {
    while (!values.empty() && isAt(values.front(), 0.0, minimumShare))
      values.erase(values.begin());
    values.insert(values.begin(), threeDigits(scale.low));
  }
  if (!isAt(values.back(), 1.0, same))
  {
    while (values.size() > 1 && isAt(values.back(), 1.0, minimumShare))
      values.pop_back();
    values.push_back(threeDigits(scale.high));
  }
}

void labelTicks(TickSet& set, const std::vector<RoundValue>& values, bool isLogarithmic)
{
  int least = 400;
  int greatest = -400;
  for (const Tick& tick : set.ticks)
  {
    least = tick.value == 0.0 ? least : std::min(least, exponentOf(tick.value));
    greatest = tick.value == 0.0 ? greatest : std::max(greatest, exponentOf(tick.value));
  }
  if (isLogarithmic && greatest > least && (least < -3 || greatest > 4))
  {
    for (std::size_t i = 0; i < values.size(); ++i)
      set.ticks[i].label = powerLabel(values[i]);
    return;
  }
  set.exponent = greatest >= 5 || (greatest <= -4 && greatest > -400) ? greatest : 0;
  const int common = decimalsOf(values, set.exponent);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    // On a logarithmic scale each label has its own digits: 0.1, 1, 10.
    const int decimals = isLogarithmic ? decimalsOf({values[i]}, set.exponent) : common;
    const double shown = RoundValue{values[i].mantissa, values[i].exponent - set.exponent}.value();
    set.ticks[i].label = fixed(shown, std::max(0, decimals));
  }
}

} // namespace

double TickScale::shareOf(double value) const
{
  if (low == high)
    return 0.5;
  return isLogarithmic ? (std::log(value) - std::log(low)) / (std::log(high) - std::log(low))
                       : (value / 2 - low / 2) / (high / 2 - low / 2);
}

double TickScale::valueAt(double share) const
{
  return isLogarithmic ? std::exp((1.0 - share) * std::log(low) + share * std::log(high))
                       : (1.0 - share) * low + share * high;
}

TickSet makeTicks(const TickScale& scale, int count, double minimumShare, const std::string& format)
{
  TickSet set;
  if (scale.low == scale.high)
  {
    const std::string label =
      withMinusSign(formatted(format.empty() ? "%.6g" : format.c_str(), scale.low));
    set.ticks.push_back({scale.low, label, 0.5});
    return set;
  }
  std::vector<RoundValue> values;
  do
  {
    values = scale.isLogarithmic ? logarithmicValues(scale, count) : linearValues(scale, count);
  } while (smallestGap(scale, values) < minimumShare && count-- > 2);
  if (scale.isLogarithmic)
  {
    const double decades = std::log10(scale.high) - std::log10(scale.low);
    const double minimumDecade = 1.8 * minimumShare; // has room for nine marks
    for (const RoundValue& value :
      decades* minimumDecade <= 1.0
        ? decadeValues(scale, {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0}, 1)
        : decadeValues(scale, {1.0}, 1))
      set.minor.push_back(std::clamp(scale.shareOf(value.value()), 0.0, 1.0));
  }
  if (scale.isLogarithmic)
    addEnds(scale, minimumShare, values);
  for (const RoundValue& value : values)
  {
    const double inside = std::clamp(value.value(), scale.low, scale.high);
    set.ticks.push_back({inside, "", std::clamp(scale.shareOf(inside), 0.0, 1.0)});
  }
  if (format.empty())
    labelTicks(set, values, scale.isLogarithmic);
  else
    for (Tick& tick : set.ticks)
      tick.label = withMinusSign(formatted(format.c_str(), tick.value));
  return set;
}

bool isDoubleFormat(const std::string& format)
{
  int conversions = 0;
  for (std::size_t i = 0; i < format.size(); ++i)
  {
    if (format[i] != '%')
      continue;
    if (++i < format.size() && format[i] == '%')
      continue;
    const auto skip = [&](const char* set, std::size_t most)
    {
      const std::size_t begin = i;
      i = std::min(format.find_first_not_of(set, i), format.size());
      return i - begin <= most;
    };
    bool isShort = skip("-+ #0", 5) && skip("0123456789", 2);
    if (i < format.size() && format[i] == '.')
    {
      ++i;
      isShort = skip("0123456789", 2) && isShort;
    }
    if (!isShort || i >= format.size() ||
        std::string("eEfFgG").find(format[i]) == std::string::npos)
      return false;
    ++conversions;
  }
  return conversions == 1 && format.size() < 100;
}

std::string powerOfTen(int exponent)
{
  static const char* const Raised[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074", "\u2075",
    "\u2076", "\u2077", "\u2078", "\u2079"};
  std::string text = exponent < 0 ? "10\u207b" : "10";
  for (const char digit : std::to_string(std::abs(exponent)))
    text += Raised[digit - '0'];
  return text;
}

} // namespace mote::imaging
