#include "PDBReader.h"

#include "FileError.h"
#include "PDBCheck.h"

#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPDBReader.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace
{

/// Without vtkTypeMacro on purpose: in the eyes of others, Python among them, it is a vtkPDBReader.
class CheckedPDBReader : public vtkPDBReader
{
public:
  static CheckedPDBReader* New();

protected:
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
};

vtkStandardNewMacro(CheckedPDBReader);

void makeRadiusScalar(vtkPointData* arrays)
{
  vtkDataArray* triple = arrays->GetArray("radius");
  if (!triple || triple->GetNumberOfComponents() == 1)
    return;
  vtkNew<vtkFloatArray> radius;
  radius->SetName("radius");
  radius->SetNumberOfTuples(triple->GetNumberOfTuples());
  radius->CopyComponent(0, triple, 0);
  arrays->RemoveArray("radius"); // it was the active vector as well
  arrays->AddArray(radius);
}

int CheckedPDBReader::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  try
  {
    mote::checkPDBIsWhole(this->FileName ? this->FileName : "");
  }
  catch (const mote::FileError& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 1; // a failed request would leave old data downstream
  }
  const int result = this->vtkPDBReader::RequestData(request, inputVector, outputVector);
  makeRadiusScalar(output->GetPointData());
  return result;
}

} // namespace

namespace mote
{

vtkSmartPointer<vtkAlgorithm> makePDBReader(const std::string& fileName)
{
  auto reader = vtkSmartPointer<CheckedPDBReader>::New();
  reader->SetFileName(fileName.c_str());
  return reader;
}

} // namespace mote
