#include "vtkMoteDelimitedPointsReader.h"

#include "FileError.h"
#include "PolyDataParts.h"
#include "TextFile.h"
#include "TextRows.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkDelimitedTextReader.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <vtksys/SystemTools.hxx>

namespace
{

using mote::FileError;

void keepMessage(vtkObject*, unsigned long, void* message, void* text)
{
  *static_cast<std::string*>(message) = static_cast<const char*>(text);
}

/// What separates the names in the first line: the most frequent of comma, semicolon and tab.
char delimiterOf(std::string_view text)
{
  const std::string_view names = text.substr(0, text.find_first_of("\r\n"));
  char best = ',';
  for (const char candidate : {';', '\t'})
    if (std::count(names.begin(), names.end(), candidate) >
        std::count(names.begin(), names.end(), best))
      best = candidate;
  return best;
}

/// Takes blanks, and the byte order mark that some programs begin a file with, off the names, and
/// names columns that have none.
void mendNames(vtkTable* table)
{
  std::vector<std::string> names;
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    const char* given = table->GetColumnName(i);
    std::string name = given ? given : "";
    name.erase(0, name.starts_with("\xEF\xBB\xBF") ? 3 : 0);
    name.erase(0, std::min(name.find_first_not_of(" \t"), name.size()));
    name.erase(name.find_last_not_of(" \t") + 1);
    names.push_back(name);
  }
  for (std::size_t i = 0; i < names.size(); ++i)
    table->GetColumn(static_cast<vtkIdType>(i))
      ->SetName((names[i].empty() ? mote::unnamedColumn(i + 1, names) : names[i]).c_str());
}

/// Throws FileError for what is no plain text.
void requireText(const mote::TextFile& file)
{
  if (file.isGzip())
  {
    throw FileError(FileError::Kind::OtherFormat, file.path(),
      "tables are not read from gzip files; unpack it first (gunzip)");
  }
  if (file.text().substr(0, 4096).find('\0') != std::string_view::npos)
  {
    throw FileError(
      FileError::Kind::OtherFormat, file.path(), "this is a binary file, not a table of text");
  }
}

std::string namesOf(vtkTable* table)
{
  std::string names;
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
    names.append(i > 0 ? ", '" : "'").append(table->GetColumnName(i)).append("'");
  return names;
}

/// The column of an axis, as numbers; null if there is none for z.
vtkDataArray* coordinate(vtkTable* table, const std::string& axis, const std::string& path)
{
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    if (vtksys::SystemTools::LowerCase(table->GetColumnName(i)) != axis)
      continue;
    if (auto* numbers = vtkDataArray::SafeDownCast(table->GetColumn(i)))
      return numbers;
    auto* words = vtkStringArray::SafeDownCast(table->GetColumn(i));
    for (vtkIdType row = 0; words && row < words->GetNumberOfValues(); ++row)
    {
      bool isNumber = false;
      words->GetVariantValue(row).ToDouble(&isNumber);
      if (!isNumber)
      {
        throw FileError(FileError::Kind::Malformed, path,
          "expected a number for '" + axis + "', found '" + words->GetValue(row) + "'",
          static_cast<std::uint64_t>(row) + 2);
      }
    }
  }
  if (axis == "z")
    return nullptr;
  throw FileError(FileError::Kind::Malformed, path,
    "no column is named '" + axis + "'; points need columns x, y and mostly z, and here are " +
      namesOf(table),
    1);
}

void convert(vtkTable* table, const std::string& path, vtkPolyData* output)
{
  const vtkIdType count = table->GetNumberOfRows();
  vtkNew<vtkPoints> points;
  double* const positions = mote::makePositions(points, count);
  vtkDataArray* axes[3] = {};
  for (int axis = 0; axis < 3; ++axis)
  {
    axes[axis] = coordinate(table, std::string(1, static_cast<char>('x' + axis)), path);
    for (vtkIdType row = 0; row < count; ++row)
      positions[3 * row + axis] = axes[axis] ? axes[axis]->GetComponent(row, 0) : 0.0;
  }
  output->SetPoints(points);
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    vtkAbstractArray* column = table->GetColumn(i);
    if (column != axes[0] && column != axes[1] && column != axes[2])
      output->GetPointData()->AddArray(column);
  }
  mote::setVertices(output, count);
}

} // namespace

vtkStandardNewMacro(vtkMoteDelimitedPointsReader);

vtkMoteDelimitedPointsReader::vtkMoteDelimitedPointsReader() = default;
vtkMoteDelimitedPointsReader::~vtkMoteDelimitedPointsReader() = default;

int vtkMoteDelimitedPointsReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->Initialize();
  vtkNew<vtkPolyData> result;
  const bool good = this->Attempt(
    [&](const ProgressFunction&)
    {
      this->RequireFileName();
      const std::string path = this->GetFileName();
      const mote::TextFile file(path); // says clearly why a file cannot be opened
      requireText(file);
      std::string message;
      vtkNew<vtkCallbackCommand> keep;
      keep->SetCallback(keepMessage);
      keep->SetClientData(&message);
      vtkNew<vtkDelimitedTextReader> reader;
      reader->AddObserver(vtkCommand::ErrorEvent, keep);
      reader->SetFileName(path.c_str());
      reader->SetHaveHeaders(true);
      reader->DetectNumericColumnsOn();
      reader->TrimWhitespacePriorToNumericConversionOn();
      const char delimiter[] = {delimiterOf(file.text()), '\0'};
      reader->SetFieldDelimiterCharacters(delimiter);
      reader->Update();
      if (!message.empty() || reader->GetOutput()->GetNumberOfRows() == 0)
        throw FileError(FileError::Kind::Truncated, path,
          file.bytes() == 0 ? "the file is empty"
                            : "the table has no row below the names of its columns");
      mendNames(reader->GetOutput());
      convert(reader->GetOutput(), path, result);
    });
  if (good)
    output->ShallowCopy(result);
  return 1;
}

void vtkMoteDelimitedPointsReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
