#include "Names.h"

#include "kernels/core/Error.h"

#include "vtkFieldData.h"

#include <algorithm>

namespace mote
{

std::string arrayNames(vtkFieldData* data)
{
  std::string names;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    if (const char* name = data->GetArrayName(i))
      names += (names.empty() ? "" : ", ") + std::string(name);
  return names.empty() ? "none" : names;
}

std::size_t findName(const std::vector<std::string>& names, const char* name, const char* what)
{
  const auto found = name && *name ? std::find(names.begin(), names.end(), name) : names.begin();
  if (found != names.end())
    return static_cast<std::size_t>(found - names.begin());
  std::string known;
  for (const std::string& n : names)
    known += (known.empty() ? "" : ", ") + n;
  throw Error(std::string("There is no ") + what + " \"" + name + "\"; there are: " + known + ".");
}

} // namespace mote
