#include "Bake.h"

#include "Convert.h"
#include "base/Checks.h"
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

#include <CLI/CLI.hpp>

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

void setQuality(vtkMoteAmbientOcclusionBaker* baker, const BakeOptions& options)
{
  if (options.side > 0)
    baker->SetSide(options.side);
  if (options.samples > 0)
    baker->SetSamples(options.samples);
  baker->SetReach(options.reach);
  if (options.tolerance == 0.0)
    baker->AdaptiveOff();
  else if (options.tolerance > 0.0)
    baker->SetTolerance(options.tolerance);
  baker->SetNumberOfThreads(options.given.settings.data.threads);
}

} // namespace

void addBakeOptions(CLI::App& app, BakeOptions& options)
{
  addFiles(app, options.given.settings);
  addSettings(app, options.given, {"Data"});
  app
    .add_option("--output,-o", options.output,
      "File to write, .moteao. By default the data file's name with .moteao behind it, and the "
      "step's number before where there are several: there mote looks for it")
    ->type_name("FILE");
  addSettings(app, options.given, {"Radius"});
  const std::string group = "Baking";
  app.add_option("--side", options.side, "Texels along a side of the largest maps. By default 16")
    ->check(CLI::IsMember({1, 2, 4, 8, 16, 32}).description(""))
    ->type_name("1|2|4|8|16|32")
    ->group(group);
  app.add_option("--samples", options.samples, "Rays a texel. By default 49")
    ->check(CLI::Range(1, 65536).description(""))
    ->type_name("N")
    ->group(group);
  app
    .add_option("--occlusion-reach", options.reach,
      "How far rays go, in the data's units: what is farther away darkens nothing. By default a "
      "tenth of the data's longest side")
    ->check(isNumber())
    ->check(CLI::PositiveNumber.description(""))
    ->type_name("R")
    ->group(group);
  app
    .add_option("--tolerance", options.tolerance,
      "Error that a particle's smaller map may have, as a share of the light; 0 gives all maps the "
      "same size. By default 0.01")
    ->check(isNumber())
    ->check(CLI::Range(0.0, 1.0).description(""))
    ->type_name("E")
    ->group(group);
}

void bake(const BakeOptions& options)
{
  TerminalProgress terminal;
  ProgressRelay progress;
  progress.add(terminal);
  Input input(options.given.settings.data.files);
  input.open(progress);
  const int step = input.chosenStep(options.given.settings);
  const NamedData data = particlesOf(input, step, progress, "mote bake takes one");
  const std::string output = options.output.empty() ? mapsFileOf(data) : options.output;
  if (lowerCase(std::filesystem::path(output).extension().string()) != ".moteao")
    throw Failure("the file to write must end in .moteao, not " + output);
  checkOutput(output, options.given.settings.data.files); // before minutes of baking
  auto* points = vtkPolyData::SafeDownCast(data.data);
  if (!points)
    throw Failure(data.name + " holds no points that mote bake could take");
  Part part(data.name, data.data, options.given.settings, 0.0);

  vtkNew<vtkMoteAmbientOcclusionBaker> baker;
  setRadii(baker, part.particles(), options.given.settings);
  setQuality(baker, options);
  baker->SetFileName(output.c_str());
  baker->SetInputData(points);
  Messages::takeError();
  {
    ProgressRelay::Work work(progress, "Baking", baker);
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
      std::fprintf(stderr, "mote: warning: %s\n", problem.c_str());
  }
}

} // namespace mote::app
