#include "OutputFile.h"

#include "Failure.h"
#include "Messages.h"
#include "Text.h"

#include <kernels/core/AtomicFile.h>
#include <vtkMoteFileWriter.h>

#include <filesystem>
#include <system_error>

namespace mote::app
{

void checkOutput(const std::string& output, const std::vector<std::string>& inputs)
{
  if (output.empty())
    return;
  for (const std::string& input : inputs)
    // By device and number, behind symbolic links; not all that is read is a file.
    if (std::error_code error; std::filesystem::equivalent(output, input, error))
      throw Failure(output + " is read" + (output == input ? "" : " as " + input) +
                    ", and would be replaced; give the output another name");
  try
  {
    checkWritable(output);
  }
  catch (const WriteError& error)
  {
    throw Failure(error.what());
  }
}

void writeText(const std::string& file, const std::string& text)
{
  try
  {
    AtomicFile out(file);
    out.write(text.data(), text.size());
    out.commit();
  }
  catch (const WriteError& error)
  {
    throw Failure(error.what());
  }
}

void writeFile(vtkMoteFileWriter* writer, const std::string& file, ProgressRelay& progress,
  const std::string& which)
{
  writer->SetFileName(file.c_str());
  Messages::takeError();
  {
    ProgressRelay::Work work(
      progress, "Writing " + baseName(file) + (which.empty() ? "" : "," + which), writer);
    writer->Write();
    work.finish();
  }
  Messages::takeError(); // the writer says it too
  if (const std::string error = writer->GetErrorMessage(); !error.empty())
    throw Failure(error);
}

} // namespace mote::app
