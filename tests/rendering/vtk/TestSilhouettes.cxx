// vtkMoteSilhouettes: what it holds, and what it draws into the images of vtkMoteRendererSource.
#include "VTKTestSupport.h"
#include "VolumeTestSupport.h"

#include "vtkContourValues.h"
#include "vtkImageData.h"
#include "vtkMoteShading.h"
#include "vtkMoteSilhouettes.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkSOADataArrayTemplate.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <sstream>

using namespace mote::testing;

namespace
{

/// The arrays of a traced image, by name.
struct Traced
{
  vtkSmartPointer<vtkImageData> image;
  std::vector<float> of(const char* name) const
  {
    std::vector<float> values;
    if (vtkDataArray* array = image->GetPointData()->GetArray(name))
      for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
        for (int c = 0; c < array->GetNumberOfComponents(); ++c)
          values.push_back(static_cast<float>(array->GetComponent(i, c)));
    return values;
  }
  double sum() const
  {
    const std::vector<float> all = this->of("silhouettes");
    return std::accumulate(all.begin(), all.end(), 0.0);
  }
};

struct Silhouettes : ::testing::Test
{
  static constexpr int width = 64, height = 48;
  const std::vector<Ball> balls = someBalls(30);
  vtkSmartPointer<vtkPolyData> data = makeParticles(balls);
  Stage stage{data};
  vtkNew<vtkMoteRendererSource> source;
  vtkMoteSilhouettes* silhouettes = source->GetSilhouettes();

  Silhouettes()
  {
    source->SetRenderer(stage.renderer);
    source->SetSize(width, height);
    source->SetSamplesPerPixel(4);
    source->TransparentBackgroundOn();
    source->SilhouetteCoverageOn();
    silhouettes->EnabledOn();
    silhouettes->SetStepInPixels(0.0);
  }
  Traced trace()
  {
    source->Update();
    Traced traced{vtkSmartPointer<vtkImageData>::New()};
    traced.image->DeepCopy(source->GetOutput());
    return traced;
  }
};

} // namespace

TEST_F(Silhouettes, Defaults)
{
  vtkNew<vtkMoteSilhouettes> fresh;
  EXPECT_FALSE(fresh->GetEnabled());
  EXPECT_EQ(fresh->GetThresholdMode(), vtkMoteSilhouettes::RADII);
  EXPECT_EQ(fresh->GetThreshold(), 10.0);
  EXPECT_TRUE(fresh->GetHulls());
  EXPECT_TRUE(fresh->GetCentered());
  EXPECT_STREQ(fresh->GetGroupArrayName(), "");
  fresh->SetThreshold(-1);
  EXPECT_EQ(fresh->GetThreshold(), 0.0);
  fresh->SetThickness(1000);
  EXPECT_EQ(fresh->GetThickness(), 64.0);
  fresh->SetLeastOpacity(2);
  EXPECT_EQ(fresh->GetLeastOpacity(), 1.0);
  fresh->SetThresholdModeToSceneSize();
  fresh->SetGroupArrayName("type");
  std::ostringstream text;
  fresh->Print(text);
  for (const char* part :
    {"Enabled: Off", "ThresholdMode: SceneSize", "Thickness: 64", "GroupArrayName: type"})
    EXPECT_NE(text.str().find(part), std::string::npos) << part;
  fresh->SetGroupArrayName(nullptr);
  EXPECT_STREQ(fresh->GetGroupArrayName(), "");
}

