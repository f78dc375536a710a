#include "IdRanges.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace mote::app
{

IdRanges::IdRanges(std::vector<IdRange> ranges)
{
  std::sort(ranges.begin(), ranges.end(),
    [](const IdRange& a, const IdRange& b)
    { return std::tie(a.part, a.low, a.high) < std::tie(b.part, b.low, b.high); });
  std::vector<IdRange> apart;
  for (const IdRange& range : ranges)
  {
    const bool isNext = !apart.empty() && apart.back().part == range.part &&
                        (range.low <= apart.back().high || range.low - 1 == apart.back().high);
    if (isNext)
      apart.back().high = std::max(apart.back().high, range.high);
    else
      apart.push_back(range);
  }
  if (!apart.empty())
    ranges_ = std::make_shared<const std::vector<IdRange>>(std::move(apart));
}

const std::vector<IdRange>& IdRanges::list() const
{
  static const std::vector<IdRange> none;
  return ranges_ ? *ranges_ : none;
}

std::int64_t IdRanges::count() const
{
  constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
  std::int64_t count = 0;
  for (const IdRange& range : this->list())
  {
    const std::uint64_t ids =
      static_cast<std::uint64_t>(range.high) - static_cast<std::uint64_t>(range.low) + 1;
    if (ids > static_cast<std::uint64_t>(most - count))
      return most;
    count += static_cast<std::int64_t>(ids);
  }
  return count;
}

std::vector<std::pair<std::int64_t, std::int64_t>> IdRanges::of(int part) const
{
  std::vector<IdRange> own;
  for (const IdRange& range : this->list())
    if (range.part == 0 || range.part == part)
      own.push_back({0, range.low, range.high});
  const IdRanges apart(std::move(own));
  std::vector<std::pair<std::int64_t, std::int64_t>> pairs;
  for (const IdRange& range : apart.list())
    pairs.emplace_back(range.low, range.high);
  return pairs;
}

IdRanges IdRanges::with(const IdRanges& more) const
{
  std::vector<IdRange> both = this->list();
  both.insert(both.end(), more.list().begin(), more.list().end());
  return IdRanges(std::move(both));
}

bool holds(const std::vector<std::pair<std::int64_t, std::int64_t>>& ranges, std::int64_t id)
{
  const auto after = std::upper_bound(ranges.begin(), ranges.end(), id,
    [](std::int64_t value, const auto& range) { return value < range.first; });
  return after != ranges.begin() && id <= std::prev(after)->second;
}

} // namespace mote::app
