#include "PLYReader.h"

#include "ColorByte.h"
#include "FileError.h"
#include "FloatPlaces.h"
#include "PLYFile.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <cstring>
#include <initializer_list>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace mote
{

namespace
{

int typeOf(const PLYHeader::Number& number)
{
  const bool isUnsigned = number.type == PLYHeader::Type::Unsigned;
  if (number.type == PLYHeader::Type::Float)
    return number.bytes == sizeof(double) ? VTK_DOUBLE : VTK_FLOAT;
  switch (number.bytes)
  {
  case 1:
    return isUnsigned ? VTK_UNSIGNED_CHAR : VTK_SIGNED_CHAR;
  case 2:
    return isUnsigned ? VTK_UNSIGNED_SHORT : VTK_SHORT;
  default:
    return isUnsigned ? VTK_UNSIGNED_INT : VTK_INT;
  }
}

/// Puts the values of an element's properties into a data set, each of them once.
class Output
{
public:
  Output(
    const PLYFile& file, const std::string& element, vtkIdType count, vtkDataSetAttributes* arrays)
    : file_(file)
    , element_(element)
    , count_(count)
    , arrays_(arrays)
  {
  }

  using Names = std::initializer_list<const char*>;

  /// The columns of these names; none where one is missing. They are no arrays of their own then.
  std::vector<const PLYColumn*> take(Names names)
  {
    std::vector<const PLYColumn*> columns;
    for (const char* name : names)
      if (const PLYColumn* column = file_.find(element_, name);
          column && static_cast<vtkIdType>(column->count()) == count_)
        columns.push_back(column);
    if (columns.size() < names.size())
      return {};
    for (const char* name : names)
      taken_.insert(name);
    return columns;
  }

  /// Floats of these names, the first set of them that is there; null for none.
  vtkSmartPointer<vtkFloatArray> floats(const char* name, std::initializer_list<Names> sets)
  {
    for (const Names& set : sets)
      if (const auto columns = this->take(set); !columns.empty())
      {
        auto array = vtkSmartPointer<vtkFloatArray>::New();
        array->SetName(name);
        array->SetNumberOfComponents(static_cast<int>(columns.size()));
        array->SetNumberOfTuples(count_);
        for (vtkIdType i = 0; i < count_; ++i)
          for (std::size_t c = 0; c < columns.size(); ++c)
            array->SetTypedComponent(i, static_cast<int>(c),
              static_cast<float>(columns[c]->value(static_cast<std::size_t>(i))));
        return array;
      }
    return nullptr;
  }

  void addColors()
  {
    std::vector<const PLYColumn*> columns = this->take({"red", "green", "blue"});
    if (columns.empty())
      columns = this->take({"diffuse_red", "diffuse_green", "diffuse_blue"});
    if (columns.empty())
      return;
    for (const PLYColumn* alpha : this->take({"alpha"}))
      columns.push_back(alpha);
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetName(columns.size() == 4 ? "RGBA" : "RGB");
    colors->SetNumberOfComponents(static_cast<int>(columns.size()));
    colors->SetNumberOfTuples(count_);
    for (std::size_t c = 0; c < columns.size(); ++c)
    {
      const PLYHeader::Number& number = columns[c]->number;
      const double unit = number.type == PLYHeader::Type::Float ? 255.0
                          : number.bytes == 2                   ? 255.0 / 65535.0
                                                                : 1.0;
      for (vtkIdType i = 0; i < count_; ++i)
        colors->SetTypedComponent(
          i, static_cast<int>(c), colorByte(unit * columns[c]->value(static_cast<std::size_t>(i))));
    }
    arrays_->SetScalars(colors);
  }

  /// All that nothing was made of.
  void addOthers()
  {
    for (const PLYColumn& column : file_.columns)
    {
      if (column.element != element_ || taken_.count(column.name) > 0 || count_ == 0 ||
          static_cast<vtkIdType>(column.count()) != count_)
        continue;
      const auto array =
        vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(typeOf(column.number)));
      array->SetName(column.name.c_str());
      array->SetNumberOfTuples(count_);
      std::memcpy(array->GetVoidPointer(0), column.bytes.data(), column.bytes.size());
      arrays_->AddArray(array);
    }
  }

private:
  const PLYFile& file_;
  std::string element_;
  vtkIdType count_;
  vtkDataSetAttributes* arrays_;
  std::set<std::string> taken_;
};

vtkSmartPointer<vtkPoints> pointsOf(const std::vector<const PLYColumn*>& columns, vtkIdType count)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToFloat();
  if (columns.empty()) // there are no vertices
    return points;
  std::vector<double> places;
  places.reserve(3 * static_cast<std::size_t>(count));
  bool areDouble = false;
  for (const PLYColumn* column : columns)
    areDouble = areDouble || column->number.bytes == sizeof(double);
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    for (const PLYColumn* column : columns)
      places.push_back(column->value(i));
  if (areDouble && needDouble(places))
    points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  for (vtkIdType i = 0; i < count; ++i)
    points->SetPoint(i, &places[static_cast<std::size_t>(3 * i)]);
  return points;
}

void fill(const PLYFile& file, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(file.vertices);
  Output ofPoints(file, "vertex", count, output->GetPointData());
  output->SetPoints(pointsOf(ofPoints.take({"x", "y", "z"}), count));
  vtkNew<vtkIdTypeArray> offsets, corners;
  offsets->InsertNextValue(0);
  for (const std::int64_t end : file.ends)
    offsets->InsertNextValue(static_cast<vtkIdType>(end));
  for (const std::int64_t corner : file.corners)
    corners->InsertNextValue(static_cast<vtkIdType>(corner));
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(offsets, corners);
  output->SetPolys(polygons);
  if (const auto normals = ofPoints.floats("Normals", {{"nx", "ny", "nz"}}))
    output->GetPointData()->SetNormals(normals);
  if (const auto places =
        ofPoints.floats("TCoords", {{"texture_u", "texture_v"}, {"u", "v"}, {"s", "t"}}))
    output->GetPointData()->SetTCoords(places);
  ofPoints.addColors();
  ofPoints.addOthers();
  Output ofCells(file, "face", static_cast<vtkIdType>(file.ends.size()), output->GetCellData());
  ofCells.addColors();
  ofCells.addOthers();
}

} // namespace

vtkStandardNewMacro(PLYReader);

int PLYReader::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  try
  {
    fill(readPLY(this->FileName ? this->FileName : ""), output);
  }
  catch (const FileError& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
  }
  return 1; // a failed request would leave old data downstream
}

} // namespace mote