TEST_F(Silhouettes, LinesAreBlendedOverColourAndAlphaAndNothingElseChanges)
{
  source->DepthOn();
  source->NormalsOn();
  source->VarianceOn();
  source->IdsOn();
  silhouettes->SetColor(0.9, 0.1, 0.2);
  const Traced with = this->trace();
  EXPECT_GT(source->GetSilhouetteTime(), 0.0);
  EXPECT_LT(source->GetSilhouetteTime(), source->GetTraceTime());
  const double noise = source->GetNoise();
  silhouettes->EnabledOff();
  const Traced without = this->trace();
  EXPECT_EQ(source->GetSilhouetteTime(), 0.0);
  EXPECT_EQ(source->GetNoise(), noise);
  for (const char* name : {"depth", "normal", "variance", "particle", "object"})
    EXPECT_EQ(with.of(name), without.of(name)) << name;
  EXPECT_EQ(without.sum(), 0.0);
  const std::vector<float> coverage = with.of("silhouettes"), a = with.of("color"),
                           b = without.of("color");
  ASSERT_EQ(coverage.size(), std::size_t(width * height));
  const float line[4] = {0.9f, 0.1f, 0.2f, 1.0f};
  int outside = 0, partly = 0;
  for (std::size_t i = 0; i < coverage.size(); ++i)
  {
    ASSERT_GE(coverage[i], 0.0f);
    ASSERT_LE(coverage[i], 1.0f);
    for (std::size_t c = 0; c < 4; ++c)
      ASSERT_NEAR(a[4 * i + c], b[4 * i + c] * (1 - coverage[i]) + line[c] * coverage[i], 1e-5);
    outside += b[4 * i + 3] == 0.0f && coverage[i] > 0.0f ? 1 : 0;
    partly += coverage[i] > 0.0f && coverage[i] < 1.0f ? 1 : 0;
  }
  EXPECT_GT(outside, 50) << "hulls cover background";
  EXPECT_GT(partly, 300) << "lines are smooth";
  // No object is as good as one that is off.
  source->SetSilhouettes(nullptr);
  EXPECT_EQ(this->trace().of("color"), b);
}

TEST_F(Silhouettes, ThresholdsInAllUnitsAreOne)
{
  // Balls of one radius: it is the typical one. An actor's scale is the radius', too.
  std::vector<Ball> same = balls;
  for (Ball& ball : same)
    ball.r = 0.1;
  stage.mapper->SetInputData(makeParticles(same));
  stage.actor->SetScale(1.5);
  silhouettes->SetThreshold(4.0);
  const std::vector<float> radii = this->trace().of("silhouettes");
  silhouettes->SetThresholdModeToWorld();
  EXPECT_NE(this->trace().of("silhouettes"), radii);
  silhouettes->SetThreshold(4.0 * 0.15);
  const std::vector<float> world = this->trace().of("silhouettes");
  double difference = 0.0;
  for (std::size_t i = 0; i < world.size(); ++i)
    difference += std::abs(world[i] - radii[i]);
  EXPECT_LT(difference, 2.0) << "radii are stored in float";
  EXPECT_GT(std::accumulate(world.begin(), world.end(), 0.0), 200.0);
  double bounds[6];
  std::copy_n(stage.actor->GetBounds(), 6, bounds);
  const double diagonal =
    std::sqrt(std::pow(bounds[1] - bounds[0], 2) + std::pow(bounds[3] - bounds[2], 2) +
              std::pow(bounds[5] - bounds[4], 2));
  silhouettes->SetThresholdModeToSceneSize();
  silhouettes->SetThreshold(4.0 * 0.15 / diagonal);
  const std::vector<float> scene = this->trace().of("silhouettes");
  difference = 0.0;
  for (std::size_t i = 0; i < scene.size(); ++i)
    difference += std::abs(world[i] - scene[i]);
  EXPECT_LT(difference, 2.0);
}

TEST_F(Silhouettes, EveryOptionReachesThePicture)
{
  std::vector<std::vector<float>> seen = {this->trace().of("color")};
  const auto changes = [&](const char* what, const std::function<void()>& change)
  {
    change();
    seen.push_back(this->trace().of("color"));
    EXPECT_NE(seen[seen.size() - 2], seen.back()) << what;
  };
  changes("threshold", [&] { silhouettes->SetThreshold(0.5); });
  changes("world units", [&] { silhouettes->SetThresholdModeToWorld(); });
  changes("least opacity", [&] { silhouettes->SetLeastOpacity(0.2); });
  changes("full step", [&] { silhouettes->SetFullStep(3.0); });
  changes("thickness", [&] { silhouettes->SetThickness(3.0); });
  changes("least thickness", [&] { silhouettes->SetLeastThickness(0.3); });
  changes("not centered", [&] { silhouettes->CenteredOff(); });
  changes("no hulls", [&] { silhouettes->HullsOff(); });
  changes("colour", [&] { silhouettes->SetColor(0, 0, 1); });
  changes("step in pixels", [&] { silhouettes->SetStepInPixels(50.0); });
  changes("groups", [&] { silhouettes->SetGroupArrayName("particle"); });
}

