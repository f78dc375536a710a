#include "DataUnits.h"

#include "stage/Arrays.h"

#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkPointData.h>

namespace mote::app
{

std::optional<Unit> knownUnit(const std::vector<NamedData>& data, const std::string& array)
{
  for (const NamedData& one : data)
    if (const std::string unit = array.empty() ? lengthUnitOf(one.data) : unitOf(one.data, array);
        !unit.empty())
      return Unit::parse(unit);
  return {};
}

std::string timeUnitOf(const std::vector<NamedData>& data)
{
  const auto length = knownUnit(data);
  if (!length)
    return {};
  const Unit second = *Unit::parse("s");
  for (const NamedData& one : data)
    for (vtkFieldData* arrays : {static_cast<vtkFieldData*>(one.data->GetPointData()),
           static_cast<vtkFieldData*>(one.data->GetCellData())})
      for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
        if (const char* name = arrays->GetArrayName(i))
          if (const auto unit = knownUnit({one}, name); unit && *length / *unit == second)
            return second.text();
  return {};
}

std::string withUnit(const std::string& name, const std::string& unit)
{
  return unit.empty() ? name : name + " (" + unit + ")";
}

} // namespace mote::app
