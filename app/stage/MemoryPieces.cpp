#include "MemoryPieces.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

namespace mote::app
{

namespace
{

constexpr std::size_t kibi = 1024; // VTK's unit

} // namespace

void addMemory(MemoryPieces& pieces, vtkDataSet* data)
{
  std::size_t ofArrays = 0;
  const auto add = [&](vtkAbstractArray* array)
  {
    if (!array)
      return;
    pieces.emplace_back(array, kibi * array->GetActualMemorySize());
    ofArrays += pieces.back().second;
  };
  for (const int type : {vtkDataObject::POINT, vtkDataObject::CELL, vtkDataObject::FIELD})
    if (vtkFieldData* arrays = data->GetAttributesAsFieldData(type))
      for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
        add(arrays->GetAbstractArray(i));
  if (auto* set = vtkPointSet::SafeDownCast(data); set && set->GetPoints())
    add(set->GetPoints()->GetData());
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data); grid && grid->GetCells())
  {
    add(grid->GetCells()->GetConnectivityArray());
    add(grid->GetCells()->GetOffsetsArray());
    add(grid->GetCellTypesArray());
    add(grid->GetFaces());
    add(grid->GetFaceLocations());
  }
  const std::size_t all = kibi * data->GetActualMemorySize();
  pieces.emplace_back(data, all > ofArrays ? all - ofArrays : 0);
}

std::uint64_t MemorySum::more(const MemoryPieces& pieces) const
{
  std::unordered_set<const void*> own;
  std::uint64_t sum = 0;
  for (const auto& [piece, bytes] : pieces)
    if (!counted_.contains(piece) && own.insert(piece).second)
      sum += bytes;
  return sum;
}

void MemorySum::add(const MemoryPieces& pieces)
{
  for (const auto& [piece, bytes] : pieces)
    if (counted_.insert(piece).second)
      bytes_ += bytes;
}

} // namespace mote::app
