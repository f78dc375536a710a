#include "FoamReader.h"

#include "FoamCase.h"
#include "MessageCatcher.h"

#include "vtkDummyController.h"
#include "vtkNew.h"
#include "vtkPOpenFOAMReader.h"

namespace mote
{

vtkSmartPointer<vtkAlgorithm> makeFoamReader(const std::string& fileName)
{
  const FoamCase found = foamCaseOf(fileName);
  auto reader = vtkSmartPointer<vtkPOpenFOAMReader>::New();
  reader->SetController(vtkNew<vtkDummyController>()); // it does not look whether there is one
  reader->SetFileName(fileName.c_str());
  reader->SetCaseType(found.isDecomposed ? vtkPOpenFOAMReader::DECOMPOSED_CASE
                                         : vtkPOpenFOAMReader::RECONSTRUCTED_CASE);
  reader->DecomposePolyhedraOff();
  const MessageCatcher catcher(reader); // whoever updates next hears them again
  reader->UpdateInformation();
  reader->EnableAllPatchArrays();
  reader->EnableAllCellArrays();
  reader->EnableAllPointArrays();
  reader->EnableAllLagrangianArrays();
  reader->Modified();
  return reader;
}

} // namespace mote
