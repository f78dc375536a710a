#include "PieceFiles.h"

#include "MessageCatcher.h"
#include "vtkMoteDataWriter.h"

#include "kernels/core/AtomicFile.h"
#include "kernels/core/Error.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkNew.h"

#include <filesystem>
#include <system_error>

namespace mote
{

namespace fs = std::filesystem;

PieceFiles::PieceFiles(const std::string& index)
  : parent_(fs::path(index).parent_path().string())
  , stem_(fs::path(index).stem().string())
{
  const fs::path folder = fs::path(parent_) / stem_;
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed)
    throw Error("the folder \"" + folder.string() + "\" cannot be made: " + failed.message() + ".");
}

bool PieceFiles::write(vtkMoteFileWriter* writer, vtkDataSet* piece, const std::string& ending,
  double done, double share)
{
  names_.push_back(stem_ + '/' + stem_ + '_' + std::to_string(names_.size()) + ending);
  vtkNew<vtkMoteDataWriter> one;
  one->SetInputData(piece);
  one->SetFileName((fs::path(parent_) / names_.back()).c_str());
  vtkNew<vtkCallbackCommand> relay;
  auto report = [&]
  {
    writer->UpdateProgress(done + share * one->GetProgress());
    one->SetAbortExecute(writer->GetAbortExecute());
  };
  relay->SetClientData(&report);
  relay->SetCallback([](vtkObject*, unsigned long, void* data, void*)
    { (*static_cast<decltype(report)*>(data))(); });
  one->AddObserver(vtkCommand::ProgressEvent, relay);
  const MessageCatcher messages(one); // they come again as the writer's
  if (one->Write())
    return true;
  if (writer->GetAbortExecute())
    return false;
  throw WriteError(one->GetErrorCode() == vtkErrorCode::OutOfDiskSpaceError
                     ? WriteError::Kind::NoSpace
                     : WriteError::Kind::CannotOpen,
    one->GetErrorMessage());
}

} // namespace mote
