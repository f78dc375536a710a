#pragma once

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkLookupTable;

namespace mote::app
{

/// The names that makeColorMap() knows, the default first; "types", the last, is for few integers.
const std::vector<std::string>& colorMapNames();

/// A table of 256 colours between the ends of `range`; "types" gives one colour to each integer
/// from range[0] to range[1] instead, and the table then spans half a number more at both ends.
vtkSmartPointer<vtkLookupTable> makeColorMap(
  const std::string& name, const double range[2], bool logarithmic);

} // namespace mote::app
