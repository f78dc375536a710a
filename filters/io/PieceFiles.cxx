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
#include <string>
#include <system_error>

namespace mote
{

namespace fs = std::filesystem;

PieceFiles::PieceFiles(const std::string& index)
  : parent_(fs::path(index).parent_path())
  , stem_(fs::path(index).stem())
{
  const fs::path folder = parent_ / stem_;
  std::error_code failed;
  for (const char* ending : {".pvtp", ".pvtu", ".pvti", ".pvts", ".pvtr", ".vtm", ".pvd"})
  {
    const fs::path other = parent_ / (stem_.string() + ending);
    if (other != fs::path(index) && fs::exists(other, failed))
      throw Error("its pieces would replace those of \"" + other.string() +
                  "\", which are in the folder of the same name.");
  }
  fs::create_directories(folder, failed);
  if (failed)
    throw Error("the folder \"" + folder.string() + "\" cannot be made: " + failed.message() + ".");
}

PieceFiles::~PieceFiles()
{
  std::error_code ignored; // some may not have been written
  for (std::size_t piece = inPlace_; piece < names_.size(); ++piece)
    fs::remove(this->written(piece), ignored);
}

std::string PieceFiles::written(std::size_t piece) const
{
  const fs::path name = parent_ / names_[piece];
  return fs::path(name).replace_extension(".new" + name.extension().string()).string();
}

void PieceFiles::commit()
{
  for (; inPlace_ < names_.size(); ++inPlace_)
    moveIntoPlace(this->written(inPlace_), (parent_ / names_[inPlace_]).string());
}

bool PieceFiles::write(vtkMoteFileWriter* writer, vtkDataSet* piece, const std::string& ending,
  double done, double share)
{
  names_.push_back(
    stem_.string() + '/' + stem_.string() + '_' + std::to_string(names_.size()) + ending);
  vtkNew<vtkMoteDataWriter> one;
  one->SetInputData(piece);
  one->SetFileName(this->written(names_.size() - 1).c_str());
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
  std::string problem = one->GetErrorMessage();
  const fs::path name = parent_ / names_.back(); // the one that it was to have
  const std::string present = this->written(names_.size() - 1);
  if (const auto at = problem.find(present); at != std::string::npos)
    problem.replace(at, present.size(), name.string());
  throw WriteError(one->GetErrorCode() == vtkErrorCode::OutOfDiskSpaceError
                     ? WriteError::Kind::NoSpace
                     : WriteError::Kind::CannotOpen,
    problem);
}

} // namespace mote
