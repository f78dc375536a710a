#include "vtkMoteVolumeQuantiles.h"

#include "CollapsedCell.h"
#include "DataSetMismatch.h"
#include "DataSetParts.h"
#include "ForRanges.h"
#include "MeshStatistics.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

vtkStandardNewMacro(vtkMoteVolumeQuantiles);

namespace
{

/// A value and the volume that has it.
struct Sample
{
  double value, volume;
};

/// The eight samples of the cell that was read: of a polyhedron some of its points have as much
/// each.
void sample(mote::CellReader& reader, mote::CellReader::Answer answer,
  const mote::CollapsedCell& cell, const std::function<double(vtkIdType)>& valueAt, Sample* to)
{
  const auto put = [&](int k, vtkIdType point, double volume)
  {
    if (const double value = valueAt(point); std::isfinite(value))
      to[k] = {value, volume};
  };
  if (answer == mote::CellReader::Answer::Taken)
  {
    const auto volumes = cell.cornerVolumes();
    for (int k = 0; k < 8; ++k)
      put(k, cell.ids[k], std::abs(volumes[k]));
  }
  if (answer != mote::CellReader::Answer::InParts)
    return;
  double volume = 0.0;
  for (const mote::CollapsedCell& part : reader.parts())
    for (const double corner : part.cornerVolumes())
      volume += std::abs(corner);
  for (std::size_t k = 0; k < 8; ++k)
    put(static_cast<int>(k), reader.points()[k * reader.points().size() / 8], 0.125 * volume);
}

/// The samples of every `step`th cell, eight each; those without a value have no volume.
std::vector<Sample> samplesOf(
  vtkDataSet* data, vtkDataArray* array, bool ofCells, int component, vtkIdType step)
{
  const vtkIdType cells = (data->GetNumberOfCells() + step - 1) / step;
  std::vector<Sample> samples(static_cast<std::size_t>(8 * cells), Sample{0.0, 0.0});
  const mote::CellReader first(data);
  mote::forRanges(cells,
    [&](vtkIdType begin, vtkIdType end)
    {
      mote::CellReader reader(first);
      mote::CollapsedCell cell;
      for (vtkIdType i = begin; i < end; ++i)
      {
        const vtkIdType id = i * step;
        const auto answer = reader.read(id, cell);
        sample(
          reader, answer, cell,
          [&](vtkIdType point) { return mote::valueOf(array, ofCells ? id : point, component); },
          &samples[static_cast<std::size_t>(8 * i)]);
      }
    });
  return samples;
}

} // namespace

vtkMoteVolumeQuantiles::vtkMoteVolumeQuantiles() = default;
vtkMoteVolumeQuantiles::~vtkMoteVolumeQuantiles() = default;

int vtkMoteVolumeQuantiles::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkMoteVolumeQuantiles::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  this->Values.clear();
  this->Shares.clear();
  if (const std::string mismatch = mote::mismatchOf(input); !mismatch.empty())
  {
    vtkErrorMacro(<< mismatch << ".");
    return 0;
  }
  const auto parts = mote::partsOf(input);
  vtkIdType cells = 0;
  for (const mote::DataSetPart& part : parts)
    cells += part.data->GetNumberOfCells();
  const vtkIdType step =
    (cells + this->MaximumNumberOfCells - 1) / std::max<vtkIdType>(1, this->MaximumNumberOfCells);
  std::vector<Sample> samples;
  for (const mote::DataSetPart& part : parts)
  {
    vtkDataSetAttributes* attributes =
      this->OfCells ? static_cast<vtkDataSetAttributes*>(part.data->GetCellData())
                    : static_cast<vtkDataSetAttributes*>(part.data->GetPointData());
    vtkDataArray* array = attributes->GetArray(this->ArrayName.c_str());
    if (!array || part.data->GetNumberOfCells() == 0)
      continue;
    const auto own = samplesOf(
      part.data, array, this->OfCells != 0, this->Component, std::max<vtkIdType>(1, step));
    samples.insert(samples.end(), own.begin(), own.end());
  }
  std::erase_if(samples, [](const Sample& sample) { return !(sample.volume > 0.0); });
  tbb::parallel_sort(samples.begin(), samples.end(),
    [](const Sample& a, const Sample& b)
    { return a.value < b.value || (a.value == b.value && a.volume < b.volume); });
  double sum = 0.0;
  for (const Sample& sample : samples)
  {
    sum += sample.volume;
    this->Values.push_back(sample.value);
    this->Shares.push_back(sum);
  }
  for (double& share : this->Shares)
    share /= sum;
  vtkNew<vtkDoubleArray> shares, values;
  shares->SetName("share");
  values->SetName("value");
  for (int i = 0; i <= 100 && !samples.empty(); ++i)
  {
    shares->InsertNextValue(0.01 * i);
    values->InsertNextValue(this->GetQuantile(0.01 * i));
  }
  vtkTable* table = vtkTable::GetData(outputVector);
  table->Initialize();
  table->AddColumn(shares);
  table->AddColumn(values);
  return 1;
}

double vtkMoteVolumeQuantiles::GetQuantile(double share) const
{
  if (this->Values.empty() || std::isnan(share))
    return std::numeric_limits<double>::quiet_NaN();
  const auto found = std::lower_bound(this->Shares.begin(), this->Shares.end(), share);
  return found == this->Shares.end()
           ? this->Values.back()
           : this->Values[static_cast<std::size_t>(found - this->Shares.begin())];
}

void vtkMoteVolumeQuantiles::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ArrayName: " << this->ArrayName << "\n";
  os << indent << "OfCells: " << (this->OfCells ? "On" : "Off") << "\n";
  os << indent << "Component: " << this->Component << "\n";
  os << indent << "MaximumNumberOfCells: " << this->MaximumNumberOfCells << "\n";
}
