#pragma once

#include "ArrayView.h"

#include <array>
#include <string>
#include <vector>

namespace mote
{

/// An array with the names that a file keeps for it.
struct NamedArray
{
  std::string name;
  ArrayView values;
  std::vector<std::string> components; ///< a name each, or none
};

/// An array of a file, with what is known of its values.
struct FileArray : NamedArray
{
  /// Least and greatest; the first above the second where there is no value.
  using Range = std::array<double, 2>;

  std::vector<Range> ranges; ///< of finite values: of each component, then of the magnitude
  bool finite = true;        ///< whether all values are
};

} // namespace mote
