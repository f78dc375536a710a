#include "vtkMoteCollectionReader.h"

#include "FileCollection.h"
#include "FileError.h"
#include "ReadInside.h"
#include "TimeSteps.h"
#include "vtkMoteReaderTable.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkMoteCollectionReader::Internals
{
public:
  std::vector<mote::CollectedStep> Steps; ///< none: they could not be found
};

vtkStandardNewMacro(vtkMoteCollectionReader);

vtkMoteCollectionReader::vtkMoteCollectionReader()
  : Internal(std::make_unique<Internals>())
{
  this->SetNumberOfInputPorts(0);
}

vtkMoteCollectionReader::~vtkMoteCollectionReader()
{
  this->SetFileName(nullptr);
}

int vtkMoteCollectionReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  std::vector<double> times;
  this->Internal->Steps.clear();
  try
  {
    this->Internal->Steps = mote::stepsOfCollection(this->FileName ? this->FileName : "");
    for (const mote::CollectedStep& step : this->Internal->Steps)
      times.push_back(step.time);
  }
  catch (const mote::FileError& error)
  {
    vtkErrorMacro(<< error.what());
  }
  mote::offerTimeSteps(outputVector->GetInformationObject(0), times);
  // Success in any case: a failed request would leave old data downstream.
  return 1;
}

int vtkMoteCollectionReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* information = outputVector->GetInformationObject(0);
  auto* output = vtkMultiBlockDataSet::GetData(information);
  output->Initialize();
  if (this->Internal->Steps.empty())
    return 1; // the error has been reported
  const mote::CollectedStep& step =
    mote::requestedStep(information, this->Internal->Steps, &mote::CollectedStep::time);
  for (const mote::CollectedFile& file : step.files)
  {
    std::string error, warnings;
    const auto reader = vtkMoteReaderTable::MakeReader(file.path, error);
    const auto data = reader ? mote::readInside(this, reader, {}, error, warnings) : nullptr;
    if (this->GetAbortExecute() || !error.empty())
    {
      output->Initialize();
      if (!this->GetAbortExecute())
        vtkErrorMacro(<< this->FileName << ": " << error);
      return 1;
    }
    if (!warnings.empty())
      vtkWarningMacro(<< warnings);
    const unsigned int block = output->GetNumberOfBlocks();
    output->SetBlock(block, data);
    if (!file.name.empty())
      output->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), file.name);
  }
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), step.time);
  return 1;
}

void vtkMoteCollectionReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "TimeSteps: " << this->Internal->Steps.size() << "\n";
}
