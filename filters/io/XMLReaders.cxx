#include "XMLReaders.h"

#include "MessageCatcher.h"

#include "vtkIdTypeArray.h"
#include "vtkXMLUtilities.h"

#include <algorithm>
#include <filesystem>

namespace mote
{

namespace
{

namespace fs = std::filesystem;

/// The first file that an element, or one below it, names.
std::string firstFileIn(vtkXMLDataElement* element)
{
  for (const char* attribute : {"file", "Source"})
    if (const char* name = element->GetAttribute(attribute))
      return name;
  for (int i = 0; i < element->GetNumberOfNestedElements(); ++i)
    if (std::string name = firstFileIn(element->GetNestedElement(i)); !name.empty())
      return name;
  return {};
}

template <class Reader>
std::optional<double> timeBy(const std::string& file)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkNew<Reader> reader;
  const MessageCatcher messages(reader); // who reads the whole tells them
  reader->SetFileName(file.c_str());
  reader->UpdateInformation();
  vtkInformation* information = reader->GetOutputInformation(0);
  if (!information->Has(Pipeline::TIME_STEPS()) || information->Length(Pipeline::TIME_STEPS()) != 1)
    return {};
  return information->Get(Pipeline::TIME_STEPS(), 0);
}

/// Of an index, or of one of the files that such name; `depth` of them may name one another.
std::optional<double> timeOf(const fs::path& file, int depth)
{
  const std::string ending = file.extension().string(), name = file.string();
  if (ending == ".vtp")
    return timeBy<vtkXMLPolyDataReader>(name);
  if (ending == ".vtu")
    return timeBy<vtkXMLUnstructuredGridReader>(name);
  if (ending == ".vti")
    return timeBy<vtkXMLImageDataReader>(name);
  if (ending == ".vts")
    return timeBy<vtkXMLStructuredGridReader>(name);
  if (ending == ".vtr")
    return timeBy<vtkXMLRectilinearGridReader>(name);
  if (depth == 0)
    return {};
  vtkSmartPointer<vtkXMLDataElement> index;
  index.TakeReference(vtkXMLUtilities::ReadElementFromFile(name.c_str()));
  const std::string first = index ? firstFileIn(index) : std::string();
  return first.empty() ? std::nullopt : timeOf(file.parent_path() / first, depth - 1);
}

/// Whether a file may have so many values, however it is packed.
bool mayHold(const char* file, vtkIdType values)
{
  constexpr vtkIdType perByte = 4096; // which no packer surpasses
  std::error_code error;
  const auto bytes = fs::file_size(file ? file : "", error);
  return error || values / perByte <= static_cast<vtkIdType>(bytes);
}

/// Whether faces are, cell after cell, as many as their first number says, each with as many points
/// as its first says, and end where the cell's offset is; cells of other kinds have -1 there.
bool fillTheirCells(vtkIdTypeArray* faces, vtkIdTypeArray* ends)
{
  const vtkIdType size = faces->GetNumberOfValues();
  const auto next = [&](vtkIdType& at) { return at < size ? faces->GetValue(at++) : -1; };
  vtkIdType at = 0;
  for (vtkIdType cell = 0; cell < ends->GetNumberOfValues(); ++cell)
  {
    const vtkIdType end = ends->GetValue(cell);
    if (end < 0)
      continue;
    for (vtkIdType left = next(at); left > 0; --left)
    {
      const vtkIdType points = next(at);
      if (points < 0 || points > size - at)
        return false;
      at += points;
    }
    if (at != end)
      return false;
  }
  return true;
}

} // namespace

template <class Reader>
bool WithCells<Reader>::areCellsWhole(vtkXMLDataElement* cells, vtkIdType count)
{
  vtkXMLDataElement* const ofOffsets =
    cells ? this->FindDataArrayWithName(cells, "offsets") : nullptr;
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(count);
  if (count == 0 || !ofOffsets || !this->ReadArrayValues(ofOffsets, 0, offsets, 0, count))
    return true; // or the reader misses them
  const vtkIdType* const values = offsets->GetPointer(0);
  return values[0] >= 0 && std::is_sorted(values, values + count) &&
         mayHold(this->GetFileName(), values[count - 1]);
}

template <class Reader>
int WithCells<Reader>::refuse(const char* what)
{
  vtkErrorMacro(<< what);
  this->DataError = 1;
  return 0;
}

bool GridReader::areFacesWhole()
{
  vtkXMLDataElement* const cells = this->CellElements[this->Piece];
  vtkXMLDataElement* const ofFaces = cells ? this->FindDataArrayWithName(cells, "faces") : nullptr;
  vtkXMLDataElement* const ofEnds =
    cells ? this->FindDataArrayWithName(cells, "faceoffsets") : nullptr;
  const vtkIdType count = this->NumberOfCells[this->Piece];
  vtkNew<vtkIdTypeArray> faces, ends;
  ends->SetNumberOfValues(count);
  if (!ofFaces || !ofEnds || !this->ReadArrayValues(ofEnds, 0, ends, 0, count))
    return true; // there are no polyhedra, or the reader misses what they are of
  vtkIdType length = 0;
  for (vtkIdType cell = 0; cell < count; ++cell)
    length = std::max(length, ends->GetValue(cell));
  if (!mayHold(this->GetFileName(), length))
    return false;
  faces->SetNumberOfValues(length);
  return (length == 0 || this->ReadArrayValues(ofFaces, 0, faces, 0, length)) &&
         fillTheirCells(faces, ends);
}

namespace
{

constexpr const char* noCells = "the offsets of cells do not ascend, or lead behind the file's end";

} // namespace

int GridReader::ReadPieceData()
{
  if (!this->areCellsWhole(this->CellElements[this->Piece], this->NumberOfCells[this->Piece]))
    return this->refuse(noCells);
  return this->areFacesWhole() ? this->vtkXMLUnstructuredGridReader::ReadPieceData()
                               : this->refuse("the faces of polyhedra do not fit their cells");
}

int PolygonsReader::ReadPieceData()
{
  const int piece = this->Piece;
  return this->areCellsWhole(this->VertElements[piece], this->NumberOfVerts[piece]) &&
             this->areCellsWhole(this->LineElements[piece], this->NumberOfLines[piece]) &&
             this->areCellsWhole(this->StripElements[piece], this->NumberOfStrips[piece]) &&
             this->areCellsWhole(this->PolyElements[piece], this->NumberOfPolys[piece])
           ? this->vtkXMLPolyDataReader::ReadPieceData()
           : this->refuse(noCells);
}

std::optional<double> timeOfFiles(const std::string& index)
{
  return timeOf(index, 2);
}

} // namespace mote
