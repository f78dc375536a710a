// What commands alone take: every row is set, read and parsed, and defaults are not said twice.

#include <table/CommandLine.h>
#include <table/Row.h>
#include <table/Session.h>

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>
#include <vtkMoteAmbientOcclusionBaker.h>
#include <vtkMoteColorLegend.h>
#include <vtkMoteMeridionalAverage.h>
#include <vtkMoteMeshMapper.h>
#include <vtkMoteParticleMapper.h>
#include <vtkMoteShading.h>
#include <vtkMoteSilhouetteFilter.h>
#include <vtkMoteSilhouettes.h>
#include <vtkMoteVolumeMapper.h>
#include <vtkNew.h>

#include <algorithm>
#include <map>
#include <set>

using namespace mote::app;

TEST(CommandTable, RowsAreSetReadAndParsed)
{
  const std::map<std::string, std::vector<std::string>> samples = {
    {"side", {"8"}},
    {"memory", {"4G"}},
    {"axis", {"1", "0", "0.5"}},
    {"origin", {"1", "2", "3"}},
    {"radial-range", {"0.5", "2"}},
    {"axial-range", {"-1", "2"}},
    {"from", {"1", "2", "3"}},
    {"to", {"3", "2", "1"}},
    {"at", {"3", "2", "1"}},
    {"threshold", {"3%"}},
    {"tolerance", {"0.25"}},
    {"view-angle", {"45"}},
    {"ui-scale", {"2"}},
    {"steps", {"2:9:3"}},
    {"quality", {"low"}},
    {"picture-size", {"320x200"}},
    {"cache", {"4G"}},
    {"plot-of", {"picked"}},
  };
  std::set<std::string> names;
  for (const Row& row : commandTable())
  {
    EXPECT_TRUE(names.insert(row.command + " " + row.name).second) << row.name << " stands twice";
    EXPECT_GT(row.help.size(), 10u) << row.name;
    Settings settings;
    const auto found = samples.find(row.name);
    const std::vector<std::string> words =
      found != samples.end() ? found->second
      : row.shape == Shape::Flag
        ? std::vector<std::string>{row.get(settings).front() == "true" ? "false" : "true"}
      : !row.words.empty() ? std::vector<std::string>{row.words.back()}
      : row.numeric        ? std::vector<std::string>{"7"}
                           : std::vector<std::string>{"text"};
    row.set(settings, words);
    EXPECT_FALSE(row.isDefault(settings)) << row.name;
    EXPECT_EQ(row.get(settings), words) << row.name;
    if (row.numeric)
    {
      EXPECT_THROW(row.set(settings, {"x"}), WrongValue) << row.name;
    }
    // By itself, as the others that a command requires or excludes are tested by the program.
    CLI::App app;
    GivenSettings given;
    if (row.excludes.empty() && row.needs.empty())
    {
      addSettings(app, given, {"Data"}); // which some exclude
      addCommandSettings(app, given, row.command);
      for (CLI::Option* option : app.get_options())
        option->required(false);
      std::vector<std::string> line = {"--" + row.name};
      if (row.shape == Shape::Flag)
        line.front() = row.option();
      else
      {
        std::string joinedWords;
        for (const std::string& word : words)
          joinedWords += (joinedWords.empty() ? "" : ",") + word;
        line.insert(line.begin(), joinedWords);
      }
      ASSERT_NO_THROW(app.parse(line)) << row.name;
      EXPECT_EQ(row.get(given.settings), words) << row.name;
    }
    if (row.name == "picture-size") // which sessions keep
    {
      settings.data.files = {"pump:0.1"};
      const std::string text = sessionText(settings, "s.json");
      EXPECT_EQ(parseSession(text, "s.json").output.size, settings.output.size);
    }
    else if (row.name != "threshold") // of the silhouettes, that pictures have, too
    {
      EXPECT_EQ(sessionText(settings, "s.json"), sessionText(Settings{}, "s.json"))
        << "sessions take notice of " << row.name;
    }
  }
  EXPECT_GT(names.size(), 20u);
}

TEST(CommandTable, DefaultsAreThoseOfTheClassesThatTheySet)
{
  const Settings settings;
  vtkNew<vtkMoteAmbientOcclusionBaker> baker;
  EXPECT_EQ(settings.bake.side, baker->GetSide());
  EXPECT_EQ(settings.bake.samples, baker->GetSamples());
  EXPECT_EQ(settings.bake.tolerance, baker->GetTolerance());
  vtkNew<vtkMoteMeridionalAverage> average;
  EXPECT_EQ(settings.average.resolution, average->GetResolution());
  vtkNew<vtkMoteVolumeMapper> volume;
  EXPECT_EQ(settings.volume.tolerance, volume->GetTolerance());
  vtkNew<vtkMoteShading> shading;
  EXPECT_EQ(settings.volume.cloudTolerance, shading->GetCloudTolerance());
  vtkNew<vtkMoteSilhouettes> lines;
  EXPECT_EQ(settings.silhouettes.stepInPixels, lines->GetStepInPixels());
  EXPECT_EQ(settings.silhouettes.opacity, lines->GetLeastOpacity());
  EXPECT_EQ(settings.silhouettes.noHulls, !lines->GetHulls());
  EXPECT_EQ(settings.silhouettes.onPixels, !lines->GetCentered());
  EXPECT_EQ(std::stod(settings.silhouettes.thickness), lines->GetThickness());
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(settings.silhouettes.color[k], lines->GetColor()[k], 0.5 / 255) << k;
  vtkNew<vtkMoteParticleMapper> particles;
  EXPECT_EQ(settings.particles.radiusScale, particles->GetRadiusScale());
  EXPECT_EQ(settings.particles.structure, particles->GetStructureName());
  EXPECT_EQ(settings.particles.form, particles->GetStructureForm());
  vtkNew<vtkMoteSilhouetteFilter> image;
  EXPECT_EQ(settings.depthImage.viewAngle, image->GetViewAngle());
  EXPECT_EQ(settings.depthImage.reduction, image->GetReductionFactor());
  vtkNew<vtkMoteColorLegend> legend;
  EXPECT_EQ(settings.picture.fontScale, legend->GetFontScale());
  vtkNew<vtkMoteMeshMapper> mesh;
  EXPECT_EQ(settings.picture.lodError, mesh->GetPixelsOfError());
}

TEST(CommandTable, SizesOfMemoryAreSaidOrRefused)
{
  EXPECT_EQ(bytesOf("4K"), 4096u);
  for (const char* wrong : {"", "4z", "hello", "-1", "99999999999999999999G", "4 G z"})
    EXPECT_EQ(bytesOf(wrong), 0u) << wrong;
}
