#include "Convert.h"

#include "AllSteps.h"
#include "base/Failure.h"
#include "base/Messages.h"
#include "base/OutputFile.h"
#include "base/Text.h"
#include "stage/Calculated.h"
#include "stage/HiddenParts.h"
#include "stage/Input.h"
#include "stage/Part.h"
#include "stage/Surface.h"
#include "table/Row.h"

#include <kernels/core/ScratchSpace.h>

#include <vtkActor.h>
#include <vtkMoteMeshFileWriter.h>
#include <vtkMoteParticleFileWriter.h>
#include <vtkMoteParticleMapper.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTimerLog.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace mote::app
{

namespace
{

/// What a .mote file may be made of.
struct Found
{
  std::vector<NamedData> particles, surfaces;
  int volumes = 0;
};

Found find(Input& input, const Settings& settings, ProgressRelay& progress)
{
  Found found;
  for (const NamedData& one : shownParts(
         readAsAsked(input, input.chosenStep(settings), settings, progress), settings.selection))
    switch (Part::kindOf(one.data, settings))
    {
    case Part::Kind::Particles:
      found.particles.push_back(one);
      break;
    case Part::Kind::Surface:
      found.surfaces.push_back(one);
      break;
    case Part::Kind::Volume:
      ++found.volumes;
    }
  return found;
}

/// The one set of particles, or without particles the one set of triangles.
NamedData convertible(Input& input, const Settings& settings, ProgressRelay& progress)
{
  Found found = find(input, settings, progress);
  const std::vector<NamedData>& all = found.particles.empty() ? found.surfaces : found.particles;
  if (all.size() == 1)
    return all.front();
  const auto many = [](std::size_t count, const char* what)
  { return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s"); };
  throw Failure(input.name() + " holds " + many(found.particles.size(), "set") + " of particles, " +
                many(found.surfaces.size(), "surface") + " and " +
                many(static_cast<std::size_t>(found.volumes), "volume") +
                "; a .mote file holds one set of particles, or without particles one surface");
}

double secondsSince(double start)
{
  return vtkTimerLog::GetUniversalTime() - start;
}

/// Has a writer write a file, with progress. Throws Failure and Interrupted.
void write(vtkMoteFileWriter* writer, const std::string& output, ProgressRelay& progress,
  const std::string& which)
{
  writer->SetFileName(output.c_str());
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
}

void convertParticles(
  Part& part, const std::string& output, ProgressRelay& progress, const std::string& which)
{
  vtkNew<vtkMoteParticleFileWriter> writer;
  writer->SetMapper(part.particles());
  writer->SetWriteOriginalIds(part.particles()->GetKeepPointIds());
  write(writer, output, progress, which);
}

void convertSurface(
  const Part& part, const std::string& output, ProgressRelay& progress, const std::string& which)
{
  part.surface()->nameCellsForFile();
  vtkNew<vtkMoteMeshFileWriter> writer;
  writer->SetMapper(part.surface()->mapper());
  write(writer, output, progress, which);
}

/// The file of a step, in which what stood there is replaced.
void convertStep(Input& input, const Settings& settings, const std::string& output,
  const std::shared_ptr<ScratchSpace>& space, ProgressRelay& progress, const std::string& which)
{
  const double start = vtkTimerLog::GetUniversalTime();
  const NamedData data = convertible(input, settings, progress);
  if (settings.output.allSteps && data.data->GetNumberOfPoints() == 0)
  {
    std::printf("%s: no particle, not written\n", output.c_str());
    return;
  }
  const double readTime = secondsSince(start);

  Part part(data.name, data.data, settings, 0.0);
  if (vtkMoteParticleMapper* particles = part.particles())
  {
    particles->SetStructureName("pkd-tree");
    particles->SetScratchSpace(space);
    const bool ofSource = Part::isOfSource(data.data); // whose order says nothing
    particles->SetKeepPointIds(!ofSource || data.data->GetPointData()->GetNumberOfArrays() > 0);
  }
  part.build(progress);
  const double built = vtkTimerLog::GetUniversalTime();
  if (part.particles())
    convertParticles(part, output, progress, which);
  else
    convertSurface(part, output, progress, which);
  const std::string count =
    part.particles() ? counted(part.particles()->GetNumberOfParticles(), "particle")
                     : counted(part.surface()->mapper()->GetNumberOfTriangles(), "triangle");
  std::printf("%s: %s, %s; read in %s, built in %s, written in %s\n", output.c_str(), count.c_str(),
    asBytes(static_cast<double>(std::filesystem::file_size(output))).c_str(),
    asDuration(readTime).c_str(), asDuration(part.buildTime()).c_str(),
    asDuration(secondsSince(built)).c_str());
}

} // namespace

std::optional<NamedData> onlyParticlesOf(
  Input& input, const Settings& settings, ProgressRelay& progress)
{
  const Found found = find(input, settings, progress);
  return found.particles.size() == 1 ? std::optional(found.particles.front()) : std::nullopt;
}

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
