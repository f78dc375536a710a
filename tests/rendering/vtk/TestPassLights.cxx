// How vtkMoteRayCastPass draws soft shadows: with few rays while the view moves, and all at rest.
#include "WindowTestSupport.h"

#include "vtkCamera.h"
#include "vtkMoteAreaLight.h"
#include "vtkMoteShading.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace mote::testing;

namespace
{

struct Lights : ::testing::Test
{
  static constexpr int pixels = 160 * 120;
  Drawing drawing;
  vtkSmartPointer<vtkActor> actor = drawing.addParticles(someBalls(200), {1, 0.7, 0.4});
  vtkNew<vtkMoteAreaLight> light;
  vtkMoteRayCastPass* pass = drawing.pass;

  Lights()
  {
    drawing.renderer->RemoveAllLights();
    light->SetPosition(-3, 4, 5);
    light->SetSize(30);
    drawing.renderer->AddLight(light);
    drawing.renderer->ResetCameraClippingRange();
  }

  bool traced()
  {
    drawing.shoot();
    const bool did = pass->GetNumberOfRays() > 0;
    drawing.shoot();
    EXPECT_EQ(pass->GetNumberOfRays(), 0) << "and then no more";
    return did;
  }
  int builds() const
  {
    return vtkMoteParticleMapper::SafeDownCast(actor->GetMapper())->GetNumberOfBuilds();
  }
};

} // namespace

TEST_F(Lights, EveryChangeIsTracedAndNoneBuilds)
{
  const Shot soft = drawing.shoot();
  light->SetSize(60);
  EXPECT_TRUE(traced()) << "size";
  light->SetSamples(2);
  EXPECT_TRUE(traced()) << "samples";
  light->SetSize(0);
  EXPECT_TRUE(traced()) << "hard";
  const Shot hard = drawing.shoot();
  light->SetSamples(3);
  EXPECT_FALSE(traced()) << "a point has one sample";
  light->ShadowsOff();
  EXPECT_TRUE(traced()) << "none";
  const Shot none = drawing.shoot();
  EXPECT_GT(differentPixels(soft, hard), 500);
  EXPECT_GT(differentPixels(hard, none), 500);
  EXPECT_EQ(builds(), 1);
}

TEST_F(Lights, MovingViewsHaveHardShadowsAndRestSoftOnes)
{
  const Shot soft = drawing.shoot();
  light->SetSamples(1);
  pass->SetSamplesPerPixel(1);
  const Shot hard = drawing.shoot();
  light->SetSamples(4);
  pass->SetSamplesPerPixel(4);
  pass->AutoAdjustResolutionOff();
  drawing.window->SetDesiredUpdateRate(15);
  const Shot moving = drawing.shoot();
  EXPECT_EQ(pass->GetNumberOfRays(), pixels);
  EXPECT_FALSE(pass->IsConverged());
  EXPECT_EQ(differentPixels(moving, hard, 0), 0);
  drawing.shoot();
  EXPECT_EQ(pass->GetNumberOfRays(), 0) << "nothing has moved";
  drawing.window->SetDesiredUpdateRate(0.001);
  const Shot still = drawing.shoot();
  EXPECT_EQ(pass->GetNumberOfRays(), 4 * pixels) << "the draft is no part of the picture";
  EXPECT_TRUE(pass->IsConverged());
  EXPECT_EQ(differentPixels(still, soft, 0), 0);
}

TEST_F(Lights, ProgressiveOnesBeginWithADraftAndEndTheSame)
{
  const Shot soft = drawing.shoot();
  Drawing step;
  step.renderer->RemoveAllLights();
  step.renderer->AddLight(light);
  step.addParticles(someBalls(200), {1, 0.7, 0.4});
  step.renderer->ResetCameraClippingRange();
  step.pass->ProgressiveOn();
  step.pass->SetInteractiveFrameTime(0.001);
  step.window->Render();
  EXPECT_EQ(step.pass->GetNumberOfRays(), pixels);
  EXPECT_FALSE(step.pass->IsConverged());
  int frames = 1;
  for (; !step.pass->IsConverged() && frames < 20; ++frames)
    step.window->Render();
  EXPECT_GT(frames, 2);
  EXPECT_LT(frames, 20);
  EXPECT_EQ(differentPixels(soft, step.shoot(), 0), 0);
}

