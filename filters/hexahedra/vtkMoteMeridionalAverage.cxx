#include "vtkMoteMeridionalAverage.h"

#include "DataSetMismatch.h"
#include "DataSetParts.h"
#include "FieldVector.h"
#include "MeridionalBins.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

vtkStandardNewMacro(vtkMoteMeridionalAverage);

namespace
{

/// The array of one data set.
struct Chosen
{
  vtkDataSet* data;
  vtkSmartPointer<vtkDataArray> array;
  bool ofCells;
};

Chosen choose(vtkDataSet* data, const std::string& name, int association)
{
  vtkDataArray* ofPoints = association == vtkDataObject::FIELD_ASSOCIATION_CELLS
                             ? nullptr
                             : data->GetPointData()->GetArray(name.c_str());
  if (ofPoints || association == vtkDataObject::FIELD_ASSOCIATION_POINTS)
    return {data, ofPoints, false};
  return {data, data->GetCellData()->GetArray(name.c_str()), true};
}

/// One component of an array, or the magnitude, with its name.
vtkSmartPointer<vtkDataArray> partOf(vtkDataArray* array, int component)
{
  const bool isMagnitude = component == vtkMoteMeridionalAverage::MAGNITUDE;
  const char* own = isMagnitude ? "magnitude" : array->GetComponentName(component);
  auto part = vtkSmartPointer<vtkDoubleArray>::New();
  part->SetName(
    (std::string(array->GetName()) + ":" + (own ? std::string(own) : std::to_string(component)))
      .c_str());
  part->SetNumberOfValues(array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    double squares = 0.0;
    for (int c = 0; isMagnitude && c < array->GetNumberOfComponents(); ++c)
      squares += std::pow(array->GetComponent(i, c), 2);
    part->SetValue(i, isMagnitude ? std::sqrt(squares) : array->GetComponent(i, component));
  }
  return part;
}

/// The arrays of all data sets that have one. Returns what is wrong with them, or nothing.
std::string choose(vtkDataObject* input, const std::string& name, int association, int component,
  std::vector<Chosen>& arrays)
{
  for (const mote::DataSetPart& part : mote::partsOf(input))
  {
    Chosen chosen = choose(part.data, name, association);
    if (!chosen.array)
      continue;
    if (component >= chosen.array->GetNumberOfComponents())
      return "the array '" + name + "' has no component " + std::to_string(component);
    if (component != vtkMoteMeridionalAverage::WHOLE)
      chosen.array = partOf(chosen.array, component);
    arrays.push_back(chosen);
  }
  if (arrays.empty())
    return "there is no array of numbers named '" + name + "'";
  const int components = arrays.front().array->GetNumberOfComponents();
  for (const Chosen& chosen : arrays)
    if (chosen.array->GetNumberOfComponents() != components || (components != 1 && components != 3))
      return "the array '" + name + "' has " + std::to_string(components) +
             " components, and one or three are averaged";
  return {};
}

/// Whether a range leaves nothing out.
bool isAll(const double range[2])
{
  return range[0] == -VTK_DOUBLE_MAX && range[1] == VTK_DOUBLE_MAX;
}

/// A column's name, and its value in a bin.
struct Column
{
  std::string name;
  std::function<double(const mote::Bin&)> value;
};

std::vector<Column> columnsFor(const std::string& name, bool isVector, double middle)
{
  using mote::Bin;
  const Column volume{"volume", [](const Bin& b) { return b.volume; }};
  if (!isVector)
    return {volume, {name, [](const Bin& b) { return b.sums[0] / b.volume; }},
      {name + "_deviation", [middle](const Bin& b)
        {
          const double off = b.sums[0] / b.volume - middle;
          return std::sqrt(std::max(0.0, b.sums[1] / b.volume - off * off));
        }}};
  return {volume, {name + "_axial", [](const Bin& b) { return b.sums[0] / b.volume; }},
    {name + "_radial", [](const Bin& b) { return b.sums[1] / b.volume; }},
    {name + "_circumferential", [](const Bin& b) { return b.sums[2] / b.volume; }},
    {name + "_magnitude", [](const Bin& b) { return b.sums[3] / b.volume; }}};
}

vtkSmartPointer<vtkDoubleArray> newArray(const std::string& name, vtkIdType count)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name.c_str());
  array->SetNumberOfValues(count);
  return array;
}

