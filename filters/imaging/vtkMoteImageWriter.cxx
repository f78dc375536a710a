#include "vtkMoteImageWriter.h"

#include "EncodeImage.h"
#include "ImageError.h"

#include "kernels/core/AtomicFile.h"

#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <cctype>
#include <new>

namespace
{

/// Share of the progress that encoding takes, the rest being the disk's.
constexpr double EncodingShare = 0.9;

/// Header entries that the formats need for themselves.
const char* const ReservedNames[] = {"name", "type", "version", "chunkCount", "channels",
  "compression", "dataWindow", "displayWindow", "lineOrder", "pixelAspectRatio",
  "screenWindowCenter", "screenWindowWidth", "tiles", "view", "multiView", "preview", "envmap",
  "Orientation", "chromaticities", "XResolution", "YResolution", "ResolutionUnit", "worldtocamera",
  "worldtoscreen", "fovx", "DateTime", "ICCProfile"};

std::string lowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool isAttributeName(const std::string& name)
{
  const auto isPlain = [](unsigned char c)
  { return c < 128 && (std::isalnum(c) || c == '_' || c == ' '); };
  const auto isSame = [&](const char* reserved) { return lowerCase(reserved) == lowerCase(name); };
  return !name.empty() && name.size() <= 31 && std::all_of(name.begin(), name.end(), isPlain) &&
         name.front() != ' ' && name.back() != ' ' &&
         std::none_of(std::begin(ReservedNames), std::end(ReservedNames), isSame);
}

unsigned long codeOf(const mote::WriteError& error)
{
  return error.kind() == mote::WriteError::Kind::NoSpace ? vtkErrorCode::OutOfDiskSpaceError
                                                         : vtkErrorCode::CannotOpenFileError;
}

} // namespace

vtkStandardNewMacro(vtkMoteImageWriter);

vtkMoteImageWriter::vtkMoteImageWriter() = default;

vtkMoteImageWriter::~vtkMoteImageWriter()
{
  this->SetFileName(nullptr);
}

int vtkMoteImageWriter::CanWriteFile(const char* fileName)
{
  return fileName && mote::imaging::formatOf(fileName) != mote::imaging::FileFormat::Unknown;
}

std::string vtkMoteImageWriter::GetErrorMessage() const
{
  return this->ErrorMessage;
}

void vtkMoteImageWriter::AddAttribute(const char* name, const char* value)
{
  if (!name || !value || !isAttributeName(name))
  {
    vtkWarningMacro(<< "\"" << (name ? name : "") << "\" cannot be the name of an attribute.");
    return;
  }
  const auto isSame = [&](const auto& entry) { return lowerCase(entry.first) == lowerCase(name); };
  const auto place = std::find_if(this->Attributes.begin(), this->Attributes.end(), isSame);
  if (place != this->Attributes.end())
    *place = {name, value};
  else
    this->Attributes.emplace_back(name, value);
  this->Modified();
}

void vtkMoteImageWriter::ClearAttributes()
{
  this->Attributes.clear();
  this->Modified();
}

int vtkMoteImageWriter::GetNumberOfAttributes() const
{
  return static_cast<int>(this->Attributes.size());
}

int vtkMoteImageWriter::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

void vtkMoteImageWriter::Fail(unsigned long code, const std::string& sentence)
{
  this->SetErrorCode(code);
  this->ErrorMessage = sentence;
  vtkErrorMacro(<< sentence);
}

int vtkMoteImageWriter::CheckFileName()
{
  this->SetErrorCode(vtkErrorCode::NoError);
  this->ErrorMessage.clear();
  const std::string name = this->FileName ? this->FileName : "";
  if (!name.empty() && !vtkMoteImageWriter::CanWriteFile(name.c_str()))
  {
    this->Fail(vtkErrorCode::UnrecognizedFileTypeError,
      "Cannot write \"" + name +
        "\": the name must end in .png, .jpg, .jpeg, .tif, .tiff or .exr.");
    return 0;
  }
  if (name.empty())
  {
    this->Fail(vtkErrorCode::NoFileNameError, "The image needs a file name.");
    return 0;
  }
  try
  {
    mote::checkWritable(name);
    mote::imaging::requireEncoder(mote::imaging::formatOf(name));
  }
  catch (const mote::imaging::ImageError& error)
  {
    this->Fail(error.code(), "Cannot write \"" + name + "\": " + error.what() + ".");
    return 0;
  }
  catch (const mote::WriteError& error)
  {
    this->Fail(codeOf(error), error.what());
    return 0;
  }
  return 1;
}

int vtkMoteImageWriter::Write()
{
  this->Written = false;
  if (!this->CheckFileName())
    return 0;
  const std::string cannotWrite = "Cannot write \"" + std::string(this->FileName) + "\": ";
  if (this->GetNumberOfInputConnections(0) < 1)
  {
    this->Fail(vtkErrorCode::UnknownError, cannotWrite + "there is no image to write.");
    return 0;
  }
  this->Superclass::Write();
  if (!this->Written && this->ErrorMessage.empty())
    this->Fail(vtkErrorCode::UnknownError, cannotWrite + "the image could not be made.");
  return this->Written ? 1 : 0;
}

void vtkMoteImageWriter::WriteData()
{
  this->Written = false;
  this->ErrorMessage.clear();
  vtkImageData* image = vtkImageData::SafeDownCast(this->GetInput());
  const std::string cannotWrite =
    "Cannot write \"" + std::string(this->FileName ? this->FileName : "") + "\": ";
  try
  {
    this->WriteImage(image);
    this->Written = true;
  }
  catch (const mote::imaging::ImageError& error)
  {
    this->Fail(error.code(), error.what());
  }
  catch (const mote::WriteError& error)
  {
    this->Fail(codeOf(error), error.what());
  }
  catch (const std::bad_alloc&)
  {
    this->Fail(vtkErrorCode::UnknownError, cannotWrite + "the image does not fit in memory.");
  }
  catch (const std::exception& error)
  {
    this->Fail(vtkErrorCode::UnknownError, cannotWrite + error.what() + ".");
  }
}

void vtkMoteImageWriter::WriteImage(vtkImageData* image)
{
  const std::string name = this->FileName ? this->FileName : "";
  mote::imaging::EncodeOptions options;
  options.quality = this->Quality;
  options.attributes = this->Attributes;
  options.progress = [this](double share)
  {
    this->UpdateProgress(EncodingShare * share);
    return !this->GetAbortExecute();
  };
  mote::imaging::EncodedImage encoded;
  try
  {
    encoded = mote::imaging::encodeImage(image, mote::imaging::formatOf(name), options);
  }
  catch (const mote::imaging::ImageError& error)
  {
    throw mote::imaging::ImageError(
      error.code(), "Cannot write \"" + name + "\": " + error.what() + ".");
  }
  for (const std::string& array : encoded.leftOut)
  {
    vtkWarningMacro(<< "\"" << name << "\" is without the array \"" << array
                    << "\", whose name is empty or that of another channel.");
  }
  mote::AtomicFile file(name);
  file.write(encoded.bytes.data(), encoded.bytes.size());
  file.commit();
  this->UpdateProgress(1.0);
}

void vtkMoteImageWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Quality: " << this->Quality << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
  os << indent << "Attributes:\n";
  for (const auto& [name, value] : this->Attributes)
    os << indent.GetNextIndent() << name << ": " << value << "\n";
}
