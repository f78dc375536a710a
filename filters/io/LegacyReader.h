#ifndef MoteLegacyReader_h
#define MoteLegacyReader_h

#include "LegacyTime.h"
#include "TextFile.h"
#include "TimeSteps.h"

#include "vtkDemandDrivenPipeline.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

#include <vector>

namespace mote
{

/// VTK's reader of legacy files. By itself it keeps one array of each kind (scalars, vectors ...),
/// and says that every file is of time 0: here it keeps all, and a file is of the time that it
/// tells, or of none.
class LegacyReader : public vtkGenericDataObjectReader
{
public:
  static LegacyReader* New() { VTK_STANDARD_NEW_BODY(LegacyReader); }

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    const vtkTypeBool done =
      this->vtkGenericDataObjectReader::ProcessRequest(request, inputs, outputs);
    if (done && request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()) && this->GetFileName())
    {
      const auto time = legacyTime(readBeginning(this->GetFileName(), 4096));
      offerTimeSteps(
        outputs->GetInformationObject(0), time ? std::vector{*time} : std::vector<double>());
    }
    return done;
  }

protected:
  LegacyReader()
  {
    this->ReadAllScalarsOn();
    this->ReadAllVectorsOn();
    this->ReadAllNormalsOn();
    this->ReadAllTensorsOn();
    this->ReadAllColorScalarsOn();
    this->ReadAllTCoordsOn();
    this->ReadAllFieldsOn();
  }
};

} // namespace mote

#endif