void fillTable(vtkTable* table, const std::vector<mote::Bin>& bins, const mote::BinGrid& grid,
  const std::vector<Column>& columns)
{
  std::vector<vtkIdType> filled;
  for (std::size_t i = 0; i < bins.size(); ++i)
    if (bins[i].volume > 0.0)
      filled.push_back(static_cast<vtkIdType>(i));
  const auto rows = static_cast<vtkIdType>(filled.size());
  const auto axial = newArray("axial", rows), radial = newArray("radial", rows);
  for (vtkIdType row = 0; row < rows; ++row)
  {
    axial->SetValue(row, grid.first + (filled[row] % grid.axial + 0.5) * grid.size);
    radial->SetValue(row, grid.inner + (filled[row] / grid.axial + 0.5) * grid.size);
  }
  table->AddColumn(axial);
  table->AddColumn(radial);
  for (const Column& column : columns)
  {
    const auto values = newArray(column.name, rows);
    for (vtkIdType row = 0; row < rows; ++row)
      values->SetValue(row, column.value(bins[filled[row]]));
    table->AddColumn(values);
  }
}

void fillImage(vtkImageData* image, const std::vector<mote::Bin>& bins, const mote::BinGrid& grid,
  const std::vector<Column>& columns)
{
  image->SetDimensions(grid.axial, grid.radial, 1);
  image->SetSpacing(grid.size, grid.size, grid.size);
  image->SetOrigin(grid.first + 0.5 * grid.size, grid.inner + 0.5 * grid.size, 0.0);
  for (const Column& column : columns)
  {
    const auto values = newArray(column.name, static_cast<vtkIdType>(bins.size()));
    for (std::size_t i = 0; i < bins.size(); ++i)
      values->SetValue(static_cast<vtkIdType>(i), bins[i].volume > 0.0      ? column.value(bins[i])
                                                  : column.name == "volume" ? 0.0
                                                                            : std::nan(""));
    image->GetPointData()->AddArray(values);
  }
  image->GetPointData()->SetActiveScalars(columns[1].name.c_str());
}

} // namespace

vtkMoteMeridionalAverage::vtkMoteMeridionalAverage()
{
  for (double* range : {this->AxialRange, this->RadialRange})
    range[0] = -VTK_DOUBLE_MAX, range[1] = VTK_DOUBLE_MAX;
  this->SetNumberOfOutputPorts(2);
}

vtkMoteMeridionalAverage::~vtkMoteMeridionalAverage() = default;

vtkImageData* vtkMoteMeridionalAverage::GetImage()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(1));
}

int vtkMoteMeridionalAverage::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkMoteMeridionalAverage::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkTable" : "vtkImageData");
  return 1;
}

int vtkMoteMeridionalAverage::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  // The image's size follows from the data: whoever reads it takes what there is.
  outputVector->GetInformationObject(1)->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 0);
  return 1;
}

