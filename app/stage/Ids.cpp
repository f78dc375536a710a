#include "Ids.h"

#include "Part.h"
#include "base/Text.h"

#include <vtkCellData.h>
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

namespace
{

/// Whether some of the ids may be of the data sets that are meshes, or of those that are not.
bool isOf(const IdRanges& ids, const std::vector<NamedData>& data, bool meshes)
{
  return std::any_of(ids.list().begin(), ids.list().end(),
    [&](const IdRange& range)
    {
      const auto k = static_cast<std::size_t>(range.part) - 1;
      return range.part == 0 || (k < data.size() && Part::isMesh(data[k].data) == meshes);
    });
}

/// The array of marks, of 1 where there was none.
vtkUnsignedCharArray* marksOf(vtkDataSetAttributes* arrays, vtkIdType count, const char* name)
{
  if (auto* marks = vtkUnsignedCharArray::SafeDownCast(arrays->GetArray(name)))
    return marks;
  vtkNew<vtkUnsignedCharArray> all;
  all->SetName(name);
  all->SetNumberOfValues(count);
  std::fill_n(all->GetPointer(0), count, 1);
  arrays->AddArray(all);
  return all;
}

} // namespace

void addIdMarks(
  const std::vector<NamedData>& data, const SelectionSettings& selection, const std::string& name)
{
  for (std::size_t k = 0; k < data.size(); ++k)
  {
    vtkDataSet* one = data[k].data;
    const bool isMesh = Part::isMesh(one);
    const bool isHiding = isOf(selection.hidden, data, isMesh);
    const bool isAll = !isOf(selection.only, data, isMesh);
    if (!isHiding && isAll)
      continue;
    const vtkIdType count = isMesh ? one->GetNumberOfCells() : one->GetNumberOfPoints();
    vtkDataSetAttributes* arrays = one->GetPointData();
    if (isMesh)
      arrays = one->GetCellData();
    unsigned char* values = marksOf(arrays, count, name.c_str())->GetPointer(0);
    const int part = static_cast<int>(k) + 1;
    const auto hidden = selection.hidden.of(part), only = selection.only.of(part);
    vtkDataArray* ids = isMesh ? nullptr : idArrayOf(one);
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
