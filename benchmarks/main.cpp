// mote-bench: speed against error, beside peers, in one run.

#include "Suite.h"

#include <kernels/core/Error.h>
#include <kernels/particles/ParticleStructure.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>

using namespace mote::bench;

namespace
{

std::vector<std::string> names(const std::vector<Named>& entries)
{
  std::vector<std::string> out;
  for (const Named& entry : entries)
    out.push_back(entry.first);
  return out;
}

/// Sizes of images as they were typed.
struct Sizes
{
  std::string image, frame;
};

/// What concerns the rays that are cast.
void addRayOptions(CLI::App& command, const Suite& suite, Options& options, Sizes& sizes)
{
  if (!suite.views.empty())
  {
    command.add_option("--view", options.views, "Comma-separated; all unless given")
      ->delimiter(',')
      ->check(CLI::IsMember(names(suite.views)));
    if (suite.squares)
      command.add_option("--sizes", options.sizes, "Sides of square images, comma-separated")
        ->delimiter(',')
        ->check(CLI::Range(1, 8192))
        ->capture_default_str();
    else
      command.add_option("--size", sizes.image, "Pixels of an image, WIDTHxHEIGHT")
        ->default_str(suite.size);
  }
  if (suite.bundles)
    command
      .add_option("--packet", options.packet,
        "Side of the bundles of rays that are cast through Mote's grid; 0: what suits each tile")
      ->check(CLI::IsMember({0, 2, 4, 8, 16}))
      ->capture_default_str();
  if (suite.lods)
    command
      .add_option("--poe", options.poe,
        "Pixels of error that methods with levels of detail may make, comma-separated; 0: none")
      ->delimiter(',')
      ->check(CLI::Range(0.0, 1000.0))
      ->capture_default_str();
  if (suite.raysOfHits)
    command.add_option("--rays", options.rays, "Rays from what every pixel shows")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
}

/// What concerns volumes.
void addVolumeOptions(CLI::App& command, Options& options)
{
  command
    .add_option("--step", options.step,
      "Between samples, in units of the input; 0: half the edge of its mean cell")
    ->check(CLI::NonNegativeNumber)
    ->capture_default_str();
  command
    .add_option("--cloud-tolerance", options.cloudTolerance,
      "Error of a colour, from 0 to 1, up to which pixels are interpolated; 0: all are traced")
    ->check(CLI::Range(0.0, 1.0))
    ->capture_default_str();
  command
    .add_flag("--single-rays", options.singleRays,
      "Cast rays through structures one at a time, so that no structure has bundles")
    ->excludes("--cloud-tolerance");
  command
    .add_option("--tolerance", options.tolerance,
      "Error of a colour, from 0 to 1, that walks and the integrator cell-by-cell may make")
    ->check(CLI::Range(1e-9, 1.0));
  command.add_option("--integrator", options.integrator, "How Mote's structures sample rays")
    ->check(CLI::IsMember({"inverse-distance", "trilinear", "cell-by-cell"}))
    ->capture_default_str();
  command
    .add_option("--lambda2", options.lambda2,
      "Leaves per reference of a macro cell of a grid, from 0.1 to 64")
    ->check(CLI::Range(0.1, 64.0))
    ->capture_default_str();
}

/// What concerns ambient occlusion, live and baked.
void addMapOptions(CLI::App& command, Options& options, Sizes& sizes)
{
  command
    .add_option("--frame-size", sizes.frame, "Pixels of the frames that look-ups are timed in")
    ->default_str("1024x1024");
  command.add_option("--structure", options.structure, "Over the particles, for rays and maps")
    ->check(CLI::IsMember(mote::particleStructureNames()));
  command.add_option("--reference-rays", options.referenceRays, "A hit of the reference pictures")
    ->check(CLI::Range(4, 16384))
    ->capture_default_str();
  command.add_option("--samples", options.samples, "Rays a texel")
    ->check(CLI::Range(1, 4096))
    ->capture_default_str();
  command
    .add_option("--reach", options.reach,
      "How far rays go, in units of the input; 0: a tenth of its longest side")
    ->check(CLI::NonNegativeNumber)
    ->capture_default_str();
  command
    .add_option("--bake", options.baked,
      "Which particles: all, those seen in the pictures, or all of a small input")
    ->check(CLI::IsMember({"auto", "all", "seen"}))
    ->capture_default_str();
}

void addOptions(CLI::App& command, const Suite& suite, Options& options, Sizes& sizes)
{
  command.add_option("--input", options.input, "What is measured on; see the list of inputs below")
    ->type_name("SPEC");
  if (!suite.methods.empty())
    command.add_option("--methods", options.methods, "Comma-separated; all unless given")
      ->delimiter(',')
      ->check(CLI::IsMember(names(suite.methods)));
  addRayOptions(command, suite, options, sizes);
  command.add_option("--threads", options.threads, "0: as many as the machine has")
    ->check(CLI::Range(0, 4096))
    ->capture_default_str();
  command.add_option("--repeat", options.repeat, "Rounds over all methods; medians are given")
    ->check(CLI::Range(1, 1000))
    ->capture_default_str();
  if (suite.maps)
    addMapOptions(command, options, sizes);
  if (suite.volumes)
    addVolumeOptions(command, options);
  else if (!suite.methods.empty() && suite.cells)
    command.add_option("--lambda", options.lambda, "Cells of a grid a particle, from 0.2 to 5")
      ->check(CLI::Range(0.2, 5.0))
      ->capture_default_str();
  if (!suite.tables.empty())
    command
      .add_option("--tables", options.tables,
        "Print tables instead, all or those named, comma-separated; see the list below")
      ->expected(0, -1)
      ->delimiter(',')
      ->check(CLI::IsMember(names(suite.tables)));
  command.add_option("--json", options.json, "File for the records, a JSON array");
  command.footer("\n" + describe(suite));
}

void parseSize(const char* option, const std::string& text, int& width, int& height)
{
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) != 2 ||
      std::min(width, height) < 1 || std::max(width, height) > 32768)
    throw mote::Error(std::string(option) +
                      " wants WIDTHxHEIGHT in pixels, each from 1 to 32768, not \"" + text + "\".");
}

