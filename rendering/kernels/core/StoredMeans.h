#pragma once

#include "ArrayView.h"

#include <cstddef>
#include <vector>

namespace mote
{

/// Means over what levels of detail stand for, which a file holds for its arrays. Of each array
/// those of its components and, where it has several, of the magnitude: rows of a float for each
/// place.
class StoredMeans
{
public:
  /// Rows of an array; 0 of those that have no means: 8-bit colours, which are used as they are.
  static std::size_t rowsOf(ArrayView::Type type, int components)
  {
    if (components > 1 && type == ArrayView::Type::UInt8)
      return 0;
    return components > 1 ? static_cast<std::size_t>(components) + 1 : 1;
  }
  static int componentOf(std::size_t row, int components)
  {
    return static_cast<int>(row) < components ? static_cast<int>(row) : ArrayView::magnitude;
  }

  /// `rows` are there as long as the values are.
  void add(const ArrayView& values, const float* rows, std::size_t places)
  {
    entries_.push_back({values, rows, places});
  }

  /// One number for each place. Empty where there are none of these values.
  ArrayView find(const ArrayView& values, int component) const
  {
    for (const Entry& entry : entries_)
      for (std::size_t row = 0; row < rowsOf(values.type(), values.components()); ++row)
        if (entry.values == values && componentOf(row, values.components()) == component)
          return {entry.rows + row * entry.places, entry.places, 1};
    return {};
  }

private:
  struct Entry
  {
    ArrayView values;
    const float* rows;
    std::size_t places;
  };
  std::vector<Entry> entries_;
};

} // namespace mote
