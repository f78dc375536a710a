// vtkMoteShading: what it holds, and that pictures follow it.
#include "VTKTestSupport.h"

#include "SceneBridge.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMoteShading.h"
#include "vtkProperty.h"

#include <cmath>
#include <sstream>

using namespace mote::testing;

TEST(Shading, Defaults)
{
  vtkNew<vtkMoteShading> shading;
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
  for (const char* part : {"AmbientOcclusionSamples: 3", "AmbientOcclusionReach: 2.5"})
    EXPECT_NE(text.str().find(part), std::string::npos) << part;
}

TEST(Shading, ReachesTheKernels)
{
  Stage stage(makeParticles({{0, 0, 0, 1}}));
  stage.mapper->Update();
  std::vector<vtkActor*> actors = {stage.actor};
  EXPECT_EQ(mote::sceneOf(stage.renderer, actors).occlusion.rays, 0);
  vtkNew<vtkMoteShading> shading;
  shading->SetAmbientOcclusionSamples(3);
  shading->SetAmbientOcclusionReach(2.5);
  const mote::Scene scene = mote::sceneOf(stage.renderer, actors, shading);
  EXPECT_EQ(scene.occlusion.rays, 3);
  EXPECT_EQ(scene.occlusion.reach, 2.5);
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