void runSuite(const Suite& suite, const Options& options)
{
  // Opened first: nobody wants to learn after ten minutes that the file cannot be written.
  std::ofstream json;
  if (!options.json.empty())
  {
    json.open(options.json);
    if (!json)
      throw mote::Error("The file \"" + options.json + "\" cannot be written.");
  }
  const Report report = suite.run(options);
  for (std::size_t i = 0; i < report.sections.size(); ++i)
    std::printf("%s%s", i > 0 ? "\n" : "", toText(report.sections[i]).c_str());
  if (!options.json.empty())
  {
    json << toJson(report.records);
    json.close();
    if (!json)
      throw mote::Error("The records could not be written to \"" + options.json + "\".");
  }
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("Measures Mote's structures beside their peers: speed, memory, and error against a "
               "reference in double and long double.");
  app.require_subcommand(1);
  Options options;
  Sizes sizes;
  std::string footer = "\n";
  for (const Suite& suite : suites())
  {
    CLI::App* command = app.add_subcommand(suite.name, suite.summary);
    addOptions(*command, suite, options, sizes);
    command->callback(
      [&suite, &options, &sizes, command]
      {
        parseSize(
          "--size", sizes.image.empty() ? suite.size : sizes.image, options.width, options.height);
        if (!sizes.frame.empty())
          parseSize("--frame-size", sizes.frame, options.frameWidth, options.frameHeight);
        std::erase(options.tables, ""); // what --tables without a name leaves
        if (!suite.tables.empty())
          options.allTables = command->count("--tables") > 0 && options.tables.empty();
        if (options.input.empty() && options.wantsTables())
          options.input = suite.tablesInput;
        if (options.input.empty())
          throw CLI::RequiredError("--input");
        runSuite(suite, options);
      });
    footer += describe(suite);
  }
  app.footer(footer + "mote-bench SUITE --help lists the options of a suite.");
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    return app.exit(error);
  }
  catch (const std::bad_alloc&)
  {
    std::fprintf(stderr, "mote-bench: The machine has not enough memory for this input.\n");
    return 1;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "mote-bench: %s\n", error.what());
    return 1;
  }
  return 0;
}