std::string vtkMoteMeridionalAverage::Average(
  vtkDataObject* input, vtkTable* table, vtkImageData* image)
{
  if (const std::string mismatch = mote::mismatchOf(input); !mismatch.empty())
    return mismatch;
  std::vector<Chosen> arrays;
  if (const std::string problem =
        choose(input, this->ArrayName, this->Association, this->Component, arrays);
      !problem.empty())
    return problem;
  std::vector<vtkDataSet*> data;
  for (const Chosen& chosen : arrays)
    data.push_back(chosen.data);
  const std::string name = arrays.front().array->GetName();
  const bool isVector = arrays.front().array->GetNumberOfComponents() == 3;

  mote::Axis axis{{this->Origin[0], this->Origin[1], this->Origin[2]},
    {this->Axis[0], this->Axis[1], this->Axis[2]}};
  if (mote::Axis own; this->AxisFromInput &&
                      mote::readVector(data.front(), "AxisOrigin", own.origin) &&
                      mote::readVector(data.front(), "AxisDirection", own.direction))
    axis = own;
  const double length = glm::length(axis.direction);
  if (!(length > 0.0) || !std::isfinite(length) || !std::isfinite(glm::length(axis.origin)))
    return "the axis needs a finite origin and a direction of finite length above 0";
  axis.direction /= length;

  const mote::Limits limits = {
    {this->AxialRange[0], this->AxialRange[1]}, {this->RadialRange[0], this->RadialRange[1]}};
  const mote::BinGrid grid = mote::binsFor(data, axis, limits, this->Resolution);
  std::vector<mote::Bin> bins(grid.count());
  // Squares are taken of differences from here: those of large values cancel badly.
  double range[2];
  arrays.front().array->GetFiniteRange(range, 0);
  const double middle = range[0] <= range[1] ? 0.5 * range[0] + 0.5 * range[1] : 0.0;
  for (const Chosen& chosen : arrays)
    if (!bins.empty()) // there are none over a single place
      mote::addToBins(bins, grid, axis, chosen.data, chosen.array, chosen.ofCells, middle);
  if (std::none_of(bins.begin(), bins.end(),
        [](const mote::Bin& b) { return b.volume > 0.0 || std::isnan(b.volume); }))
    return std::string("there is no cell with volume and a finite value to average") +
           (isAll(this->AxialRange) && isAll(this->RadialRange) ? ""
                                                                : " within the ranges of place");
  const std::vector<Column> columns = columnsFor(name, isVector, middle);
  const auto overflows = [&columns](const mote::Bin& bin)
  {
    const auto isFinite = [](double x) { return std::isfinite(x); };
    if (std::isnan(bin.volume)) // from differences of infinite ones
      return true;
    return bin.volume > 0.0 && !(std::all_of(std::begin(bin.sums), std::end(bin.sums), isFinite) &&
                                 std::all_of(columns.begin(), columns.end(),
                                   [&](const Column& c) { return isFinite(c.value(bin)); }));
  };
  if (std::any_of(bins.begin(), bins.end(), overflows))
    return "the cells or the values of '" + this->ArrayName +
           "' are so large that numbers cannot hold sums over them";
  fillTable(table, bins, grid, columns);
  fillImage(image, bins, grid, columns);
  return {};
}

int vtkMoteMeridionalAverage::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkTable* table = vtkTable::GetData(outputVector, 0);
  vtkImageData* image = vtkImageData::GetData(outputVector, 1);
  table->Initialize();
  image->Initialize();
  this->ErrorMessage = this->Average(vtkDataObject::GetData(inputVector[0]), table, image);
  if (!this->ErrorMessage.empty())
    vtkErrorMacro(<< this->ErrorMessage << ".");
  return this->ErrorMessage.empty() ? 1 : 0;
}

void vtkMoteMeridionalAverage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ArrayName: " << this->ArrayName << "\n";
  os << indent << "Association: " << this->Association << "\n";
  os << indent << "Component: " << this->Component << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "AxisFromInput: " << this->AxisFromInput << "\n";
  os << indent << "Origin: " << this->Origin[0] << " " << this->Origin[1] << " " << this->Origin[2]
     << "\n";
  os << indent << "Axis: " << this->Axis[0] << " " << this->Axis[1] << " " << this->Axis[2] << "\n";
  os << indent << "AxialRange: " << this->AxialRange[0] << " " << this->AxialRange[1] << "\n";
  os << indent << "RadialRange: " << this->RadialRange[0] << " " << this->RadialRange[1] << "\n";
}
