// vtkMoteAreaLight: what it holds, and that pictures follow it.
#include "VTKTestSupport.h"

#include "SceneBridge.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkMoteAreaLight.h"

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace mote::testing;

TEST(AreaLight, Defaults)
{
  vtkNew<vtkMoteAreaLight> light;
  EXPECT_TRUE(light->GetShadows());
  EXPECT_EQ(light->GetSize(), 0.0);
  EXPECT_EQ(light->GetSamples(), 4);
  light->SetSamples(1000);
  EXPECT_EQ(light->GetSamples(), 64);
  light->SetSamples(0);
  EXPECT_EQ(light->GetSamples(), 1);
  light->SetSize(-3);
  EXPECT_EQ(light->GetSize(), 0.0);
}

TEST(AreaLight, CopiesKeepAllValues)
{
  vtkNew<vtkMoteAreaLight> light;
  light->SetPosition(1, 2, 3);
  light->SetIntensity(0.5);
  light->SetLightTypeToCameraLight();
  light->ShadowsOff();
  light->SetSize(7);
  light->SetSamples(3);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 3, 5.0);
  light->SetTransformMatrix(matrix);
  const auto check = [](vtkLight* copy)
  {
    auto* area = vtkMoteAreaLight::SafeDownCast(copy);
    ASSERT_NE(area, nullptr);
    EXPECT_EQ(area->GetPosition()[1], 2.0);
    EXPECT_EQ(area->GetIntensity(), 0.5);
    EXPECT_TRUE(area->LightTypeIsCameraLight());
    EXPECT_FALSE(area->GetShadows());
    EXPECT_EQ(area->GetSize(), 7.0);
    EXPECT_EQ(area->GetSamples(), 3);
    double position[3];
    area->GetTransformedPosition(position);
    EXPECT_EQ(position[0], 6.0);
  };
  const auto clone = vtkSmartPointer<vtkLight>::Take(light->ShallowClone());
  check(clone);
  EXPECT_EQ(clone->GetTransformMatrix(), light->GetTransformMatrix());
  vtkNew<vtkMoteAreaLight> deep;
  deep->DeepCopy(light);
  check(deep);
  vtkNew<vtkLight> plain;
  plain->SetIntensity(0.25);
  deep->DeepCopy(plain);
  EXPECT_EQ(deep->GetIntensity(), 0.25);
  EXPECT_EQ(deep->GetSize(), 7.0) << "which a plain light says nothing about";
}

TEST(AreaLight, PrintSelfTellsItsState)
{
  vtkNew<vtkMoteAreaLight> light;
  light->SetSize(2.5);
  std::ostringstream text;
  light->Print(text);
  for (const char* part : {"Shadows: On", "Size: 2.5", "Samples: 4"})
    EXPECT_NE(text.str().find(part), std::string::npos) << part;
}

TEST(AreaLight, ReachesTheKernels)
{
  Stage stage;
  vtkNew<vtkLight> plain;
  stage.renderer->AddLight(plain);
  vtkNew<vtkMoteAreaLight> area;
  area->SetPosition(0, 5, 0);
  area->SetFocalPoint(0, 0, 0);
  area->SetSize(200);
  area->SetSamples(8);
  stage.renderer->AddLight(area);
  const auto lights = [&] { return mote::lightsOf(stage.renderer); };
  ASSERT_EQ(lights().size(), 2u);
  EXPECT_FALSE(lights()[0].shadows);
  EXPECT_TRUE(lights()[1].shadows);
  EXPECT_EQ(lights()[1].kind, mote::Light::Kind::Directional);
  EXPECT_EQ(lights()[1].size, 90.0) << "degrees";
  EXPECT_EQ(lights()[1].samples, 8);
  area->PositionalOn();
  EXPECT_EQ(lights()[1].kind, mote::Light::Kind::Point);
  EXPECT_EQ(lights()[1].size, 200.0) << "world units";
  area->SetSize(0);
  EXPECT_EQ(lights()[1].samples, 1) << "a point needs one ray";
  area->ShadowsOff();
  EXPECT_FALSE(lights()[1].shadows);
}

