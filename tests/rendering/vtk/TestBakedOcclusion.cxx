// vtkMoteShading::OCCLUSION_BAKED without maps in the data: what pictures bake, and what they keep.
#include "VTKTestSupport.h"

#include "FrameTracer.h"
#include "OcclusionArrays.h"
#include "ParticleModel.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMoteShading.h"
#include "vtkProperty.h"

#include <cmath>
#include <set>

using namespace mote::testing;

namespace
{

/// Balls in ambient light alone, seen by a source that bakes.
struct Baked : Stage
{
  vtkNew<vtkMoteRendererSource> source;

  explicit Baked(int count = 400)
    : Stage(makeParticles(someBalls(count)))
  {
    mapper->ScalarVisibilityOff();
    actor->GetProperty()->SetAmbient(1.0);
    actor->GetProperty()->SetDiffuse(0.0);
    source->SetRenderer(renderer);
    source->SetSize(64, 64);
    source->SetSamplesPerPixel(4);
    source->IdsOn();
    source->TransparentBackgroundOn();
    source->DepthOn();
    vtkMoteShading* shading = source->GetShading();
    shading->SetAmbientOcclusionReach(0.5);
    shading->SetAmbientOcclusionToBaked();
    shading->SetBakeSide(8);
    shading->SetBakeSamples(16);
  }

  Picture shown()
  {
    source->Update();
    vtkNew<vtkImageData> copy;
    copy->DeepCopy(source->GetOutput());
    return {64, 64, copy};
  }
};

double rmsOf(const Picture& a, const Picture& b)
{
  double sum = 0.0;
  for (int i = 0; i < a.count(); ++i)
    sum += std::pow(a.color(i)[0] - b.color(i)[0], 2.0);
  return std::sqrt(sum / a.covered());
}

} // namespace

TEST(BakedOcclusion, OneOptionSelects)
{
  vtkNew<vtkMoteShading> shading;
  EXPECT_EQ(shading->GetAmbientOcclusion(), vtkMoteShading::OCCLUSION_NONE);
  shading->SetAmbientOcclusionSamples(2);
  EXPECT_EQ(shading->GetAmbientOcclusion(), vtkMoteShading::OCCLUSION_LIVE);
  shading->SetAmbientOcclusionSamples(0);
  EXPECT_EQ(shading->GetAmbientOcclusion(), vtkMoteShading::OCCLUSION_NONE);
  shading->SetAmbientOcclusionToLive();
  EXPECT_EQ(shading->GetAmbientOcclusionSamples(), 4);
  shading->SetAmbientOcclusionToBaked();
  shading->SetAmbientOcclusionSamples(0);
  EXPECT_EQ(shading->GetAmbientOcclusion(), vtkMoteShading::OCCLUSION_BAKED);
  const vtkMTimeType before = shading->GetMTime();
  shading->SetAmbientOcclusionToBaked();
  shading->SetBakeSide(shading->GetBakeSide());
  EXPECT_EQ(shading->GetMTime(), before);
  Complaints complaints(shading);
  shading->SetBakeSide(3);
  EXPECT_EQ(complaints.errors, 1);
  EXPECT_EQ(shading->GetBakeSide(), 16);
}

TEST(BakedOcclusion, LooksLikeLive)
{
  Baked baked, live;
  live.source->GetShading()->SetAmbientOcclusionToLive();
  live.source->GetShading()->SetAmbientOcclusionSamples(64);
  baked.source->GetShading()->SetBakeSide(16);
  baked.source->GetShading()->SetBakeSamples(49);
  const Picture wanted = live.shown();
  EXPECT_LT(rmsOf(baked.shown(), wanted), 0.03);
  live.source->GetShading()->SetAmbientOcclusionToNone();
  EXPECT_GT(rmsOf(live.shown(), wanted), 0.1);
}

TEST(BakedOcclusion, BakesWhatIsSeenOnceAndNoMore)
{
  Baked baked;
  const Picture picture = baked.shown();
  std::set<long long> seen;
  for (const long long id : picture.particles())
    if (id >= 0)
      seen.insert(id);
  const vtkIdType count = baked.mapper->GetNumberOfBakedParticles();
  EXPECT_GE(count, static_cast<vtkIdType>(seen.size()));
  EXPECT_LT(count, 400);
  EXPECT_GT(baked.mapper->GetOcclusionBytes(), 0);
  baked.source->Modified();
  baked.source->Update();
  EXPECT_EQ(baked.mapper->GetNumberOfBakedParticles(), count);
  // The other side adds its own, and forgets nothing.
  baked.renderer->GetActiveCamera()->Azimuth(180.0);
  baked.source->Update();
  EXPECT_GT(baked.mapper->GetNumberOfBakedParticles(), count);
  EXPECT_EQ(baked.mapper->GetNumberOfBuilds(), 1);
}

