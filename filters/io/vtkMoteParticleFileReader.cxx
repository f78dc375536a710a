#include "vtkMoteParticleFileReader.h"

#include "OpenMoteFile.h"
#include "TimeSteps.h"

#include "kernels/particles/PkdTreeFile.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMoteParticleFilePoints.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

vtkStandardNewMacro(vtkMoteParticleFileReader);

vtkMoteParticleFileReader::vtkMoteParticleFileReader() = default;
vtkMoteParticleFileReader::~vtkMoteParticleFileReader() = default;

bool vtkMoteParticleFileReader::Open()
{
  this->File = nullptr;
  return this->Attempt(
    [this](const ProgressFunction&)
    {
      this->RequireFileName();
      this->File = mote::openMoteFile<mote::PkdTreeFile>(this->GetFileName());
    });
}

int vtkMoteParticleFileReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* information = outputVector->GetInformationObject(0);
  mote::offerTimeSteps(information, {});
  if (this->Open() && this->File->time())
    mote::offerTimeSteps(information, {*this->File->time()});
  return 1;
}

int vtkMoteParticleFileReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->Initialize();
  if (!this->File)
    return 1; // the error has been reported
  vtkNew<vtkPolyData> result;
  vtkNew<vtkMoteParticleFilePoints> points;
  points->SetFile(this->File);
  result->SetPoints(points);
  const auto add = [this](vtkFieldData* to, std::size_t count, bool ofWhole)
  {
    for (std::size_t i = 0; i < count; ++i)
      to->AddArray(vtkSmartPointer<vtkDataArray>::Take(
        vtkMoteParticleFilePoints::NewArray(this->File, i, ofWhole)));
  };
  add(result->GetPointData(), this->File->arrays().size(), false);
  add(result->GetFieldData(), this->File->facts().size(), true);
  if (this->File->time())
    DeliverStep(result, *this->File->time(), output);
  else
    output->ShallowCopy(result);
  return 1;
}

void vtkMoteParticleFileReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Particles: " << (this->File ? this->File->size() : 0) << "\n";
}
