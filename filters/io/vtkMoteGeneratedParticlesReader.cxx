#include "vtkMoteGeneratedParticlesReader.h"

#include "FileError.h"

#include "kernels/core/Error.h"
#include "kernels/particles/GeneratedParticles.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMoteSourcePoints.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkMoteGeneratedParticlesReader);

vtkMoteGeneratedParticlesReader::vtkMoteGeneratedParticlesReader() = default;
vtkMoteGeneratedParticlesReader::~vtkMoteGeneratedParticlesReader() = default;

int vtkMoteGeneratedParticlesReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->Initialize();
  this->Attempt(
    [&](const ProgressFunction&)
    {
      this->RequireFileName();
      try
      {
        vtkNew<vtkMoteSourcePoints> points;
        points->SetSource(mote::makeParticles(this->GetFileName()));
        output->SetPoints(points);
      }
      catch (const mote::Error& error)
      {
        throw mote::FileError(mote::FileError::Kind::Malformed, this->GetFileName(),
          mote::withoutFile(error.what(), this->GetFileName()));
      }
    });
  return 1;
}

void vtkMoteGeneratedParticlesReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
