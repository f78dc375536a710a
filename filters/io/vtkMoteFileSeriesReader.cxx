#include "vtkMoteFileSeriesReader.h"

#include "Piece.h"
#include "ReadInside.h"
#include "TextFile.h"
#include "TimeSteps.h"
#include "vtkMoteReaderTable.h"
#include "vtkMoteXYZReader.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

struct Step
{
  double Time = 0; ///< not a number: not known
  std::string File;
  std::optional<double> Frame; ///< its time in a file of several
};

/// Ends the work under way (see Attempt) with a sentence, which names a file.
[[noreturn]] void fail(const std::string& sentence)
{
  throw std::runtime_error(sentence);
}

/// A file's reader with its information.
vtkSmartPointer<vtkAlgorithm> open(const std::string& file, std::vector<double>& times)
{
  std::string error;
  auto reader = vtkMoteReaderTable::MakeReader(file, error);
  if (reader)
    times = vtkMoteReaderTable::GetTimeSteps(reader, error);
  if (!error.empty())
    fail(error);
  return reader;
}

void requireOneStep(const std::string& file, const std::vector<double>& times)
{
  if (times.size() > 1)
    fail(file + ": this file has " + std::to_string(times.size()) +
         " time steps, and the files of a series have one each; read it by itself");
}

/// The steps of a file: one, or the frames of XYZ.
std::vector<Step> stepsOf(
  const std::string& file, vtkAlgorithm* reader, const std::vector<double>& times)
{
  if (!vtkMoteXYZReader::SafeDownCast(reader))
    requireOneStep(file, times);
  if (times.size() < 2)
    return {{times.empty() ? std::nan("") : times.front(), file, {}}};
  std::vector<Step> steps;
  for (const double time : times)
    steps.push_back({time, file, time});
  return steps;
}

/// Hands on what a pipeline must know before anything is read: the extent of images, and whether
/// each of several processes may have its piece.
void copyExtent(vtkAlgorithm* reader, vtkInformation* information)
{
  vtkInformation* from = reader->GetOutputInformation(0);
  if (vtkMotePolyDataReader::SafeDownCast(reader))
    information->CopyEntry(from, vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST());
  information->CopyEntry(from, Pipeline::WHOLE_EXTENT());
  information->CopyEntry(from, vtkDataObject::ORIGIN());
  information->CopyEntry(from, vtkDataObject::SPACING());
  information->CopyEntry(from, vtkDataObject::DIRECTION());
  information->CopyEntry(from, vtkDataObject::POINT_DATA_VECTOR());
  information->CopyEntry(from, vtkDataObject::CELL_DATA_VECTOR());
}

std::string asText(const int extent[6])
{
  std::string text;
  for (int i = 0; i < 6; ++i)
    text += (i > 0 ? " " : "") + std::to_string(extent[i]);
  return text;
}

/// A pipeline plans with the first file's type and extent.
void requireLikeFirst(
  const std::string& file, vtkDataObject* data, vtkDataObject* output, vtkInformation* information)
{
  if (data->GetDataObjectType() != output->GetDataObjectType())
  {
    fail(file + ": this file holds a " + data->GetClassName() +
         ", and the first one of the series a " + output->GetClassName());
  }
  auto* wholeKey = Pipeline::WHOLE_EXTENT();
  auto* ownKey = vtkDataObject::DATA_EXTENT();
  vtkInformation* facts = data->GetInformation();
  if (!information->Has(wholeKey) || !facts->Has(ownKey)) // VTK's Get does not survive without
    return;
  const int* whole = information->Get(wholeKey);
  const int* own = facts->Get(ownKey);
  if (!std::equal(whole, whole + 6, own))
  {
    fail(file + ": this file has the extent " + asText(own) + ", and the first one of the series " +
         asText(whole));
  }
}

} // namespace

class vtkMoteFileSeriesReader::Internals
{
public:
  explicit Internals(vtkMoteFileSeriesReader* self)
    : Self(self)
  {
  }

  template <class Work>
  bool Attempt(const Work& work);
  void FindSteps(vtkInformation* information);
  vtkDataObject* ReadStep(const Step& step, const mote::Piece& piece);

  vtkMoteFileSeriesReader* Self;
  std::vector<std::string> Names;
  std::vector<Step> Steps;

  // The step that was last read.
  std::string File;
  std::optional<double> Frame;
  mote::Piece Asked;
  mote::FileStamp Stamp;
  vtkSmartPointer<vtkDataObject> Data;
};

/// True if the work threw nothing; otherwise the error has been reported.
template <class Work>
bool vtkMoteFileSeriesReader::Internals::Attempt(const Work& work)
{
  this->Self->LastErrorMessage.clear();
  try
  {
    work();
    return true;
  }
  catch (const std::runtime_error& error) // a FileError is one
  {
    this->Data = nullptr;
    this->Self->LastErrorMessage = error.what();
    if (!this->Self->GetAbortExecute())
      vtkErrorWithObjectMacro(this->Self, << error.what());
  }
  return false;
}

/// Finds the steps and describes the first one's data.
void vtkMoteFileSeriesReader::Internals::FindSteps(vtkInformation* information)
{
  this->Steps.clear();
  if (this->Names.empty())
    fail(std::string(this->Self->GetClassName()) + ": no file name has been set");
  bool haveTimes = true, haveFrames = false;
  std::size_t done = 0;
  for (const std::string& name : this->Names)
  {
    std::vector<Step> own = {{std::nan(""), name, {}}};
    if (haveTimes || haveFrames)
    {
      std::vector<double> times;
      const auto reader = open(name, times);
      own = stepsOf(name, reader, times);
      if (this->Steps.empty())
        copyExtent(reader, information);
    }
    haveFrames = haveFrames || own.size() > 1;
    for (const Step& step : own)
    {
      const bool isLater = this->Steps.empty() || this->Steps.back().Time < step.Time;
      haveTimes = haveTimes && isLater && !std::isnan(step.Time);
      this->Steps.push_back(step);
    }
    this->Self->UpdateProgress(static_cast<double>(++done) / this->Names.size());
    if (this->Self->GetAbortExecute())
      fail(name + ": reading was aborted");
  }
  for (std::size_t i = 0; !haveTimes && i < this->Steps.size(); ++i)
    this->Steps[i].Time = static_cast<double>(i);
}

