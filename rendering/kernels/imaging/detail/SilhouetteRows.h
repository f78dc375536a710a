#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mote
{

/// The silhouette pixels of one row, by column: pointers count from column 0 of the image.
struct SilhouetteRow
{
  /// Codes: one of the sixteen directions, in 22.5 degrees from +x, in which the nearer pixels lie;
  /// or no direction at all; or no silhouette pixel. Those without a direction have the highest bit
  /// set, and the last has all.
  static constexpr std::uint8_t round = 0x80, none = 0xff;
  static constexpr int directions = 16;
  /// Levels of thickness. Opacities are multiples of 1 / 254, which has a half.
  static constexpr int levels = 8;
  static constexpr int opaque = 254;

  std::uint8_t* code = nullptr;
  std::uint8_t* level = nullptr;   ///< in [0, levels), of silhouette pixels
  std::uint8_t* opacity = nullptr; ///< in [0, opaque], of silhouette pixels
  bool* any = nullptr;             ///< whether there are silhouette pixels in the row
};

/// The silhouette pixels of the last few rows, in a ring.
class SilhouetteRows
{
public:
  /// For columns [begin, end), and rows that are at most 2 `reach` apart. Up to `reach` columns and
  /// a vector beyond both ends there are no silhouette pixels.
  SilhouetteRows(int begin, int end, int reach)
    : begin_(begin)
    , count_(2 * reach + 1)
    , spare_(reach + vectorBytes)
    , length_(end - begin + 2 * spare_)
    , values_(static_cast<std::size_t>(3 * length_) * count_, SilhouetteRow::none)
    , any_(count_)
  {
  }

  /// Clears a row's place in the ring.
  SilhouetteRow cleared(int y)
  {
    const SilhouetteRow row = (*this)[y];
    if (*row.any)
      std::fill_n(row.code - spare_ + begin_, length_, SilhouetteRow::none);
    *row.any = false;
    return row;
  }

  SilhouetteRow operator[](int y)
  {
    const int place = y % count_;
    std::uint8_t* first = values_.data() + 3 * length_ * place + (spare_ - begin_);
    return {first, first + length_, first + 2 * length_, &any_[place].value};
  }

private:
  struct Flag
  {
    bool value = false;
  };

  static constexpr int vectorBytes = 64;

  int begin_, count_, spare_;
  std::ptrdiff_t length_;
  std::vector<std::uint8_t> values_;
  std::vector<Flag> any_;
};

} // namespace mote
