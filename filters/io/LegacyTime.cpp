#include "LegacyTime.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace mote
{
namespace
{

/// A binary number; those of legacy files are big-endian.
template <class Number, class Bits>
std::optional<double> binaryNumber(std::string_view text)
{
  if (text.size() < sizeof(Bits))
    return std::nullopt;
  Bits bits = 0;
  for (const char byte : text.substr(0, sizeof(Bits)))
    bits = bits << 8 | static_cast<unsigned char>(byte);
  return std::bit_cast<Number>(bits);
}

std::optional<double> textNumber(std::string_view text)
{
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  // A number at the very end may have been cut.
  return error == std::errc() && stop != end ? std::optional(value) : std::nullopt;
}

} // namespace

std::optional<double> legacyTime(std::string_view beginning)
{
  if (!beginning.starts_with("# vtk DataFile"))
    return std::nullopt;
  constexpr std::string_view name = "\nTimeValue 1 1 ";
  const std::size_t at = beginning.find(name);
  const std::size_t line = at == beginning.npos ? at : beginning.find('\n', at + 1);
  if (line == beginning.npos)
    return std::nullopt;
  const std::size_t typeAt = at + name.size();
  const std::string_view type = beginning.substr(typeAt, line - typeAt);
  const std::string_view value = beginning.substr(line + 1);
  const bool isDouble = type == "double";
  std::optional<double> time;
  if (!isDouble && type != "float")
    return std::nullopt;
  if (beginning.substr(0, at).find("\nBINARY") != beginning.npos)
  {
    time = isDouble ? binaryNumber<double, std::uint64_t>(value)
                    : binaryNumber<float, std::uint32_t>(value);
  }
  else
  {
    time = textNumber(value);
  }
  return time && std::isfinite(*time) ? time : std::nullopt;
}

} // namespace mote
