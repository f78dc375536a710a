#include "FieldArrays.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"

#include <algorithm>

namespace mote
{

namespace
{

NamedArray nameOf(vtkDataArray* array, const ArrayView& view)
{
  NamedArray one{array->GetName(), view, {}};
  if (array->HasAComponentName())
    for (int k = 0; k < array->GetNumberOfComponents(); ++k)
      one.components.emplace_back(array->GetComponentName(k) ? array->GetComponentName(k) : "");
  return one;
}

} // namespace

FieldArrays::FieldArrays(vtkFieldData* field, const std::vector<std::string>& unwanted)
{
  for (int i = 0; i < field->GetNumberOfArrays(); ++i)
  {
    const std::string name = field->GetArrayName(i) ? field->GetArrayName(i) : "";
    vtkDataArray* array = field->GetArray(i);
    if (!name.empty() && std::find(unwanted.begin(), unwanted.end(), name) != unwanted.end())
      continue;
    if (array && !name.empty())
    {
      views.emplace_back(array);
      named.push_back(nameOf(array, views.back().view));
    }
    else
      leftOut += (leftOut.empty() ? "" : ", ") + (name.empty() ? "(unnamed)" : name);
  }
}

bool FieldArrays::has(const std::string& name) const
{
  return std::any_of(named.begin(), named.end(), [&](const auto& a) { return a.name == name; });
}

} // namespace mote
