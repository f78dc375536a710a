#ifndef MoteParseNumber_h
#define MoteParseNumber_h

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <locale.h>
#include <string>

namespace mote
{

/// Numbers from text, for inner loops. The text must end with a line end somewhere, so that no
/// bound is tested. A token ends at any character up to ' ' (blanks, tabs, line ends).

inline bool endsToken(char c)
{
  return static_cast<unsigned char>(c) <= ' ';
}

inline const char* tokenEnd(const char* p)
{
  while (!endsToken(*p))
    ++p;
  return p;
}

/// Moves past a sign; whether it was a minus.
inline bool passSign(const char*& p)
{
  const bool negative = *p == '-';
  p += negative || *p == '+';
  return negative;
}

/// Moves past decimal digits, and appends them to those of `digits`.
inline void passDigits(const char*& p, std::uint64_t& digits)
{
  for (unsigned digit = 0; (digit = static_cast<unsigned char>(*p) - '0') <= 9; ++p)
    digits = 10 * digits + digit;
}

/// The general case: any length, any exponent, nan and inf. See parseDouble.
inline const char* parseDoubleSlowly(const char* begin, double& value)
{
  const char* const end = tokenEnd(begin);
  const char* p = begin;
  if (*p == '+')
  {
    ++p; // from_chars does not know it
    if (*p == '-')
      return nullptr;
  }
  if (const auto* const fortran = std::find_if(p, end, [](char c) { return (c | 0x20) == 'd'; });
      fortran != end)
  {
    std::string text(begin, end);
    text[static_cast<std::size_t>(fortran - begin)] = 'e';
    text.push_back('\n');
    return std::find_if(fortran + 1, end, [](char c) { return (c | 0x20) == 'd'; }) == end &&
               parseDoubleSlowly(text.c_str(), value)
             ? end
             : nullptr;
  }
  const auto [stop, error] = std::from_chars(p, end, value);
  if (stop != end || error == std::errc::invalid_argument)
    return nullptr;
  if (error == std::errc::result_out_of_range)
  {
    // What is too small for a double is zero or nearly so; what is too large is no value.
    // Programs may write decimal commas.
    static const locale_t plain = ::newlocale(LC_NUMERIC_MASK, "C", nullptr);
    value = ::strtod_l(std::string(p, end).c_str(), nullptr, plain);
    return std::abs(value) < 1.0 ? end : nullptr;
  }
  return end;
}

/// Parses the token at `p` and returns its end, or null when the token is no number. The value is
/// the double nearest to the decimal, as strtod gives it; Fortran's 1.5D3 is 1500.
///
/// Short decimals take the exact shortcut of Clinger (How to read floating point numbers
/// accurately, 1990): an integer below 2^53 times or over a power of ten up to 10^22 is one
/// rounding of two exact doubles.
inline const char* parseDouble(const char* begin, double& value)
{
  static constexpr double Powers[] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11,
    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  const char* p = begin;
  const bool negative = passSign(p);
  const char* const first = p;
  std::uint64_t digits = 0;
  passDigits(p, digits);
  std::ptrdiff_t count = p - first;
  std::ptrdiff_t exponent = 0;
  if (*p == '.')
  {
    const char* const fraction = ++p;
    passDigits(p, digits);
    exponent = fraction - p;
    count -= exponent;
  }
  if ((*p & 0xDE) == 'D') // e, E, and d, D as Fortran writes them
  {
    const bool down = passSign(++p);
    const char* const power = p;
    std::ptrdiff_t written = 0;
    unsigned digit = 0;
    for (; (digit = static_cast<unsigned char>(*p) - '0') <= 9 && p - power < 4; ++p)
      written = 10 * written + digit;
    if (p == power)
      return nullptr;
    exponent += down ? -written : written;
  }
  // Nineteen digits always fit into 64 bits.
  if (endsToken(*p) && count > 0 && count <= 19 && digits <= (std::uint64_t{1} << 53) &&
      exponent >= -22 && exponent <= 22)
  {
    const auto exact = static_cast<double>(digits);
    const double size = exponent < 0 ? exact / Powers[-exponent] : exact * Powers[exponent];
    value = negative ? -size : size;
    return p;
  }
  return parseDoubleSlowly(begin, value);
}

/// The same for an integer that fits into `Integer`; null also for what does not fit.
template <class Integer>
const char* parseInteger(const char* begin, Integer& value)
{
  const char* p = begin;
  const bool negative = passSign(p);
  const char* const first = p;
  std::uint64_t digits = 0;
  passDigits(p, digits);
  if (p == first || !endsToken(*p))
    return nullptr;
  if (p - first <= 18)
  {
    const auto size = static_cast<std::int64_t>(digits);
    const std::int64_t whole = negative ? -size : size;
    value = static_cast<Integer>(whole);
    return value == whole ? p : nullptr;
  }
  const auto [stop, error] = std::from_chars(*begin == '+' ? first : begin, p, value);
  return stop == p && error == std::errc() ? p : nullptr;
}

} // namespace mote

#endif
