#include "vtkMotePolyDataReader.h"

#include "FileError.h"

#include "kernels/core/Error.h"

#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <new>

namespace
{

unsigned long errorCodeOf(mote::FileError::Kind kind)
{
  using Kind = mote::FileError::Kind;
  switch (kind)
  {
  case Kind::NotFound:
    return vtkErrorCode::FileNotFoundError;
  case Kind::CannotOpen:
    return vtkErrorCode::CannotOpenFileError;
  case Kind::OtherFormat:
    return vtkErrorCode::UnrecognizedFileTypeError;
  case Kind::Truncated:
    return vtkErrorCode::PrematureEndOfFileError;
  case Kind::Malformed:
    return vtkErrorCode::FileFormatError;
  case Kind::Aborted:
    break;
  }
  return vtkErrorCode::UserError;
}

} // namespace

vtkMotePolyDataReader::vtkMotePolyDataReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkMotePolyDataReader::~vtkMotePolyDataReader() = default;

void vtkMotePolyDataReader::SetFileName(const char* fileName)
{
  const std::string name = fileName ? fileName : "";
  if (name != this->FileName)
  {
    this->FileName = name;
    this->Modified();
  }
}

const char* vtkMotePolyDataReader::GetFileName()
{
  return this->FileName.empty() ? nullptr : this->FileName.c_str();
}

std::string vtkMotePolyDataReader::GetLastErrorMessage()
{
  return this->LastErrorMessage;
}

void vtkMotePolyDataReader::SetScratchSpace(std::shared_ptr<mote::ScratchSpace> space)
{
  if (space != this->Space)
  {
    this->Space = std::move(space);
    this->Modified();
  }
}

std::shared_ptr<mote::ScratchSpace> vtkMotePolyDataReader::GetScratchSpace() const
{
  return this->Space;
}

void vtkMotePolyDataReader::RequireFileName()
{
  if (!this->GetFileName())
  {
    throw mote::FileError(
      mote::FileError::Kind::NotFound, this->GetClassName(), "no file name has been set");
  }
}

void vtkMotePolyDataReader::DeliverStep(vtkPolyData* result, double time, vtkPolyData* output)
{
  vtkNew<vtkDoubleArray> value;
  value->SetName("TimeValue");
  value->InsertNextValue(time);
  result->GetFieldData()->AddArray(value);
  output->ShallowCopy(result);
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
}

int vtkMotePolyDataReader::RequestMade(vtkInformationVector* outputVector,
  const std::function<void(const std::string&, vtkPolyData*)>& make)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->Initialize();
  this->Attempt(
    [&](const ProgressFunction&)
    {
      this->RequireFileName();
      const std::string name = this->GetFileName();
      try
      {
        make(name, output);
      }
      catch (const mote::Error& error)
      {
        throw mote::FileError(
          mote::FileError::Kind::Malformed, name, mote::withoutFile(error.what(), name));
      }
    });
  return 1;
}

bool vtkMotePolyDataReader::Attempt(const std::function<void(const ProgressFunction&)>& work)
{
  this->LastErrorMessage.clear();
  this->SetErrorCode(vtkErrorCode::NoError);
  try
  {
    work(
      [this](double fraction)
      {
        this->UpdateProgress(fraction);
        return !this->GetAbortExecute();
      });
    return true;
  }
  catch (const mote::FileError& error)
  {
    this->LastErrorMessage = error.what();
    this->SetErrorCode(errorCodeOf(error.kind()));
    if (error.kind() != mote::FileError::Kind::Aborted)
      vtkErrorMacro(<< this->LastErrorMessage);
  }
  catch (const mote::Error& error)
  {
    this->Fail(error.what());
  }
  catch (const std::bad_alloc&)
  {
    const char* name = this->GetFileName();
    this->Fail(std::string(name ? name : "") + ": there is not enough memory for it");
  }
  return false;
}

void vtkMotePolyDataReader::Fail(const std::string& message)
{
  this->LastErrorMessage = message;
  this->SetErrorCode(vtkErrorCode::UserError);
  vtkErrorMacro(<< this->LastErrorMessage);
}

void vtkMotePolyDataReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->GetFileName() ? this->GetFileName() : "(none)") << "\n";
  os << indent << "LastErrorMessage: " << this->LastErrorMessage << "\n";
}
