// vtkMoteAreaLight: what it holds, and that pictures follow it.
#include "VTKTestSupport.h"

#include "SceneBridge.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkMoteAreaLight.h"

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
