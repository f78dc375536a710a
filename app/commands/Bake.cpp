#include "Bake.h"

#include "AllSteps.h"
#include "Convert.h"
#include "OpenedInput.h"
#include "base/Failure.h"
#include "base/Messages.h"
#include "base/OutputFile.h"
#include "base/Text.h"
#include "stage/Part.h"

#include <vtkActor.h>
#include <vtkMoteAmbientOcclusionBaker.h>
#include <vtkMoteParticleMapper.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTimerLog.h>

#include <cstdio>
#include <filesystem>
#include <map>

namespace mote::app
{

namespace
{

/// Where the maps of particles lie beside their file.
std::string mapsFileOf(const NamedData& particles)
{
  return particles.steps > 1 ? particles.file + "." + std::to_string(particles.step + 1) + ".moteao"
                             : particles.file + ".moteao";
}

/// Radii as they are drawn.
void setRadii(
  vtkMoteAmbientOcclusionBaker* baker, vtkMoteParticleMapper* from, const Settings& settings)
{
  baker->SetRadiusMode(from->GetRadiusMode());
  baker->SetRadius(from->GetRadius());
  baker->SetRadiusScale(from->GetRadiusScale());
  baker->SetRadiusArrayName(from->GetRadiusArrayName());
  baker->SetTypeArrayName(from->GetTypeArrayName());
  for (const auto& [type, radius] : settings.particles.typeRadius)
    baker->SetTypeRadius(type, radius);
}

void setQuality(vtkMoteAmbientOcclusionBaker* baker, const Settings& settings)
{
  baker->SetSide(settings.bake.side);
  baker->SetSamples(settings.bake.samples);
  baker->SetReach(settings.bake.reach.value_or(0.0));
  baker->SetAdaptive(settings.bake.tolerance > 0.0);
  if (settings.bake.tolerance > 0.0)
    baker->SetTolerance(settings.bake.tolerance);
  baker->SetNumberOfThreads(settings.data.threads);
}

std::string outputOf(const NamedData& data, const Settings& settings)
{
  const std::string& given = settings.output.file;
  if (given.empty())
    return mapsFileOf(data);
  return settings.output.allSteps ? numbered(given, data.step + 1, data.steps) : given;
}

void bakeStep(OpenedInput& opened, const Settings& settings, const std::string& which)
{
  const auto found = onlyParticlesOf(opened.input, settings, opened.progress);
  if (!found)
    throw Failure(opened.input.name() + " does not hold one set of particles, as mote bake takes");
  const NamedData& data = *found;
  const std::string output = outputOf(data, settings);
  if (lowerCase(std::filesystem::path(output).extension().string()) != ".moteao")
    throw Failure("the file to write must end in .moteao, not " + output);
  checkOutput(output, settings.data.files); // before minutes of baking
  auto* points = vtkPolyData::SafeDownCast(data.data);
  if (!points)
    throw Failure(data.name + " holds no points that mote bake could take");
  if (settings.output.allSteps && points->GetNumberOfPoints() == 0)
  {
    std::printf("%s: no particle, nothing to bake\n", output.c_str());
    return;
  }
  Part part(data.name, data.data, settings, 0.0);

  vtkNew<vtkMoteAmbientOcclusionBaker> baker;
  setRadii(baker, part.particles(), settings);
  setQuality(baker, settings);
  baker->SetFileName(output.c_str());
  baker->SetInputData(points);
  Messages::takeError();
  {
    ProgressRelay::Work work(opened.progress, "Baking" + which, baker);
    baker->Update();
    work.finish();
  }
  if (const std::string error = Messages::takeError(); !error.empty())
    throw Failure(error);
  std::string text = output + ": " + counted(baker->GetNumberOfBaked(), "particle") + ", " +
                     asNumber(baker->GetBytesPerParticle(), 3) + " bytes a particle, ";
  if (baker->GetNumberOfNewlyBaked() == 0)
    text += "as it was";
  else
    text += asNumber(static_cast<double>(baker->GetNumberOfRays()), 3) + " rays in " +
            asDuration(baker->GetBakeTime()) + ", " +
            asNumber(1e-6 * static_cast<double>(baker->GetNumberOfRays()) /
                       std::max(baker->GetBakeTime(), 1e-9),
              3) +
            " million a second";
  std::printf("%s\n", text.c_str());
  std::fflush(stdout); // who bakes all steps sees how far it is
}

} // namespace

void bake(const Settings& settings)
{
  OpenedInput opened(settings);
  forSteps(opened.input, settings, opened.progress,
    [&](const Settings& ofStep, const std::string& which) { bakeStep(opened, ofStep, which); });
}

void addOcclusionMaps(const std::vector<NamedData>& data)
{
  std::map<std::string, std::vector<NamedData>> files;
  for (const NamedData& one : data)
    if (!Part::isMesh(one.data))
      files[mapsFileOf(one)].push_back(one);
  for (const auto& [file, particles] : files)
  {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error))
      continue;
    const std::string problem =
      particles.size() > 1
        ? file + " holds the maps of one set of particles, of which the data file has several"
        : vtkMoteAmbientOcclusionBaker::ReadMaps(file, particles.front().data);
    if (!problem.empty())
      Messages::warn(problem);
  }
}

void readStep(Stage& stage, Input& input, int step, ProgressRelay& progress)
{
  const std::vector<NamedData> data = input.read(step, progress);
  if (stage.settings().light.ambientOcclusion == "baked")
    addOcclusionMaps(data);
  stage.setData(data);
}

} // namespace mote::app
