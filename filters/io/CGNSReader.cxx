#include "CGNSReader.h"

#include "vtkCGNSReader.h"
#include "vtkDataArraySelection.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

#include <mutex>

namespace
{

std::mutex oneAtATime; // CGNS's library keeps one state

class vtkMoteCGNSReader : public vtkCGNSReader
{
public:
  static vtkMoteCGNSReader* New();
  vtkTypeMacro(vtkMoteCGNSReader, vtkCGNSReader);

protected:
  vtkMoteCGNSReader() { this->LoadBndPatchOn(); }

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    const std::lock_guard lock(oneAtATime);
    const int result = this->Superclass::RequestInformation(request, inputs, outputs);
    // What there is to choose from is known now.
    this->BaseSelection->EnableAllArrays();
    this->FamilySelection->EnableAllArrays();
    this->PointDataArraySelection->EnableAllArrays();
    this->CellDataArraySelection->EnableAllArrays();
    return result;
  }

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    const std::lock_guard lock(oneAtATime);
    return this->Superclass::RequestData(request, inputs, outputs);
  }
};

vtkStandardNewMacro(vtkMoteCGNSReader);

} // namespace

namespace mote
{

vtkSmartPointer<vtkAlgorithm> makeCGNSReader(const std::string& fileName)
{
  auto reader = vtkSmartPointer<vtkMoteCGNSReader>::New();
  reader->SetFileName(fileName.c_str());
  return reader;
}

} // namespace mote
