#include "vtkMoteFileWriter.h"

#include "kernels/core/AtomicFile.h"

#include "vtkCommand.h"
#include "vtkErrorCode.h"

#include <new>

vtkMoteFileWriter::vtkMoteFileWriter() = default;

vtkMoteFileWriter::~vtkMoteFileWriter()
{
  this->SetFileName(nullptr);
}

int vtkMoteFileWriter::Write()
{
  this->ErrorMessage.clear();
  this->SetErrorCode(vtkErrorCode::NoError);
  this->SetAbortExecute(0);
  unsigned long code = vtkErrorCode::UserError;
  const std::string name = this->FileName ? this->FileName : "";
  try
  {
    mote::checkWritable(name); // before hours of building
    this->InvokeEvent(vtkCommand::StartEvent, nullptr);
    const bool complete = this->WriteFile();
    this->InvokeEvent(vtkCommand::EndEvent, nullptr);
    if (complete)
      return 1;
    this->ErrorMessage = "Cannot write \"" + name + "\": it was stopped.";
    this->SetErrorCode(code); // not reported: the user's own wish
    return 0;
  }
  catch (const mote::WriteError& error)
  {
    const bool full = error.kind() == mote::WriteError::Kind::NoSpace;
    code = full ? vtkErrorCode::OutOfDiskSpaceError : vtkErrorCode::CannotOpenFileError;
    this->ErrorMessage = error.what();
  }
  catch (const std::bad_alloc&)
  {
    this->ErrorMessage = "Cannot write \"" + name + "\": there is not enough memory for it.";
  }
  catch (const std::exception& error)
  {
    this->ErrorMessage = "Cannot write \"" + name + "\": " + error.what();
  }
  this->SetErrorCode(code);
  vtkErrorMacro(<< this->ErrorMessage);
  return 0;
}

std::function<bool(double)> vtkMoteFileWriter::ProgressOfWrite()
{
  return [this](double done)
  {
    this->UpdateProgress(done);
    return this->GetAbortExecute() == 0;
  };
}

void vtkMoteFileWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