TEST(BakedOcclusion, NothingMixesAfterAChange)
{
  Baked baked;
  baked.source->Update();
  const vtkIdType count = baked.mapper->GetNumberOfBakedParticles();
  ASSERT_GT(count, 0);
  baked.mapper->SetRadiusScale(0.5);
  baked.mapper->Update();
  EXPECT_EQ(baked.mapper->GetNumberOfBakedParticles(), 0) << "maps of other radii are gone";
  Baked fresh;
  fresh.mapper->SetRadiusScale(0.5);
  EXPECT_EQ(rmsOf(baked.shown(), fresh.shown()), 0.0);
  baked.mapper->SetInputData(makeParticles(someBalls(300, 7)));
  Baked other(1);
  other.mapper->SetInputData(makeParticles(someBalls(300, 7)));
  other.mapper->SetRadiusScale(0.5);
  EXPECT_EQ(rmsOf(baked.shown(), other.shown()), 0.0);
}

TEST(BakedOcclusion, ARangeBakesWhatItAffects)
{
  Baked baked(1200);
  baked.mapper->SetRadiusScale(0.5);
  baked.source->GetShading()->SetAmbientOcclusionReach(0.1);
  baked.source->Update();
  const vtkIdType count = baked.mapper->GetNumberOfBakedParticles();
  baked.mapper->SetCenterRange(0, -2.0, 0.5);
  const Picture picture = baked.shown();
  EXPECT_LE(baked.mapper->GetNumberOfBakedParticles(), count + 400);
  Baked fresh(1200);
  fresh.mapper->SetRadiusScale(0.5);
  fresh.source->GetShading()->SetAmbientOcclusionReach(0.1);
  fresh.mapper->SetCenterRange(0, -2.0, 0.5);
  EXPECT_EQ(rmsOf(picture, fresh.shown()), 0.0) << "as if it had been baked so at once";
}

TEST(BakedOcclusion, PathsAndNoAmbientLightKnowNothingOfIt)
{
  Baked baked(50);
  baked.source->GetShading()->SetModeToPathTraced();
  baked.source->SetSamplesPerPixel(1);
  baked.source->Update();
  EXPECT_EQ(baked.mapper->GetNumberOfBakedParticles(), 0);
}

TEST(BakedOcclusion, AnAbortedPictureCanBeTakenUpAgain)
{
  Baked baked, whole;
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void* share)
    { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(*static_cast<double*>(share) > 0.2); });
  baked.source->SetNumberOfThreads(1);
  const unsigned long tag = baked.source->AddObserver(vtkCommand::ProgressEvent, stop);
  baked.source->Update();
  EXPECT_EQ(baked.source->GetOutput()->GetNumberOfPoints(), 0);
  baked.source->RemoveObserver(tag);
  baked.source->SetAbortExecute(0);
  baked.source->Modified();
  EXPECT_EQ(rmsOf(baked.shown(), whole.shown()), 0.0);
}

TEST(BakedOcclusion, WhatIsNotBakedYetIsNoPatternAndProgressIsTold)
{
  Baked baked(6000); // which are baked in several pieces
  baked.mapper->SetRadiusScale(0.4);
  mote::FrameTracer tracer;
  mote::FrameSettings settings;
  settings.shading = baked.source->GetShading();
  settings.autoAdjust = false;
  settings.threads = 1;
  baked.renderer->ResetCameraClippingRange();
  double until = 2.0; // of the progress; baking is its first half
  const auto frame = [&]
  {
    mote::MoteProps props = {mote::motePropOf(baked.actor)};
    return tracer.trace(
      baked.renderer, props, 48, 48, settings, [&](double done) { return done < until; });
  };
  const auto light = [&](int i) { return tracer.film().color()[4 * i]; };
  const auto isHit = [&](int i) { return tracer.film().color()[4 * i + 3] == 1.0f; };
  EXPECT_EQ(tracer.bakedShare(), 1.0) << "of nothing";
  until = 0.2;
  EXPECT_FALSE(frame());
  const double some = tracer.bakedShare();
  EXPECT_GT(some, 0.0);
  EXPECT_LT(some, 1.0);
  until = 0.4;
  EXPECT_FALSE(frame());
  EXPECT_GT(tracer.bakedShare(), some);
  EXPECT_LT(tracer.bakedShare(), 1.0);
  // Half-baked, as a moving view shows it: even, and about as bright as it will be.
  until = 2.0;
  settings.interactive = true;
  ASSERT_TRUE(frame());
  const std::vector<float> half(tracer.film().color(), tracer.film().color() + 4 * 48 * 48);
  settings.interactive = false;
  ASSERT_TRUE(frame());
  EXPECT_EQ(tracer.bakedShare(), 1.0);
  double before = 0.0, after = 0.0;
  int hits = 0, odd = 0;
  for (int i = 0; i < 48 * 48; ++i)
    if (isHit(i) && half[4 * i + 3] == 1.0f)
    {
      ++hits;
      odd += std::abs(half[4 * i] - 0.6f) > 0.01f ? 1 : 0;
      before += half[4 * i];
      after += light(i);
    }
  ASSERT_GT(hits, 500);
  EXPECT_EQ(odd, 0);
  EXPECT_NEAR(before / hits, after / hits, 0.15);
  // Turned a little, what is baked stays, and little else is even.
  settings.interactive = true;
  baked.renderer->GetActiveCamera()->Azimuth(10.0);
  ASSERT_TRUE(frame());
  int even = 0, all = 0;
  for (int i = 0; i < 48 * 48; ++i)
    if (isHit(i))
    {
      ++all;
      even += std::abs(light(i) - 0.6f) < 1e-6f ? 1 : 0;
    }
  EXPECT_GT(even, 0);
  EXPECT_LT(even, all / 4);
}

