#include "ChartFile.h"

#include "base/Failure.h"
#include "base/Messages.h"

#include <vtkAlgorithm.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMoteImageWriter.h>
#include <vtkNew.h>
#include <vtkPointData.h>

namespace mote::app
{

vtkSmartPointer<vtkImageData> whitePaper(int width, int height)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  vtkNew<vtkFloatArray> pixels;
  pixels->SetName("color");
  pixels->SetNumberOfComponents(4);
  pixels->SetNumberOfTuples(image->GetNumberOfPoints());
  pixels->Fill(1.0);
  image->GetPointData()->SetScalars(pixels);
  return image;
}

std::string withUnit(const std::string& name, const std::string& unit)
{
  return unit.empty() ? name : name + " (" + unit + ")";
}

void writeChart(vtkAlgorithm* source, const std::string& file)
{
  vtkNew<vtkMoteImageWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputConnection(source->GetOutputPort());
  Messages::takeError();
  if (!writer->Write())
    throw Failure(writer->GetErrorMessage());
}

} // namespace mote::app
