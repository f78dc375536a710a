#ifndef MoteStoreNumber_h
#define MoteStoreNumber_h

#include "TextRows.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace mote
{

/// A number as one of a whole type; what does not fit becomes the nearest that does, and what is no
/// number 0.
template <class Whole, class Number>
Whole wholeOf(Number value)
{
  if constexpr (std::is_floating_point_v<Number>)
  {
    constexpr auto least = static_cast<Number>(std::numeric_limits<Whole>::min());
    constexpr auto most = -least; // one more than there is
    return value >= most    ? std::numeric_limits<Whole>::max()
           : value >= least ? static_cast<Whole>(value)
           : value < least  ? std::numeric_limits<Whole>::min()
                            : Whole{0};
  }
  else
    return static_cast<Whole>(value);
}

/// Stores a number as the column's type says; nowhere where the column has no space.
template <class Number>
void storeNumber(const TextColumn& column, std::uint64_t row, Number value)
{
  if (!column.data)
    return;
  const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(row) * column.stride;
  switch (column.type)
  {
  case ColumnType::Int32:
    static_cast<std::int32_t*>(column.data)[at] = wholeOf<std::int32_t>(value);
    break;
  case ColumnType::Int64:
    static_cast<std::int64_t*>(column.data)[at] = wholeOf<std::int64_t>(value);
    break;
  case ColumnType::Float32:
    static_cast<float*>(column.data)[at] = static_cast<float>(value);
    break;
  case ColumnType::Float64:
    static_cast<double*>(column.data)[at] = static_cast<double>(value);
    break;
  default:
    break;
  }
}

} // namespace mote

#endif
