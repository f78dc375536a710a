#include "vtkMoteParticleFormatsReader.h"

#include "FileError.h"
#include "StepSource.h"
#include "TimeSteps.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

class vtkMoteParticleFormatsReader::Internals
{
public:
  std::string Name;
  mote::FileStamp Stamp;
  std::unique_ptr<mote::StepSource> Source; ///< null: not open, or not readable

  /// Opens the file where it is another one by now.
  void Update(const std::string& name, const mote::Progress& progress)
  {
    const mote::FileStamp stamp = mote::stampOf(name);
    if (this->Source && name == this->Name && stamp == this->Stamp)
      return;
    this->Source.reset();
    this->Source = mote::openStepSource(name, progress);
    this->Name = name;
    this->Stamp = stamp;
  }
};

vtkStandardNewMacro(vtkMoteParticleFormatsReader);

vtkMoteParticleFormatsReader::vtkMoteParticleFormatsReader()
  : Internal(std::make_unique<Internals>())
{
}

vtkMoteParticleFormatsReader::~vtkMoteParticleFormatsReader() = default;

int vtkMoteParticleFormatsReader::RequestInformation(
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
    this->Internal->Source.reset();
    return 1;
  }
  mote::offerTimeSteps(information, this->Internal->Source->times());
  if (const std::string warning = this->Internal->Source->warning(); !warning.empty())
    vtkWarningMacro(<< warning);
  return 1;
}

int vtkMoteParticleFormatsReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  struct Step
  {
    double time = 0;
    std::size_t number = 0;
  };
  vtkInformation* information = outputVector->GetInformationObject(0);
  vtkPolyData* output = vtkPolyData::GetData(information);
  output->Initialize();
  if (!this->Internal->Source)
    return 1; // the error has been reported
  vtkNew<vtkPolyData> result;
  double time = 0;
  const bool good = this->Attempt(
    [&](const ProgressFunction& progress)
    {
      this->Internal->Update(this->GetFileName(), progress);
      std::vector<Step> steps;
      for (const double one : this->Internal->Source->times())
        steps.push_back({one, steps.size()});
      const Step& step = mote::requestedStep(information, steps, &Step::time);
      time = step.time;
      this->Internal->Source->read(
        {step.number, mote::requestedPiece(information), this->GetScratchSpace(), progress},
        result);
    });
  if (good)
    DeliverStep(result, time, output);
  return 1;
}

void vtkMoteParticleFormatsReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Open: " << (this->Internal->Source ? "yes" : "no") << "\n";
}