TEST(BakedOcclusion, APictureAtRestIsSharpWhileItBakes)
{
#ifdef __SANITIZE_THREAD__
  GTEST_SKIP()
    << "Frames take so long under ThreadSanitizer that all is baked before one is sharp.";
#endif
  Baked baked(20000);
  baked.mapper->SetRadiusScale(0.2);
  baked.source->GetShading()->SetBakeSide(16);
  baked.source->GetShading()->SetBakeSamples(256); // which takes many frames
  baked.source->GetShading()->BakeAdaptiveOff();
  mote::FrameTracer tracer;
  mote::FrameSettings settings;
  settings.shading = baked.source->GetShading();
  settings.progressive = true;
  settings.frameTime = settings.stillTime = 0.005;
  settings.threads = 1;
  baked.renderer->ResetCameraClippingRange();
  const auto frame = [&]
  {
    mote::MoteProps props = {mote::motePropOf(baked.actor)};
    ASSERT_TRUE(tracer.trace(baked.renderer, props, 512, 512, settings, {}));
  };
  frame();
  EXPECT_GT(tracer.distance(), 1.0);
  for (int i = 0; i < 100 && tracer.distance() > 1.0; ++i)
    frame();
  EXPECT_EQ(tracer.distance(), 1.0);
  EXPECT_LT(tracer.bakedShare(), 1.0);
  EXPECT_FALSE(tracer.converged());
  // Nothing is traced again until there is more to show: less than half is not shown.
  const unsigned long version = tracer.version();
  frame();
  if (tracer.bakedShare() < 0.5)
  {
    EXPECT_EQ(tracer.version(), version);
  }
}

TEST(BakedOcclusion, NothingIsBakedWhileTheViewMoves)
{
  Baked baked;
  mote::FrameTracer tracer;
  mote::FrameSettings settings;
  settings.shading = baked.source->GetShading();
  settings.autoAdjust = false;
  settings.progressive = true;
  settings.frameTime = 10.0;
  settings.interactive = true;
  baked.renderer->ResetCameraClippingRange();
  const auto frame = [&]
  {
    mote::MoteProps props = {mote::motePropOf(baked.actor)};
    EXPECT_TRUE(tracer.trace(baked.renderer, props, 48, 48, settings, {}));
  };
  frame();
  EXPECT_EQ(baked.mapper->GetNumberOfBakedParticles(), 0);
  EXPECT_FALSE(tracer.converged());
  settings.interactive = false;
  int frames = 0;
  for (; !tracer.converged() && frames < 1000; ++frames)
    frame();
  EXPECT_TRUE(tracer.converged());
  const vtkIdType count = baked.mapper->GetNumberOfBakedParticles();
  EXPECT_GT(count, 0);
  const unsigned long version = tracer.version();
  frame();
  EXPECT_EQ(tracer.version(), version) << "a frame in which nothing changed is not traced";
  settings.interactive = true;
  baked.renderer->GetActiveCamera()->Azimuth(120.0);
  baked.renderer->ResetCameraClippingRange();
  frame();
  EXPECT_EQ(baked.mapper->GetNumberOfBakedParticles(), count);
  // What comes with maps of its own, such as the time steps that are played, is lit by them.
  mote::ParticleModel& model = baked.mapper->GetModel();
  const auto stored = model.occlusion(nullptr)->known().stored(
    *model.structure(), static_cast<std::size_t>(model.statistics().valid), model.content());
  auto other = makeParticles(someBalls(400));
  mote::addOcclusionArrays(other->GetFieldData(), stored);
  baked.mapper->SetInputData(makeParticles(someBalls(300, 7)));
  frame();
  EXPECT_EQ(baked.mapper->GetNumberOfBakedParticles(), 0);
  baked.mapper->SetInputData(other);
  frame();
  EXPECT_EQ(baked.mapper->GetNumberOfBakedParticles(), count);
}
