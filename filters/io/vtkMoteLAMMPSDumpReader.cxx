#include "vtkMoteLAMMPSDumpReader.h"

#include "LAMMPSColumns.h"
#include "LAMMPSDump.h"
#include "LAMMPSPolyData.h"
#include "LAMMPSVelocities.h"
#include "Piece.h"
#include "TimeSteps.h"

#include "vtkDataArraySelection.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace
{

/// A file's index, and the state of the file that it belongs to.
struct IndexedFile
{
  mote::FileStamp Stamp;
  mote::LAMMPSIndex Index;
};

/// Where a time step is.
struct Step
{
  double Time = 0;
  const std::string* File = nullptr;
  const mote::LAMMPSFrame* Frame = nullptr;
};

} // namespace

class vtkMoteLAMMPSDumpReader::Internals
{
public:
  void Update(const mote::Progress& progress, bool leaveOut);
  void MakeSteps(bool leaveOut);
  bool FilesHaveChanged() const;

  std::vector<std::string> Names;
  std::map<std::string, IndexedFile> Files; ///< by name; only those of Names
  std::vector<Step> Steps;                  ///< ascending times; points into Files
  std::set<std::string> Offered;            ///< the arrays that this reader put into the selection
  vtkNew<vtkDataArraySelection> Selection;
};

/// Indexes the files that are new or have changed.
void vtkMoteLAMMPSDumpReader::Internals::Update(const mote::Progress& progress, bool leaveOut)
{
  this->Steps.clear();
  std::map<std::string, IndexedFile> files;
  std::size_t done = 0;
  for (const std::string& name : this->Names)
  {
    const mote::FileStamp stamp = mote::stampOf(name);
    auto known = this->Files.find(name);
    if (known != this->Files.end() && known->second.Stamp == stamp)
    {
      files.insert(this->Files.extract(known));
    }
    else if (files.find(name) == files.end())
    {
      const mote::Progress part = [&](double fraction)
      { return progress((static_cast<double>(done) + fraction) / this->Names.size()); };
      const bool grew = known != this->Files.end() && known->second.Stamp.bytes < stamp.bytes;
      files[name] = {
        stamp, mote::indexLAMMPSDump(name, part, grew ? &known->second.Index : nullptr)};
    }
    ++done;
  }
  this->Files = std::move(files);
  this->MakeSteps(leaveOut);
}

void vtkMoteLAMMPSDumpReader::Internals::MakeSteps(bool leaveOut)
{
  bool haveTimes = true;
  for (const auto& [name, file] : this->Files)
  {
    haveTimes =
      haveTimes && std::all_of(file.Index.frames.begin(), file.Index.frames.end(),
                     [](const mote::LAMMPSFrame& frame) { return frame.time.has_value(); });
  }
  std::map<double, Step> steps;
  for (const std::string& name : this->Names)
  {
    const auto& [key, file] = *this->Files.find(name);
    for (const mote::LAMMPSFrame& frame : file.Index.frames)
    {
      if (leaveOut && frame.damage && &frame == &file.Index.frames.back())
        continue;
      const double time = haveTimes ? *frame.time : static_cast<double>(frame.timestep);
      steps[time] = {time, &key, &frame};
    }
  }
  for (const auto& [time, step] : steps)
    this->Steps.push_back(step);
  if (this->Steps.empty() && !this->Names.empty())
    throw mote::FileError(mote::FileError::Kind::Truncated, this->Names.front(),
      "no time step of this file is whole yet");
}

bool vtkMoteLAMMPSDumpReader::Internals::FilesHaveChanged() const
{
  return std::any_of(this->Files.begin(), this->Files.end(),
    [](const auto& file) { return !(mote::stampOf(file.first) == file.second.Stamp); });
}

vtkStandardNewMacro(vtkMoteLAMMPSDumpReader);

vtkMoteLAMMPSDumpReader::vtkMoteLAMMPSDumpReader()
  : Internal(std::make_unique<Internals>())
{
}

vtkMoteLAMMPSDumpReader::~vtkMoteLAMMPSDumpReader() = default;

void vtkMoteLAMMPSDumpReader::SetFileName(const char* fileName)
{
  std::vector<std::string> names;
  if (fileName && *fileName)
    names.emplace_back(fileName);
  if (names != this->Internal->Names)
  {
    this->Internal->Names = std::move(names);
    this->Modified();
  }
}

const char* vtkMoteLAMMPSDumpReader::GetFileName()
{
  return this->GetFileName(0);
}

void vtkMoteLAMMPSDumpReader::AddFileName(const char* fileName)
{
  if (fileName && *fileName)
  {
    this->Internal->Names.emplace_back(fileName);
    this->Modified();
  }
}

void vtkMoteLAMMPSDumpReader::RemoveAllFileNames()
{
  if (!this->Internal->Names.empty())
  {
    this->Internal->Names.clear();
    this->Modified();
  }
}

int vtkMoteLAMMPSDumpReader::GetNumberOfFileNames()
{
  return static_cast<int>(this->Internal->Names.size());
}

const char* vtkMoteLAMMPSDumpReader::GetFileName(int index)
{
  const bool valid = index >= 0 && index < this->GetNumberOfFileNames();
  return valid ? this->Internal->Names[index].c_str() : nullptr;
}

