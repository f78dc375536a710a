#include "vtkMoteMeshStatistics.h"

#include "DataSetMismatch.h"
#include "DataSetParts.h"
#include "MeshStatistics.h"
#include "TableColumns.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkMoteMeshStatistics);

namespace
{

void addCells(mote::TableColumns& row, const mote::CellStatistics& cells)
{
  const auto known = [](double value, bool any) { return any ? value : std::nan(""); };
  const bool any = cells.taken() > 0, anyVolume = any || cells.polyhedra > 0;
  row.Add("cells", cells.cells);
  row.Add("hexahedra", cells.hexahedra);
  row.Add("wedges", cells.wedges);
  row.Add("pyramids", cells.pyramids);
  row.Add("tetrahedra", cells.tetrahedra);
  row.Add("polyhedra", cells.polyhedra);
  row.Add("other", cells.other);
  row.Add("inverted", cells.inverted);
  row.Add("zero_volume", cells.zeroVolume);
  row.Add("non_finite", cells.nonFinite);
  row.Add("volume", cells.volume);
  row.Add("min_volume", known(cells.minVolume, anyVolume));
  row.Add("max_volume", known(cells.maxVolume, anyVolume));
  row.Add("min_scaled_jacobian", known(cells.minScaledJacobian, any));
  row.Add("mean_scaled_jacobian",
    known(
      cells.sumScaledJacobian / static_cast<double>(std::max<vtkIdType>(1, cells.taken())), any));
  row.Add("max_aspect_ratio", known(cells.maxAspectRatio, any));
}

void addArray(mote::TableColumns& row, const mote::MeasuredArray& measured)
{
  const mote::ArrayStatistics& statistics = measured.statistics;
  const bool any = statistics.min <= statistics.max;
  row.Add("array", std::string(measured.array->GetName()));
  row.Add("of", std::string(measured.ofCells ? "cell" : "point"));
  row.Add("components", static_cast<vtkIdType>(measured.array->GetNumberOfComponents()));
  row.Add("min", any ? statistics.min : std::nan(""));
  row.Add("mean",
    any && statistics.volume > 0.0 ? statistics.integral / statistics.volume : std::nan(""));
  row.Add("max", any ? statistics.max : std::nan(""));
  row.Add("non_finite", statistics.nonFinite);
}

} // namespace

vtkMoteMeshStatistics::vtkMoteMeshStatistics()
{
  this->SetNumberOfOutputPorts(2);
}

vtkMoteMeshStatistics::~vtkMoteMeshStatistics() = default;

int vtkMoteMeshStatistics::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkMoteMeshStatistics::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  mote::TableColumns cells, arrays;
  if (const std::string mismatch = mote::mismatchOf(input); !mismatch.empty())
  {
    vtkErrorMacro(<< mismatch << ".");
    return 0;
  }
  for (const mote::DataSetPart& part : mote::partsOf(input))
  {
    const mote::MeshStatistics statistics = mote::statisticsOf(part.data);
    cells.Add("block", part.name);
    addCells(cells, statistics.cells);
    for (const mote::MeasuredArray& measured : statistics.arrays)
    {
      arrays.Add("block", part.name);
      addArray(arrays, measured);
    }
  }
  const mote::TableColumns* columns[2] = {&cells, &arrays};
  for (int i = 0; i < 2; ++i)
  {
    vtkTable* table = vtkTable::GetData(outputVector, i);
    table->Initialize();
    columns[i]->FillTable(table);
  }
  return 1;
}

void vtkMoteMeshStatistics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