/// The step's data.
vtkDataObject* vtkMoteFileSeriesReader::Internals::ReadStep(
  const Step& step, const mote::Piece& piece)
{
  const mote::FileStamp stamp = mote::stampOf(step.File);
  if (this->Data && this->File == step.File && this->Frame == step.Frame && this->Asked == piece &&
      this->Stamp == stamp)
    return this->Data;
  this->Data = nullptr; // before the memory is needed for the next
  std::vector<double> times;
  const auto reader = open(step.File, times);
  if (!step.Frame)
    requireOneStep(step.File, times);
  if (!piece.isAll() && vtkMotePolyDataReader::SafeDownCast(reader))
  {
    vtkInformation* request = reader->GetOutputInformation(0);
    request->Set(Pipeline::UPDATE_PIECE_NUMBER(), piece.number);
    request->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), piece.count);
  }
  std::string error, warnings;
  this->Data = mote::readInside(this->Self, reader, step.Frame, error, warnings);
  if (this->Self->GetAbortExecute())
    fail(step.File + ": reading was aborted");
  if (!error.empty())
    fail(error);
  if (!warnings.empty())
    vtkWarningWithObjectMacro(this->Self, << warnings);
  this->File = step.File;
  this->Frame = step.Frame;
  this->Asked = piece;
  this->Stamp = stamp;
  return this->Data;
}

vtkStandardNewMacro(vtkMoteFileSeriesReader);

vtkMoteFileSeriesReader::vtkMoteFileSeriesReader()
  : Internal(std::make_unique<Internals>(this))
{
  this->SetNumberOfInputPorts(0);
}

vtkMoteFileSeriesReader::~vtkMoteFileSeriesReader() = default;

void vtkMoteFileSeriesReader::AddFileName(const char* fileName)
{
  if (fileName && *fileName)
  {
    this->Internal->Names.emplace_back(fileName);
    this->Modified();
  }
}

void vtkMoteFileSeriesReader::RemoveAllFileNames()
{
  if (!this->Internal->Names.empty())
  {
    this->Internal->Names.clear();
    this->Modified();
  }
}

int vtkMoteFileSeriesReader::GetNumberOfFileNames()
{
  return static_cast<int>(this->Internal->Names.size());
}

const char* vtkMoteFileSeriesReader::GetFileName(int index)
{
  const bool valid = index >= 0 && index < this->GetNumberOfFileNames();
  return valid ? this->Internal->Names[index].c_str() : nullptr;
}

std::string vtkMoteFileSeriesReader::GetLastErrorMessage()
{
  return this->LastErrorMessage;
}

int vtkMoteFileSeriesReader::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* information = outputVector->GetInformationObject(0);
  vtkDataObject* before = information->Get(vtkDataObject::DATA_OBJECT());
  vtkSmartPointer<vtkDataObject> sample = before;
  try
  {
    std::vector<double> times;
    if (!this->Internal->Names.empty())
      sample = open(this->Internal->Names.front(), times)->GetOutputDataObject(0);
  }
  catch (const std::runtime_error&)
  {
    // RequestInformation comes next and reports it.
  }
  if (!sample)
    sample = vtkSmartPointer<vtkPolyData>::New();
  if (!before || before->GetDataObjectType() != sample->GetDataObjectType())
  {
    auto output = vtkSmartPointer<vtkDataObject>::Take(sample->NewInstance());
    information->Set(vtkDataObject::DATA_OBJECT(), output);
  }
  return 1;
}

int vtkMoteFileSeriesReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* information = outputVector->GetInformationObject(0);
  mote::offerTimeSteps(information, {});
  this->AbortExecute = 0; // of an earlier run: only REQUEST_DATA resets it
  this->Ready = this->Internal->Attempt([&] { this->Internal->FindSteps(information); });
  if (this->Ready)
  {
    std::vector<double> times;
    for (const Step& step : this->Internal->Steps)
      times.push_back(step.Time);
    mote::offerTimeSteps(information, times);
  }
  // Success in any case: a failed request would leave old data downstream, where this leads to
  // empty output.
  return 1;
}

int vtkMoteFileSeriesReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* information = outputVector->GetInformationObject(0);
  vtkDataObject* output = information->Get(vtkDataObject::DATA_OBJECT());
  output->Initialize();
  if (!this->Ready)
    return 1; // the error has been reported
  this->Internal->Attempt(
    [&]
    {
      const Step& step = mote::requestedStep(information, this->Internal->Steps, &Step::Time);
      vtkDataObject* data = this->Internal->ReadStep(step, mote::requestedPiece(information));
      requireLikeFirst(step.File, data, output, information);
      output->ShallowCopy(data);
      output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), step.Time);
    });
  return 1;
}

void vtkMoteFileSeriesReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileNames: " << this->GetNumberOfFileNames() << "\n";
  for (const std::string& name : this->Internal->Names)
    os << indent.GetNextIndent() << name << "\n";
  os << indent << "TimeSteps: " << this->Internal->Steps.size() << "\n";
  os << indent << "LastErrorMessage: " << this->LastErrorMessage << "\n";
}
