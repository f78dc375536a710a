#include "FoamReader.h"

#include "FileError.h"
#include "FoamCase.h"
#include "MessageCatcher.h"

#include "vtkDummyController.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPOpenFOAMReader.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace
{

class vtkMoteFoamReader : public vtkPOpenFOAMReader
{
public:
  static vtkMoteFoamReader* New();
  vtkTypeMacro(vtkMoteFoamReader, vtkPOpenFOAMReader);

  mote::FoamCase Case;

protected:
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    vtkInformation* information = outputs->GetInformationObject(0);
    auto* const key = vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP();
    try
    {
      mote::checkFoamFields(this->Case, information->Has(key) ? information->Get(key) : 0.0);
    }
    catch (const mote::FileError& error)
    {
      vtkMultiBlockDataSet::GetData(information)->Initialize();
      vtkErrorMacro(<< error.what());
      return 1; // a failed request would leave old data downstream
    }
    return this->Superclass::RequestData(request, inputs, outputs);
  }
};

vtkStandardNewMacro(vtkMoteFoamReader);

} // namespace

namespace mote
{

vtkSmartPointer<vtkAlgorithm> makeFoamReader(const std::string& fileName)
{
  auto reader = vtkSmartPointer<vtkMoteFoamReader>::New();
  reader->Case = foamCaseOf(fileName);
  reader->SetController(vtkNew<vtkDummyController>()); // it does not look whether there is one
  reader->SetFileName(fileName.c_str());
  reader->SetCaseType(reader->Case.isDecomposed ? vtkPOpenFOAMReader::DECOMPOSED_CASE
                                                : vtkPOpenFOAMReader::RECONSTRUCTED_CASE);
  reader->DecomposePolyhedraOff();
  const MessageCatcher catcher(reader);
  reader->UpdateInformation();
  if (const std::string error = catcher.firstError(); !error.empty())
    throw FileError(FileError::Kind::Malformed, fileName, error);
  reader->EnableAllPatchArrays();
  reader->EnableAllCellArrays();
  reader->EnableAllPointArrays();
  reader->EnableAllLagrangianArrays();
  reader->Modified();
  return reader;
}

} // namespace mote
