#ifndef MoteFieldArrays_h
#define MoteFieldArrays_h

#include "DataArrayView.h"

#include "kernels/core/FileArray.h"

#include <string>
#include <vector>

class vtkFieldData;

namespace mote
{

/// The arrays of numbers of a field as the kernels write them, and what keeps them in memory.
struct FieldArrays
{
  std::vector<NamedArray> named;
  std::vector<DataArrayView> views;
  std::string leftOut; ///< names of the others, with commas

  /// All of the field's but those of these names.
  explicit FieldArrays(vtkFieldData* field, const std::vector<std::string>& unwanted = {});

  bool has(const std::string& name) const;
};

} // namespace mote

#endif
