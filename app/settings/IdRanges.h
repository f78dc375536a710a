#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace mote::app
{

/// The ids from `low` to `high`, both included, of the particles of a data set, which counts from
/// 1, or of all data sets: 0.
struct IdRange
{
  int part = 0;
  std::int64_t low = 0, high = 0;
  bool operator==(const IdRange&) const = default;
};

/// Any number of ids, as ranges that ascend and neither meet nor overlap. There may be millions,
/// and settings are copied often: copies share them.
class IdRanges
{
public:
  IdRanges() = default;
  /// In any order; those that meet or overlap become one.
  explicit IdRanges(std::vector<IdRange> ranges);

  bool empty() const { return !ranges_ || ranges_->empty(); }
  const std::vector<IdRange>& list() const;
  /// How many ids there are.
  std::int64_t count() const;
  /// The ids of a data set, from and to, ascending; those of all data sets included.
  std::vector<std::pair<std::int64_t, std::int64_t>> of(int part) const;
  /// Both together.
  IdRanges with(const IdRanges& more) const;

  friend bool operator==(const IdRanges& a, const IdRanges& b)
  {
    return a.ranges_ == b.ranges_ || a.list() == b.list();
  }

private:
  std::shared_ptr<const std::vector<IdRange>> ranges_;
};

/// Whether one of the ranges of IdRanges::of() holds the id.
bool holds(const std::vector<std::pair<std::int64_t, std::int64_t>>& ranges, std::int64_t id);

} // namespace mote::app
