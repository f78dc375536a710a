#include "vtkMoteGeneratedParticlesReader.h"

#include "kernels/particles/GeneratedParticles.h"

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
  return this->RequestMade(outputVector,
    [](const std::string& name, vtkPolyData* output)
    {
      vtkNew<vtkMoteSourcePoints> points;
      points->SetSource(mote::makeParticles(name));
      output->SetPoints(points);
    });
}

void vtkMoteGeneratedParticlesReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
