#include "vtkMoteImageReader.h"

#include "ImageCodecs.h"
#include "ImageError.h"

#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <new>

vtkStandardNewMacro(vtkMoteImageReader);

vtkMoteImageReader::vtkMoteImageReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkMoteImageReader::~vtkMoteImageReader()
{
  this->SetFileName(nullptr);
}

int vtkMoteImageReader::CanReadFile(const char* fileName)
{
  try
  {
    return fileName && mote::imaging::imageCodecs().readSize(fileName).width > 0;
  }
  catch (const mote::imaging::ImageError&)
  {
    return 0;
  }
}

/// Runs work(name); 1, or 0 with what went wrong reported.
template <typename Work>
int vtkMoteImageReader::Try(const Work& work)
{
  this->ErrorMessage.clear();
  this->SetErrorCode(vtkErrorCode::NoError);
  const std::string name = this->FileName ? this->FileName : "";
  try
  {
    if (name.empty())
      throw mote::imaging::ImageError(vtkErrorCode::NoFileNameError, "it has no name");
    work(name);
    return 1;
  }
  catch (const mote::imaging::ImageError& error)
  {
    this->ErrorMessage = std::string("Cannot read \"") + name + "\": " + error.what() + ".";
    this->SetErrorCode(error.code());
  }
  catch (const std::bad_alloc&)
  {
    this->ErrorMessage =
      std::string("Cannot read \"") + name + "\": the image does not fit in memory.";
    this->SetErrorCode(vtkErrorCode::UnknownError);
  }
  vtkErrorMacro(<< this->ErrorMessage);
  return 0;
}

int vtkMoteImageReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  return this->Try(
    [&](const std::string& name)
    {
      const mote::imaging::ImageSize size = mote::imaging::imageCodecs().readSize(name);
      const int extent[6] = {0, size.width - 1, 0, size.height - 1, 0, 0};
      const double spacing[3] = {1.0, 1.0, 1.0}, origin[3] = {0.0, 0.0, 0.0};
      vtkInformation* out = outputVector->GetInformationObject(0);
      out->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
      out->Set(vtkDataObject::SPACING(), spacing, 3);
      out->Set(vtkDataObject::ORIGIN(), origin, 3);
    });
}

int vtkMoteImageReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector);
  const int success =
    this->Try([&](const std::string& name) { mote::imaging::imageCodecs().decode(name, output); });
  if (!success)
    output->Initialize();
  return success;
}

void vtkMoteImageReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
