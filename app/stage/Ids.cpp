#include "Ids.h"

#include "Part.h"
#include "base/Text.h"

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace mote::app
{

vtkDataArray* idArrayOf(vtkDataSet* data)
{
  vtkPointData* arrays = data->GetPointData();
  const auto isUsable = [&](vtkDataArray* array)
  {
    return array && array->GetNumberOfComponents() == 1 &&
           array->GetNumberOfTuples() == data->GetNumberOfPoints();
  };
  for (const char* wanted : {"id", "ids", "particleids", "particleid", "particle_id", "globalids",
         "globalpointids", "global_id", "atom_id", "atomid", "vtkoriginalpointids"})
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
      if (vtkDataArray* array = arrays->GetArray(i);
          isUsable(array) && lowerCase(nameOf(array)) == wanted)
        return array;
  return isUsable(arrays->GetGlobalIds()) ? arrays->GetGlobalIds() : nullptr;
}

std::int64_t idOf(vtkDataArray* ids, vtkIdType particle)
{
  return ids ? static_cast<std::int64_t>(ids->GetComponent(particle, 0)) : particle;
}

void addIdMarks(
  const std::vector<NamedData>& data, const SelectionSettings& selection, const std::string& name)
{
  for (std::size_t k = 0; k < data.size(); ++k)
  {
    vtkDataSet* particles = data[k].data;
    if (Part::isMesh(particles))
      continue;
    const vtkIdType count = particles->GetNumberOfPoints();
    auto* marks =
      vtkUnsignedCharArray::SafeDownCast(particles->GetPointData()->GetArray(name.c_str()));
    if (!marks)
    {
      vtkNew<vtkUnsignedCharArray> all;
      all->SetName(name.c_str());
      all->SetNumberOfValues(count);
      std::fill_n(all->GetPointer(0), count, 1);
      particles->GetPointData()->AddArray(all);
      marks = all;
    }
    const int part = static_cast<int>(k) + 1;
    const auto hidden = selection.hidden.of(part), only = selection.only.of(part);
    const bool isAll = selection.only.empty();
    vtkDataArray* ids = idArrayOf(particles);
    unsigned char* values = marks->GetPointer(0);
    tbb::parallel_for(tbb::blocked_range<vtkIdType>(0, count, 1 << 14),
      [&](const tbb::blocked_range<vtkIdType>& range)
      {
        for (vtkIdType i = range.begin(); i != range.end(); ++i)
        {
          const std::int64_t id = idOf(ids, i);
          if (holds(hidden, id) || !(isAll || holds(only, id)))
            values[i] = 0;
        }
      });
  }
}

} // namespace mote::app