TEST(AreaLight, SourceFollowsIt)
{
  Stage stage(makeParticles(someBalls(50)));
  vtkNew<vtkMoteAreaLight> light;
  stage.renderer->AddLight(light);
  vtkNew<vtkMoteRendererSource> source;
  source->SetRenderer(stage.renderer);
  source->SetSize(8, 8);
  source->Update();
  const auto traced = [&]
  {
    const vtkMTimeType before = source->GetOutput()->GetMTime();
    source->Update();
    return source->GetOutput()->GetMTime() != before;
  };
  EXPECT_FALSE(traced());
  light->SetSize(5);
  EXPECT_TRUE(traced());
  light->SetSamples(2);
  EXPECT_TRUE(traced());
  light->ShadowsOff();
  EXPECT_TRUE(traced());
  EXPECT_FALSE(traced());
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), 1);
}

namespace
{

/// A ball over a flat bed of particles, lit from above the ball; seen along the z axis, which is
/// up.
struct Shadowed : ::testing::Test
{
  std::vector<Ball> balls = bed();
  Stage stage{makeParticles(balls), true};
  vtkNew<vtkMoteAreaLight> light;

  static std::vector<Ball> bed()
  {
    std::vector<Ball> all = {{0, 0, 2, 0.4}};
    for (int i = -20; i <= 20; ++i)
      for (int k = -20; k <= 20; ++k)
        all.push_back({0.1 * i, 0.1 * k, 0, 0.08});
    return all;
  }
  Shadowed()
  {
    light->SetPosition(3, 0, 3); // so that the shadow falls about x = -2
    light->SetFocalPoint(0, 0, 0);
    stage.renderer->AddLight(light);
    stage.mapper->SetRadiusModeToArray();
    stage.mapper->SetRadiusArrayName("radius");
    vtkCamera* camera = stage.renderer->GetActiveCamera();
    camera->SetParallelScale(2.0);
  }
  /// Brightness of the bed's particles, by x, along y = 0.
  std::vector<double> brightness(int samples = 1)
  {
    const Picture picture = trace(stage.renderer, 164, 164, samples);
    std::vector<double> values;
    for (int i = -20; i < 20; ++i)
    {
      const int x = static_cast<int>(82 + 41 * 0.1 * i), y = 82;
      values.push_back(picture.color(picture.at(x, y))[0]);
    }
    return values;
  }
  static int between(const std::vector<double>& values, double low, double high)
  {
    return static_cast<int>(
      std::count_if(values.begin(), values.end(), [&](double v) { return v > low && v < high; }));
  }
};

} // namespace

TEST_F(Shadowed, HardShadowsAreDarkAndTheRestIsAsBefore)
{
  light->ShadowsOff();
  const auto lit = brightness();
  light->ShadowsOn();
  const auto hard = brightness();
  int dark = 0;
  for (std::size_t i = 0; i < lit.size(); ++i)
  {
    if (std::abs(hard[i] - lit[i]) < 1e-6)
      continue;
    ++dark;
    EXPECT_LT(hard[i], 0.1 * lit[i] + 1e-6) << i;
    EXPECT_NEAR(-2.0 + 0.1 * i, -2.0, 0.8) << "where the shadow falls";
  }
  EXPECT_GE(dark, 3);
}

TEST_F(Shadowed, SoftOnesHaveAPenumbraThatSizeWidens)
{
  stage.actor->SetPosition(0.8, 0, 0); // the whole shadow into the picture
  light->ShadowsOff();
  const double full = brightness()[20];
  light->ShadowsOn();
  light->SetSamples(8);
  const int hard = between(brightness(4), 0.1 * full, 0.7 * full);
  light->SetSize(10);
  const int soft = between(brightness(4), 0.1 * full, 0.7 * full);
  light->SetSize(25);
  const int softer = between(brightness(4), 0.1 * full, 0.7 * full);
  EXPECT_GT(soft, hard);
  EXPECT_GT(softer, soft);
}

TEST_F(Shadowed, HiddenParticlesThrowNone)
{
  light->ShadowsOff();
  stage.mapper->SetCenterRange(2, -1, 1);
  const auto alone = brightness();
  light->ShadowsOn();
  const auto shadowed = brightness();
  for (std::size_t i = 0; i < alone.size(); ++i)
    EXPECT_NEAR(alone[i], shadowed[i], 1e-6) << i;
}

TEST_F(Shadowed, PlainLightsThrowNone)
{
  light->ShadowsOff();
  const auto lit = brightness();
  stage.renderer->RemoveAllLights();
  vtkNew<vtkLight> plain;
  plain->SetPosition(3, 0, 3);
  plain->SetFocalPoint(0, 0, 0);
  stage.renderer->AddLight(plain);
  EXPECT_EQ(brightness(), lit);
}
