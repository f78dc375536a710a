#include "Convert.h"

#include "AllSteps.h"
#include "base/Failure.h"
#include "base/Messages.h"
#include "base/OutputFile.h"
#include "base/Text.h"
#include "stage/Calculated.h"
#include "stage/Input.h"
#include "stage/Part.h"
#include "table/Row.h"

#include <kernels/core/ScratchSpace.h>

#include <vtkActor.h>
#include <vtkMoteParticleFileWriter.h>
#include <vtkMoteParticleMapper.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTimerLog.h>

#include <cstdio>
#include <filesystem>
#include <memory>

namespace mote::app
{

NamedData particlesOf(
  Input& input, const Settings& settings, ProgressRelay& progress, const std::string& why)
{
  std::vector<NamedData> particles;
  for (const NamedData& one : readAsAsked(input, input.chosenStep(settings), settings, progress))
    if (!Part::isMesh(one.data))
      particles.push_back(one);
  if (particles.size() != 1)
    throw Failure(input.name() + " holds " + std::to_string(particles.size()) +
                  " sets of particles, and " + why);
  return particles.front();
}

namespace
{

double secondsSince(double start)
{
  return vtkTimerLog::GetUniversalTime() - start;
}

/// The file of a step, in which what stood there is replaced.
void convertStep(Input& input, const Settings& settings, const std::string& output,
  const std::shared_ptr<ScratchSpace>& space, ProgressRelay& progress, const std::string& which)
{
  const double start = vtkTimerLog::GetUniversalTime();
  const NamedData data = particlesOf(input, settings, progress, "a .mote file holds one");
  if (settings.output.allSteps && data.data->GetNumberOfPoints() == 0)
  {
    std::printf("%s: no particle, not written\n", output.c_str());
    return;
  }
  const double readTime = secondsSince(start);

  Part part(data.name, data.data, settings, 0.0);
  part.particles()->SetStructureName("pkd-tree");
  part.particles()->SetScratchSpace(space);
  const bool ofSource = Part::isOfSource(data.data); // whose order says nothing
  part.particles()->SetKeepPointIds(
    !ofSource || data.data->GetPointData()->GetNumberOfArrays() > 0);
  part.build(progress);
  vtkNew<vtkMoteParticleFileWriter> writer;
  writer->SetFileName(output.c_str());
  writer->SetMapper(part.particles());
  writer->SetWriteOriginalIds(part.particles()->GetKeepPointIds());
  const double written = vtkTimerLog::GetUniversalTime();
  Messages::takeError();
  {
    ProgressRelay::Work work(
      progress, "Writing " + baseName(output) + (which.empty() ? "" : "," + which), writer);
    writer->Write();
    work.finish();
  }
  Messages::takeError(); // the writer says it too
  if (const std::string error = writer->GetErrorMessage(); !error.empty())
    throw Failure(error);
  std::printf("%s: %s, %s; read in %s, built in %s, written in %s\n", output.c_str(),
    counted(part.particles()->GetNumberOfParticles(), "particle").c_str(),
    asBytes(static_cast<double>(std::filesystem::file_size(output))).c_str(),
    asDuration(readTime).c_str(), asDuration(part.particles()->GetBuildTime()).c_str(),
    asDuration(secondsSince(written)).c_str());
}

} // namespace

void convert(const Settings& given)
{
  Settings settings = given;
  const std::string output = settings.data.files.back();
  settings.data.files.pop_back();
  if (lowerCase(std::filesystem::path(output).extension().string()) != ".mote")
    throw Failure("the last file is the one to write, and must end in .mote, not " + output);
  if (settings.data.files.empty())
    throw Failure("no file to read is given, only " + output + " to write");

  TerminalProgress terminal;
  ProgressRelay progress;
  progress.add(terminal);
  checkOutput(output, settings.data.files); // before hours of reading
  const std::uint64_t memory =
    settings.output.memory.empty() ? physicalMemory() / 2 : bytesOf(settings.output.memory);
  // The rest is for putting arrays in order.
  const auto space = std::make_shared<ScratchSpace>(output, memory / 4 * 3);
  Input input(settings.data.files);
  input.setSpace(space);
  input.open(progress);
  forSteps(input, settings, progress,
    [&](const Settings& ofStep, const std::string& which)
    {
      const int step = input.chosenStep(ofStep) + 1, steps = input.numberOfSteps();
      const std::string file = settings.output.allSteps ? numbered(output, step, steps) : output;
      checkOutput(file, settings.data.files);
      convertStep(input, ofStep, file, space, progress, which);
    });
}

} // namespace mote::app
