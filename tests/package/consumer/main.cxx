// A program as others write it: reads particles, renders them without a display, writes a PNG.
#include <vtkActor.h>
#include <vtkMoteImageWriter.h>
#include <vtkMoteParticleMapper.h>
#include <vtkMoteParticlePicker.h>
#include <vtkMoteRayCastPass.h>
#include <vtkMoteReaderTable.h>
#include <vtkMoteRendererSource.h>
#include <vtkMoteXYZReader.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <cstdio>
#include <fstream>

int main()
{
  std::ofstream("particles.xyz") << "3\nthree of them\nAr 0 0 0\nAr 1 0 0\nAr 0 1 0\n";
  vtkNew<vtkMoteXYZReader> reader;
  reader->SetFileName("particles.xyz");
  vtkNew<vtkMoteParticleMapper> mapper;
  mapper->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkMoteRayCastPass> pass; // can be made, though nothing draws it here
  vtkNew<vtkMoteRendererSource> source;
  source->SetRenderer(renderer);
  source->SetSize(64, 64);
  vtkNew<vtkMoteImageWriter> writer;
  writer->SetInputConnection(source->GetOutputPort());
  bool written = true;
  for (const char* name :
    {"picture.png", "picture.exr"}) // the latter by a library that is loaded then
  {
    writer->SetFileName(name);
    written = writer->Write() == 1 && written;
  }
  std::printf("%lld particles, picture written: %d\n",
    static_cast<long long>(mapper->GetNumberOfParticles()), written);
  return written && mapper->GetNumberOfParticles() == 3 ? 0 : 1;
}
