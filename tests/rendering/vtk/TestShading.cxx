// vtkMoteShading: what it holds, and that pictures follow it.
#include "VTKTestSupport.h"

#include "SceneBridge.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMoteShading.h"
#include "vtkProperty.h"

#include <cmath>
#include <sstream>

using namespace mote::testing;

TEST(Shading, Defaults)
{
  vtkNew<vtkMoteShading> shading;
  EXPECT_EQ(shading->GetMode(), vtkMoteShading::LOCAL);
  EXPECT_EQ(shading->GetMaximumBounces(), 16);
  EXPECT_EQ(shading->GetAmbientOcclusionSamples(), 0);
  EXPECT_EQ(shading->GetAmbientOcclusionReach(), 0.0);
  shading->SetAmbientOcclusionSamples(100000);
  EXPECT_EQ(shading->GetAmbientOcclusionSamples(), 4096);
  shading->SetAmbientOcclusionSamples(-1);
  EXPECT_EQ(shading->GetAmbientOcclusionSamples(), 0);
  shading->SetAmbientOcclusionReach(-1);
  EXPECT_EQ(shading->GetAmbientOcclusionReach(), 0.0);
}

TEST(Shading, PrintSelfTellsItsState)
{
  vtkNew<vtkMoteShading> shading;
  shading->SetAmbientOcclusionSamples(3);
  shading->SetAmbientOcclusionReach(2.5);
  std::ostringstream text;
  shading->Print(text);
  for (const char* part :
    {"Mode: Local", "SkyUp: 0 0 1", "AmbientOcclusionSamples: 3", "AmbientOcclusionReach: 2.5"})
    EXPECT_NE(text.str().find(part), std::string::npos) << part;
}

TEST(Shading, ReachesTheKernels)
{
  Stage stage(makeParticles({{0, 0, 0, 1}}));
  stage.mapper->Update();
  mote::MoteProps props = {mote::motePropOf(stage.actor)};
  EXPECT_EQ(mote::sceneOf(stage.renderer, props).occlusion.rays, 0);
  vtkNew<vtkMoteShading> shading;
  shading->SetAmbientOcclusionSamples(3);
  shading->SetAmbientOcclusionReach(2.5);
  const mote::Scene scene = mote::sceneOf(stage.renderer, props, shading);
  EXPECT_EQ(scene.occlusion.rays, 3);
  EXPECT_EQ(scene.occlusion.reach, 2.5);
  EXPECT_EQ(scene.paths.bounces, 0);

  shading->SetModeToPathTraced();
  shading->SetMaximumBounces(5);
  shading->SetSkyTop(0.5, 0.25, 1.0);
  shading->SetSkyBottom(0.0, 0.75, 2.0);
  shading->SetSkyUp(0.0, 3.0, 0.0);
  stage.actor->GetProperty()->SetMetallic(0.25);
  stage.actor->GetProperty()->SetRoughness(0.125);
  const mote::Scene paths = mote::sceneOf(stage.renderer, props, shading);
  EXPECT_EQ(paths.paths.bounces, 5);
  EXPECT_EQ(paths.occlusion.rays, 0);
  EXPECT_EQ(paths.sky.top, mote::Vec3f(0.5f, 0.25f, 1.0f));
  EXPECT_EQ(paths.sky.bottom, mote::Vec3f(0.0f, 0.75f, 2.0f));
  EXPECT_EQ(paths.sky.up, mote::Vec3d(0.0, 1.0, 0.0));
  EXPECT_EQ(paths.surfaces[0].material.metallic, 0.25f);
  EXPECT_EQ(paths.surfaces[0].material.roughness, 0.125f);
  shading->SetSkyUp(0.0, 0.0, 0.0);
  EXPECT_EQ(mote::sceneOf(stage.renderer, props, shading).sky.up, mote::Vec3d(0.0, 0.0, 1.0));
}

TEST(Shading, SourceFollowsIt)
{
  Stage stage(makeParticles(someBalls(50)));
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
  source->GetShading()->SetAmbientOcclusionSamples(2);
  EXPECT_TRUE(traced());
  source->GetShading()->SetAmbientOcclusionReach(0.5);
  EXPECT_TRUE(traced());
  source->GetShading()->SetModeToPathTraced();
  EXPECT_TRUE(traced());
  source->GetShading()->SetSkyTop(0.5, 0.5, 0.5);
  EXPECT_TRUE(traced());
  vtkNew<vtkMoteShading> other;
  source->SetShading(other);
  EXPECT_TRUE(traced());
  source->SetShading(nullptr);
  EXPECT_TRUE(traced());
  EXPECT_FALSE(traced());
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), 1);
}

TEST(Shading, OcclusionDarkensBesideALargeBall)
{
  // A ball of 1 lies on the face of one of 100 that the eye looks at. Where it casts its half
  // sphere: at a distance s from the touching point on the large ball's flat face the small one's
  // middle is sqrt(s^2 + 1) away, the cosine to it 1 / sqrt(s^2 + 1): open 1 - (s^2 + 1)^-3/2.
  Stage stage(makeParticles({{0, 0, -101, 100}, {0, 0, 0, 1}}), true);
  stage.mapper->SetRadiusModeToArray();
  stage.mapper->SetRadiusArrayName("radius");
  stage.actor->GetProperty()->SetAmbient(1.0);
  stage.actor->GetProperty()->SetDiffuse(0.0);
  stage.renderer->GetActiveCamera()->SetParallelScale(2.5);
  vtkNew<vtkMoteRendererSource> source;
  source->SetRenderer(stage.renderer);
  source->SetSize(51, 51);
  source->SetSamplesPerPixel(16);
  source->GetShading()->SetAmbientOcclusionSamples(64);
  source->GetShading()->SetAmbientOcclusionReach(10.0);
  source->Update();
  const auto red = [&](int x)
  { return source->GetOutput()->GetScalarComponentAsDouble(x, 25, 0, 0); };
  for (const int x : {0, 3, 6, 9, 12})
  {
    const double s = 5.0 * (25 - x) / 51.0;
    EXPECT_NEAR(red(x), 1.0 - std::pow(s * s + 1.0, -1.5), 0.02) << s;
  }
  EXPECT_EQ(red(25), 1.0) << "on top of the ball all is open";
}

TEST(Shading, PathsInAnEvenSkyShowTheColour)
{
  Stage stage(makeParticles({{0, 0, 0, 1}}));
  stage.actor->GetProperty()->SetColor(0.75, 0.5, 0.25);
  vtkNew<vtkLight> dark;
  dark->SetIntensity(0.0);
  stage.renderer->AddLight(dark);
  vtkNew<vtkMoteRendererSource> source;
  source->SetRenderer(stage.renderer);
  source->SetSize(32, 32);
  source->SetSamplesPerPixel(2);
  source->GetShading()->SetModeToPathTraced();
  source->Update();
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(
      source->GetOutput()->GetScalarComponentAsDouble(16, 16, 0, c), 0.75 - 0.25 * c, 1e-6);
  stage.actor->GetProperty()->LightingOff(); // and without light its own
  source->GetShading()->SetSkyTop(0, 0, 0);
  source->GetShading()->SetSkyBottom(0, 0, 0);
  source->Update();
  EXPECT_NEAR(source->GetOutput()->GetScalarComponentAsDouble(16, 16, 0, 0), 0.75, 1e-6);
}
