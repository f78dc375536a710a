#include "EnSightReader.h"

#include "EnSightCase.h"
#include "FileError.h"

#include "vtkCompositeDataSet.h"
#include "vtkGenericEnSightReader.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <optional>

namespace
{

/// Names of binary files are filled up with blanks.
void trimNames(vtkMultiBlockDataSet* blocks)
{
  auto* const key = vtkCompositeDataSet::NAME();
  for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
  {
    vtkInformation* facts = blocks->HasMetaData(i) ? blocks->GetMetaData(i) : nullptr;
    std::string name = facts && facts->Has(key) ? facts->Get(key) : "";
    name.erase(name.find_last_not_of(" \t\r\n") + 1);
    if (!name.empty())
      facts->Set(key, name);
  }
}

class vtkMoteEnSightReader : public vtkGenericEnSightReader
{
public:
  static vtkMoteEnSightReader* New();
  vtkTypeMacro(vtkMoteEnSightReader, vtkGenericEnSightReader);

  std::string Path; ///< of the case, with its folder, which VTK keeps apart

protected:
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    vtkInformation* information = outputs->GetInformationObject(0);
    auto* output = vtkMultiBlockDataSet::GetData(information);
    auto* const key = vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP();
    try
    {
      mote::EnSightCase(this->Path)
        .checkAt(information->Has(key) ? std::optional(information->Get(key)) : std::nullopt);
    }
    catch (const mote::FileError& error)
    {
      output->Initialize();
      vtkErrorMacro(<< error.what());
      return 1; // a failed request would leave old data downstream
    }
    const int result = this->Superclass::RequestData(request, inputs, outputs);
    trimNames(output);
    return result;
  }
};

vtkStandardNewMacro(vtkMoteEnSightReader);

} // namespace

namespace mote
{

vtkSmartPointer<vtkAlgorithm> makeEnSightReader(const std::string& fileName)
{
  EnSightCase(fileName).requireFiles();
  auto reader = vtkSmartPointer<vtkMoteEnSightReader>::New();
  reader->SetCaseFileName(fileName.c_str());
  reader->Path = fileName;
  return reader;
}

} // namespace mote