TEST_F(Silhouettes, GroupsAreValuesObjectsOrParticles)
{
  // Balls in contact before a wall of one, no step between them: lines where groups meet.
  const std::vector<Ball> pair{{-0.4, 0, 0, 0.6}, {0.4, 0, 0, 0.6}};
  data = makeParticles(pair);
  addValues(data, "type", {1, 2}, false);
  addValues(data, "one", {1, 1}, false);
  vtkNew<vtkSOADataArrayTemplate<double>> apart; // values that are not one piece of memory
  apart->DeepCopy(data->GetPointData()->GetArray("type"));
  apart->SetName("apart");
  data->GetPointData()->AddArray(apart);
  stage.mapper->SetInputData(data);
  const auto between = [&](const char* name)
  {
    silhouettes->SetGroupArrayName(name);
    const std::vector<float> coverage = this->trace().of("silhouettes");
    const auto row = coverage.begin() + (height / 2) * width + width / 2;
    return *std::max_element(row - 2, row + 3);
  };
  EXPECT_EQ(between(""), 0.0f);
  EXPECT_EQ(between("one"), 0.0f);
  EXPECT_EQ(between("object"), 0.0f);
  const float line = between("type");
  EXPECT_GT(line, 0.3f);
  EXPECT_EQ(between("apart"), line);
  EXPECT_EQ(between("particle"), line);
  // Two actors: objects differ, values need not.
  vtkNew<vtkMoteParticleMapper> mapper;
  auto left = makeParticles({pair[0]});
  mapper->SetInputData(left);
  vtkNew<vtkActor> other;
  other->SetMapper(mapper);
  stage.renderer->AddActor(other);
  auto right = makeParticles({pair[1]});
  addValues(left, "one", {1}, false);
  addValues(right, "one", {1}, false);
  stage.mapper->SetInputData(right);
  EXPECT_GT(between("object"), 0.3f);
  EXPECT_EQ(between("one"), 0.0f);
  addValues(right, "type", {1}, false); // which the other has not
  EXPECT_GT(between("type"), 0.3f);
  Complaints complaints(silhouettes);
  EXPECT_EQ(between("missing"), 0.0f);
  EXPECT_EQ(complaints.errors, 1);
  EXPECT_NE(complaints.text.find("missing"), std::string::npos);
}

TEST_F(Silhouettes, PathsAndNoiseLevelsLeaveThemAsTheyAre)
{
  const std::vector<float> coverage = this->trace().of("silhouettes");
  source->GetShading()->SetModeToPathTraced();
  EXPECT_EQ(this->trace().of("silhouettes"), coverage);
  source->SetSamplesPerPixel(64);
  source->SetNoiseLevel(0.3);
  EXPECT_EQ(this->trace().of("silhouettes"), coverage);
  EXPECT_EQ(source->GetNumberOfSamples(), 4);
}

TEST(SilhouettesOfVolumes, CloudsHaveNoneSurfacesHave)
{
  VolumeStage stage(makeBox(4, [](const Point& p) { return p[0] * p[0] + p[1] * p[1]; }));
  vtkNew<vtkMoteRendererSource> source;
  source->SetRenderer(stage.renderer);
  source->SetSize(48, 48);
  source->SetSamplesPerPixel(2);
  source->SilhouetteCoverageOn();
  source->GetSilhouettes()->EnabledOn();
  const auto sum = [&]
  {
    source->Update();
    Traced traced{source->GetOutput()};
    return traced.sum();
  };
  EXPECT_EQ(sum(), 0.0);
  stage.mapper->ShowIsoSurfacesOn();
  stage.property()->GetIsoSurfaceValues()->SetValue(0, 0.5);
  EXPECT_GT(sum(), 50.0);
}