TEST_F(Lights, WorkWithoutThePass)
{
  Drawing plain(160, 120, false);
  plain.renderer->RemoveAllLights();
  plain.renderer->AddLight(light);
  plain.addParticles(someBalls(200), {1, 0.7, 0.4});
  plain.renderer->ResetCameraClippingRange();
  EXPECT_LT(differentPixels(drawing.shoot(), plain.shoot(), 2), 20);
  light->ShadowsOff();
  EXPECT_LT(differentPixels(drawing.shoot(), plain.shoot(), 2), 20);
}

TEST_F(Lights, OcclusionIsAnEvenOneWhileTheViewMovesAndAllThereAtRest)
{
  const auto brightness = [](const Shot& shot)
  { return std::accumulate(shot.color.begin(), shot.color.end(), 0.0) / shot.color.size(); };
  light->ShadowsOff();
  actor->GetProperty()->SetAmbient(0.6);
  vtkMoteShading* shading = pass->GetShading();
  const Shot plain = drawing.shoot();
  shading->SetAmbientOcclusionSamples(8);
  EXPECT_TRUE(traced()) << "rays";
  shading->SetAmbientOcclusionReach(0.5);
  EXPECT_TRUE(traced()) << "reach";
  const Shot still = drawing.shoot();
  EXPECT_GT(differentPixels(plain, still), pixels / 20);
  EXPECT_TRUE(pass->IsConverged());
  drawing.window->SetDesiredUpdateRate(15);
  drawing.camera()->Azimuth(10);
  drawing.shoot();
  EXPECT_FALSE(pass->IsConverged());
  drawing.camera()->Azimuth(-10);
  shading->SetAmbientOcclusionSamples(0);
  const Shot without = drawing.shoot();
  shading->SetAmbientOcclusionSamples(8);
  const Shot moving = drawing.shoot();
  EXPECT_LT(brightness(moving), brightness(without));
  EXPECT_LT(std::abs(brightness(moving) - brightness(still)),
    0.6 * std::abs(brightness(without) - brightness(still)));
  drawing.window->SetDesiredUpdateRate(0.001);
  EXPECT_EQ(differentPixels(still, drawing.shoot(), 0), 0);
  EXPECT_TRUE(pass->IsConverged());
}

TEST_F(Lights, PathsAreADraftWhileTheViewMovesAndRefinedAtRest)
{
  const Shot plain = drawing.shoot();
  vtkMoteShading* shading = pass->GetShading();
  shading->SetModeToPathTraced();
  pass->SetNoiseLevel(0.03);
  pass->SetSamplesPerPixel(500);
  EXPECT_TRUE(traced()) << "mode";
  EXPECT_TRUE(pass->IsConverged());
  EXPECT_LE(pass->GetNoise(), 0.03);
  shading->SetMaximumBounces(2);
  EXPECT_TRUE(traced()) << "bounces";
  shading->SetSkyBottom(0, 0, 0.5);
  EXPECT_TRUE(traced()) << "sky";
  const Shot still = drawing.shoot();
  EXPECT_GT(differentPixels(plain, still), pixels / 20);
  drawing.window->SetDesiredUpdateRate(15);
  drawing.camera()->Azimuth(10);
  drawing.shoot();
  EXPECT_EQ(pass->GetNumberOfSamples(), 1);
  EXPECT_FALSE(pass->IsConverged());
  drawing.camera()->Azimuth(-10);
  drawing.window->SetDesiredUpdateRate(0.001);
  pass->ProgressiveOn();
  int frames = 0;
  do
  {
    drawing.window->Render();
    ASSERT_LT(++frames, 500);
  } while (!pass->IsConverged());
  EXPECT_GT(frames, 1) << "the first one is a draft";
  EXPECT_EQ(differentPixels(still, drawing.shoot(), 0), 0);
}
