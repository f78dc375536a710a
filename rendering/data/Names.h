#pragma once

#include "MoteRenderingDataModule.h" // For export macro

#include <cstddef>
#include <string>
#include <vector>

class vtkFieldData;

namespace mote
{

/// The names of the arrays, separated by commas, for messages; "none" where there is none.
MOTERENDERINGDATA_EXPORT std::string arrayNames(vtkFieldData* data);

/// Place of a name among others; the first for none. Throws Error, calling it a `what`, where it is
/// not among them.
MOTERENDERINGDATA_EXPORT std::size_t findName(
  const std::vector<std::string>& names, const char* name, const char* what);

} // namespace mote
