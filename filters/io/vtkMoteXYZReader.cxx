#include "vtkMoteXYZReader.h"

#include "FileError.h"
#include "PointRows.h"
#include "PolyDataParts.h"
#include "TimeSteps.h"
#include "XYZFile.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace
{

/// Adds "type" for an array of words, `all` of them where these are given; see mote::typesOf().
void addTypes(vtkPolyData* data, const std::string& species, std::set<std::string> all)
{
  auto* names =
    vtkStringArray::SafeDownCast(data->GetPointData()->GetAbstractArray(species.c_str()));
  if (!names || data->GetPointData()->HasArray("type"))
    return;
  // Words are looked up once: first by their order, of which types are made then.
  std::unordered_map<std::string, int> numbers;
  vtkNew<vtkIntArray> types;
  types->SetName("type");
  types->SetNumberOfTuples(names->GetNumberOfTuples());
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
    types->SetValue(
      i, numbers.try_emplace(names->GetValue(i), static_cast<int>(numbers.size())).first->second);
  for (const auto& [word, number] : numbers)
    all.insert(word);
  const std::map<std::string, int> typeOf = mote::typesOf(all, true);
  std::vector<int> typeOfNumber(numbers.size());
  for (const auto& [word, number] : numbers)
    typeOfNumber[static_cast<std::size_t>(number)] = typeOf.at(word);
  int* const values = types->GetPointer(0);
  for (vtkIdType i = 0; i < types->GetNumberOfValues(); ++i)
    values[i] = typeOfNumber[static_cast<std::size_t>(values[i])];
  data->GetPointData()->AddArray(types);
}

void readFrame(const std::string& path, const mote::XYZFrame& frame, const mote::Piece& piece,
  const std::shared_ptr<mote::ScratchSpace>& space, const mote::Progress& progress,
  vtkPolyData* output)
{
  mote::TextCursor cursor(path, mote::TextCursor::OpenEnd::Accept);
  cursor.seek(frame.rows);
  const auto first = frame.atoms > 0 ? mote::peekValues(cursor) : std::vector<std::string>();
  const mote::XYZLayout layout = mote::xyzLayout(path, frame, first);
  mote::PointRows rows;
  rows.rows = frame.atoms;
  rows.piece = piece;
  rows.place = frame.rows;
  rows.columns = layout.columns;
  rows.types = layout.types;
  rows.coordinates = layout.coordinates;
  rows.arrays = layout.arrays;
  rows.space = space;
  mote::NumberedWords words;
  const auto isNamed = [](const char* name)
  { return [name](const mote::ColumnGroup& group) { return group.name == name; }; };
  const auto& arrays = layout.arrays;
  const auto species = std::find_if(arrays.begin(), arrays.end(), isNamed(layout.species.c_str()));
  const bool hasWords = !layout.species.empty() && species != arrays.end() &&
                        std::none_of(arrays.begin(), arrays.end(), isNamed("type"));
  std::set<std::string> all;
  if (hasWords && !piece.isAll())
    all = mote::wordsOf(cursor, rows, species->columns[0], progress);
  if (hasWords && space)
  {
    words.column = species->columns[0];
    rows.words = &words;
    for (const std::string& word : all)
      words.table.numberOf(word);
  }
  mote::readPointRows(cursor, std::move(rows), progress, output);
  if (words.numbers)
    mote::addTypes(words, mote::typesOf(words.table.words(), true), output);
  else if (!space)
    addTypes(output, layout.species, std::move(all));
  if (const auto box = mote::xyzBox(frame.comment))
  {
    vtkFieldData* fields = output->GetFieldData();
    mote::addNumbers(fields, "box", box->vectors.data(), 9);
    mote::addNumbers(fields, "box_origin", box->origin.data(), 3);
    mote::addText(fields, "boundary", box->boundary);
  }
}

} // namespace

class vtkMoteXYZReader::Internals
{
public:
  std::string Name;
  mote::FileStamp Stamp;
  std::vector<mote::XYZFrame> Frames; ///< empty: not read, or not readable

  void Update(const std::string& name, const mote::Progress& progress)
  {
    const mote::FileStamp stamp = mote::stampOf(name);
    if (this->Frames.empty() || name != this->Name || !(stamp == this->Stamp))
    {
      this->Frames.clear();
      this->Frames = mote::indexXYZ(name, progress);
      this->Name = name;
      this->Stamp = stamp;
    }
  }
};

vtkStandardNewMacro(vtkMoteXYZReader);

vtkMoteXYZReader::vtkMoteXYZReader()
  : Internal(std::make_unique<Internals>())
{
}

vtkMoteXYZReader::~vtkMoteXYZReader() = default;

int vtkMoteXYZReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* information = outputVector->GetInformationObject(0);
  mote::offerTimeSteps(information, {});
  mote::offerPieces(information);
  this->AbortExecute = 0; // of an earlier run: only REQUEST_DATA resets it
  const bool good = this->Attempt(
    [this](const ProgressFunction& progress)
    {
      this->RequireFileName();
      this->Internal->Update(this->GetFileName(), progress);
    });
  if (!good)
  {
    this->Internal->Frames.clear();
    return 1;
  }
  std::vector<double> times;
  for (const mote::XYZFrame& frame : this->Internal->Frames)
    times.push_back(frame.time);
  mote::offerTimeSteps(information, times);
  return 1;
}

int vtkMoteXYZReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* information = outputVector->GetInformationObject(0);
  vtkPolyData* output = vtkPolyData::GetData(information);
  output->Initialize();
  if (this->Internal->Frames.empty())
    return 1; // the error has been reported
  vtkNew<vtkPolyData> result;
  double time = 0;
  const bool good = this->Attempt(
    [&](const ProgressFunction& progress)
    {
      this->Internal->Update(this->GetFileName(), progress);
      const mote::XYZFrame& frame =
        mote::requestedStep(information, this->Internal->Frames, &mote::XYZFrame::time);
      time = frame.time;
      readFrame(this->GetFileName(), frame, mote::requestedPiece(information),
        this->GetScratchSpace(), progress, result);
    });
  if (good)
    DeliverStep(result, time, output);
  return 1;
}

void vtkMoteXYZReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Frames: " << this->Internal->Frames.size() << "\n";
}
