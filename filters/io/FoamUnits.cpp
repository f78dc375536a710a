#include "FoamUnits.h"

#include "TextFile.h"

#include <array>
#include <charconv>
#include <cmath>

namespace mote
{

std::string foamUnitOf(const std::string& path)
{
  // They stand behind the head, before any values.
  const std::string text = readBeginning(path, 8192);
  const std::size_t head = text.find("FoamFile");
  const std::size_t key = head == text.npos ? head : text.find("\ndimensions", head);
  const std::size_t open = key == text.npos ? key : text.find('[', key);
  const std::size_t close = open == text.npos ? open : text.find(']', open);
  if (close == text.npos)
    return {};
  constexpr std::array<const char*, 7> names = {"kg", "m", "s", "K", "mol", "A", "cd"};
  std::string unit;
  std::size_t count = 0;
  const char* at = text.data() + open + 1;
  const char* const end = text.data() + close;
  for (; at < end; ++count)
  {
    while (at < end && (*at == ' ' || *at == '\t' || *at == '\n' || *at == '\r'))
      ++at;
    if (at == end)
      break;
    double power = 0.0;
    const auto [stop, error] = std::from_chars(at, end, power);
    if (error != std::errc() || count == names.size())
      return {};
    at = stop;
    if (power == 0.0)
      continue;
    if (power != std::round(power) || std::abs(power) > 99.0)
      return {}; // roots have no name
    unit += (unit.empty() ? "" : " ") + std::string(names[count]);
    if (power != 1.0)
      unit += '^' + std::to_string(static_cast<int>(power));
  }
  return count < 5 ? std::string() : unit.empty() ? "1" : unit;
}

} // namespace mote