int vtkMoteLAMMPSDumpReader::CanReadFile(const char* fileName)
{
  try
  {
    return fileName && mote::looksLikeLAMMPSDump(mote::readBeginning(fileName, 4096)) ? 1 : 0;
  }
  catch (const mote::FileError&)
  {
    return 0;
  }
}

void vtkMoteLAMMPSDumpReader::TakeIndexOf(vtkMoteLAMMPSDumpReader* other)
{
  if (!other || other == this)
    return;
  this->LeaveOutDamagedEnd = other->LeaveOutDamagedEnd;
  this->Internal->Files = other->Internal->Files; // what is shared by frames never changes
  this->Modified();
}

vtkDataArraySelection* vtkMoteLAMMPSDumpReader::GetPointDataArraySelection()
{
  return this->Internal->Selection;
}

vtkMTimeType vtkMoteLAMMPSDumpReader::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Internal->Selection->GetMTime());
}

/// Offers the arrays of all files, and forgets those of files read before.
void vtkMoteLAMMPSDumpReader::OfferArrays()
{
  std::set<std::string> offered;
  std::vector<std::string> ordered;
  const std::vector<std::string>* last = nullptr;
  const auto offer = [&](const std::string& name)
  {
    if (offered.insert(name).second)
      ordered.push_back(name);
  };
  for (const Step& step : this->Internal->Steps)
  {
    for (const std::string& name : mote::velocityArrays(*step.Frame, this->CombineVectors))
      offer(name);
    const auto* columns = step.Frame->columns.get();
    if (!columns || columns == last)
      continue; // the steps of a file share their list
    last = columns;
    for (const mote::ColumnGroup& array : mote::layoutOf(*columns, this->CombineVectors).arrays)
      offer(array.name);
  }
  vtkDataArraySelection* selection = this->Internal->Selection;
  for (const std::string& name : this->Internal->Offered)
    if (offered.find(name) == offered.end())
      selection->RemoveArrayByName(name.c_str());
  this->Internal->Offered = offered;
  std::string known;
  for (const std::string& name : ordered)
  {
    selection->AddArray(name.c_str());
    known += (known.empty() ? "'" : ", '") + name + "'";
  }
  for (int i = 0; i < selection->GetNumberOfArrays(); ++i)
  {
    const char* name = selection->GetArrayName(i);
    if (selection->GetArraySetting(i) && offered.find(name) == offered.end())
    {
      throw mote::FileError(mote::FileError::Kind::Malformed, this->Internal->Names.front(),
        "there is no array '" + std::string(name) + "' to read; there " +
          (known.empty() ? "are none" : "are " + known));
    }
  }
}

int vtkMoteLAMMPSDumpReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* information = outputVector->GetInformationObject(0);
  mote::offerTimeSteps(information, {});
  mote::offerPieces(information);
  this->AbortExecute = 0; // of an earlier run: only REQUEST_DATA resets it
  this->Ready = this->Attempt(
    [this](const mote::Progress& progress)
    {
      this->RequireFileName();
      this->Internal->Update(progress, this->LeaveOutDamagedEnd);
      this->OfferArrays();
    });
  if (this->Ready)
  {
    for (const auto& [name, file] : this->Internal->Files)
      if (!file.Index.warning.empty())
        vtkWarningMacro(<< file.Index.warning << " (the steps before it can be read)");
    std::vector<double> times;
    for (const Step& step : this->Internal->Steps)
      times.push_back(step.Time);
    mote::offerTimeSteps(information, times);
  }
  // Success in any case: a failed request would leave old data downstream, where this leads to
  // empty output.
  return 1;
}

int vtkMoteLAMMPSDumpReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* information = outputVector->GetInformationObject(0);
  vtkPolyData* output = vtkPolyData::GetData(information);
  output->Initialize();
  if (!this->Ready)
    return 1;                 // the error has been reported
  vtkNew<vtkPolyData> result; // the output sees nothing that is half read
  double time = 0;
  const bool good = this->Attempt(
    [&](const mote::Progress& progress)
    {
      if (this->Internal->FilesHaveChanged())
        this->Internal->Update(progress, this->LeaveOutDamagedEnd);
      const Step& step = mote::requestedStep(information, this->Internal->Steps, &Step::Time);
      time = step.Time;
      mote::LAMMPSReadOptions options;
      options.combine = this->CombineVectors;
      options.singlePrecision = this->SinglePrecision;
      options.space = this->GetScratchSpace();
      options.piece = mote::requestedPiece(information);
      options.wanted = [this](const std::string& name)
      { return this->Internal->Selection->ArrayIsEnabled(name.c_str()) != 0; };
      mote::readLAMMPSFrame(*step.File, *step.Frame, options, progress, result);
    });
  if (good)
    DeliverStep(result, time, output);
  return 1;
}

void vtkMoteLAMMPSDumpReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileNames: " << this->GetNumberOfFileNames() << "\n";
  for (const std::string& name : this->Internal->Names)
    os << indent.GetNextIndent() << name << "\n";
  os << indent << "TimeSteps: " << this->Internal->Steps.size() << "\n";
  os << indent << "CombineVectors: " << this->CombineVectors << "\n";
  os << indent << "LeaveOutDamagedEnd: " << this->LeaveOutDamagedEnd << "\n";
  os << indent << "SinglePrecision: " << this->SinglePrecision << "\n";
  os << indent << "PointDataArraySelection:\n";
  this->Internal->Selection->PrintSelf(os, indent.GetNextIndent());
}
