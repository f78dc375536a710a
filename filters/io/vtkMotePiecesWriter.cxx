#include "vtkMotePiecesWriter.h"

#include "BoxCuts.h"
#include "DataParts.h"
#include "FileEnding.h"
#include "PieceFiles.h"
#include "XMLNames.h"

#include "kernels/core/AtomicFile.h"
#include "kernels/core/Error.h"

#include "vtkAbstractArray.h"
#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <vector>

namespace
{

/// Places that tell where to cut; more cut no better.
constexpr vtkIdType mostPlaces = 1 << 18;

using Place = mote::BoxCuts::Place;
using Ids = std::vector<vtkSmartPointer<vtkIdList>>;

bool hasCells(vtkDataSet* data)
{
  return data->GetNumberOfCells() > 0;
}

/// The mean of a cell's points, or a point of data without cells.
Place placeOf(vtkDataSet* data, vtkIdType item, vtkIdList* points)
{
  Place mean{0.0, 0.0, 0.0};
  if (!hasCells(data))
  {
    data->GetPoint(item, mean.data());
    return mean;
  }
  data->GetCellPoints(item, points);
  const vtkIdType count = points->GetNumberOfIds();
  for (vtkIdType i = 0; i < count; ++i)
  {
    double point[3];
    data->GetPoint(points->GetId(i), point);
    for (int c = 0; c < 3; ++c)
      mean[c] += point[c] / static_cast<double>(count);
  }
  return mean;
}

/// The cells of each piece, or the points of data without cells; those that have some.
Ids cut(vtkDataSet* data, int pieces)
{
  const vtkIdType count = hasCells(data) ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  const vtkIdType step = count / mostPlaces + 1;
  vtkNew<vtkIdList> points;
  std::vector<Place> places;
  for (vtkIdType i = 0; i < count; i += step)
    places.push_back(placeOf(data, i, points));
  const mote::BoxCuts boxes(std::move(places), vtkBoundingBox(data->GetBounds()), pieces);
  Ids ids(pieces);
  for (vtkSmartPointer<vtkIdList>& list : ids)
    list = vtkSmartPointer<vtkIdList>::New();
  for (vtkIdType i = 0; i < count; ++i)
    ids[boxes.boxOf(placeOf(data, i, points).data())]->InsertNextId(i);
  std::erase_if(ids, [](const auto& list) { return list->GetNumberOfIds() == 0; });
  return ids;
}

/// Some cells, or some points of data without cells.
vtkSmartPointer<vtkDataSet> pieceOf(vtkDataSet* data, vtkIdList* ids)
{
  vtkSmartPointer<vtkDataSet> piece;
  if (hasCells(data))
    piece = mote::cellsOf(data, ids);
  else
    piece = mote::pointsOf(data, ids);
  piece->GetFieldData()->ShallowCopy(data->GetFieldData());
  if (data->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()))
    piece->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(),
      data->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()));
  return piece;
}

/// What VTK's XML files call the numbers of an array.
std::string typeOf(vtkAbstractArray* array)
{
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if (!numbers)
    return "String";
  const int type = numbers->GetDataType(), bits = 8 * numbers->GetDataTypeSize();
  const bool isReal = type == VTK_FLOAT || type == VTK_DOUBLE;
  const bool isUnsigned = !isReal && numbers->GetDataTypeMin() >= 0.0;
  return (isReal ? "Float" : isUnsigned ? "UInt" : "Int") + std::to_string(bits);
}

std::string quoted(const std::string& text)
{
  return '"' + mote::xmlEncoded(text) + '"';
}

std::string elementOf(vtkAbstractArray* array)
{
  std::string element = "      <PDataArray type=" + quoted(typeOf(array));
  if (array->GetName())
    element += " Name=" + quoted(array->GetName());
  return element + " NumberOfComponents=\"" + std::to_string(array->GetNumberOfComponents()) +
         "\"/>\n";
}

std::string elementOf(const std::string& name, vtkDataSetAttributes* data)
{
  std::string element = "    <" + name + ">\n";
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    element += elementOf(data->GetAbstractArray(i));
  return element + "    </" + name + ">\n";
}

/// The index of pieces that all have the arrays of this one.
std::string indexOf(
  vtkPointSet* piece, const std::string& ending, const std::vector<std::string>& names)
{
  const std::string type = ending == ".pvtp" ? "PPolyData" : "PUnstructuredGrid";
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=" + quoted(type) +
                     " version=\"1.0\" header_type=\"UInt64\">\n  <" + type +
                     " GhostLevel=\"0\">\n";
  text += elementOf("PPointData", piece->GetPointData());
  text += elementOf("PCellData", piece->GetCellData());
  text += "    <PPoints>\n" + elementOf(piece->GetPoints()->GetData()) + "    </PPoints>\n";
  for (const std::string& name : names)
    text += "    <Piece Source=" + quoted(name) + "/>\n";
  return text + "  </" + type + ">\n</VTKFile>\n";
}

} // namespace

vtkStandardNewMacro(vtkMotePiecesWriter);

vtkMotePiecesWriter::vtkMotePiecesWriter() = default;

vtkMotePiecesWriter::~vtkMotePiecesWriter() = default;

std::string vtkMotePiecesWriter::EndingOf(const std::string& fileName)
{
  return mote::endingAmong(fileName, {".pvtp", ".pvtu"});
}

int vtkMotePiecesWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

bool vtkMotePiecesWriter::WriteFile()
{
  namespace fs = std::filesystem;
  const fs::path index = this->FileName;
  const std::string ending = vtkMotePiecesWriter::EndingOf(index.string());
  if (ending.empty())
    throw mote::Error("the name must end in .pvtp or .pvtu.");
  if (this->GetNumberOfInputConnections(0) == 0)
    throw mote::Error("there are no data to write.");
  this->GetInputAlgorithm()->Update();
  auto* data = vtkDataSet::SafeDownCast(this->GetInput());
  if (!data || data->GetNumberOfPoints() == 0)
    throw mote::Error("there are no data to write.");
  if (ending == ".pvtp" && !vtkPolyData::SafeDownCast(data))
    throw mote::Error(
      "a .pvtp file holds points, lines and polygons; other cells go into a .pvtu file.");
  mote::PieceFiles files(index.string());
  mote::AtomicFile file(index.string());
  const Ids ids = cut(data, this->NumberOfPieces);
  const double share = 1.0 / static_cast<double>(ids.size());
  vtkSmartPointer<vtkDataSet> piece;
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    piece = pieceOf(data, ids[i]);
    if (!files.write(this, piece, '.' + ending.substr(2), static_cast<double>(i) * share, share))
      return false;
  }
  const std::string text = indexOf(vtkPointSet::SafeDownCast(piece), ending, files.names());
  files.commit();
  file.write(text.data(), text.size());
  file.commit();
  this->NumberOfWrittenPieces = static_cast<int>(ids.size());
  return true;
}

void vtkMotePiecesWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfPieces: " << this->NumberOfPieces << "\n";
  os << indent << "NumberOfWrittenPieces: " << this->NumberOfWrittenPieces << "\n";
}
