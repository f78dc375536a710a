// How a picture comes about: at once, or from coarse to fine in frames that may be stopped.
#include "VolumeTestSupport.h"

#include "FrameTracer.h"

#include "vtkCamera.h"
#include "vtkContourValues.h"
#include "vtkLight.h"
#include "vtkMoteAreaLight.h"
#include "vtkMoteShading.h"
#include "vtkMoteSilhouettes.h"
#include "vtkProperty.h"

using namespace mote::testing;
using mote::Film;

namespace
{

constexpr int width = 130, height = 100; // no multiples of a tile's side
constexpr long long pixels = width * height;
constexpr long long tile = mote::tileSize * mote::tileSize;

/// Balls and a box with an iso-surface, whose frames are traced without a window.
struct Tracing
{
  VolumeStage stage{makeBox(4, [](const Point& p) { return p[0]; })};
  vtkNew<vtkMoteParticleMapper> balls;
  vtkNew<vtkActor> actor;
  vtkNew<vtkMoteShading> shading;
  vtkNew<vtkMoteSilhouettes> silhouettes;
  mote::FrameTracer tracer;
  mote::FrameSettings settings;
  bool stop = false; ///< what `progress` answers

  Tracing()
  {
    balls->SetInputData(makeParticles(someBalls(60)));
    actor->SetMapper(balls);
    stage.renderer->AddActor(actor);
    stage.renderer->ResetCameraClippingRange();
    settings.shading = shading;
    settings.silhouettes = silhouettes;
    settings.refinement = {4};
    settings.threads = 1;
  }
  /// A frame shows what there is after every tile.
  void showEveryTile()
  {
    settings.progressive = true;
    settings.frameTime = settings.stillTime = 0.0;
  }
  bool frame(int columns = width, int rows = height)
  {
    mote::MoteProps props = {mote::motePropOf(actor), mote::motePropOf(stage.volume)};
    return tracer.trace(
      stage.renderer, props, columns, rows, settings, [this](double) { return !stop; });
  }
  void addSlowThings()
  {
    vtkNew<vtkMoteAreaLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(1, 2, 3);
    light->ShadowsOn();
    light->SetSize(20);
    light->SetSamples(2);
    stage.renderer->AddLight(light);
    actor->GetProperty()->SetAmbient(0.5);
    shading->SetAmbientOcclusionSamples(2);
    stage.property()->GetIsoSurfaceValues()->SetValue(0, 0.3);
    stage.mapper->ShowIsoSurfacesOn();
    silhouettes->EnabledOn();
  }
  /// Everything that is shown.
  std::vector<float> shown() const
  {
    const Film& film = tracer.film();
    std::vector<float> all(film.color(), film.color() + 4 * film.pixels());
    all.insert(all.end(), film.nearestDepth(), film.nearestDepth() + film.pixels());
    tracer.silhouettes().forCovered(0, film.height(),
      [&](std::size_t pixel, float share)
      {
        all.push_back(float(pixel));
        all.push_back(share);
      });
    return all;
  }
};

} // namespace

TEST(FrameTracer, BitByBitIsAsAtOnce)
{
  for (const bool slow : {false, true})
  {
    Tracing atOnce, bits;
    bits.showEveryTile();
    if (!slow)
      for (Tracing* t : {&atOnce, &bits})
        t->stage.volume->VisibilityOff();
    for (Tracing* t : {&atOnce, &bits})
      if (slow)
        t->addSlowThings();
    ASSERT_TRUE(atOnce.frame());
    EXPECT_TRUE(atOnce.tracer.converged());
    int frames = 0;
    while (!bits.tracer.converged() && ++frames < 1000)
      EXPECT_TRUE(bits.frame());
    EXPECT_TRUE(bits.tracer.converged());
    EXPECT_GT(frames, 20);
    EXPECT_EQ(bits.tracer.samples(), 4);
    EXPECT_EQ(bits.shown(), atOnce.shown());
    EXPECT_TRUE(bits.frame());
    EXPECT_EQ(bits.tracer.rays(), 0);
  }
}

/// However long it takes to find what is seen, baking comes to its end, and tells how far it is.
TEST(FrameTracer, BakesLargeViewsBitByBit)
{
  Tracing t;
  t.stage.volume->VisibilityOff();
  t.showEveryTile();
  t.settings.refinement = {1};
  ASSERT_TRUE(t.frame());
  EXPECT_EQ(t.tracer.bakedShare(), 1.0); // none is asked for
  t.shading->SetAmbientOcclusionToBaked();
  t.shading->SetAmbientOcclusionReach(0.5);
  t.shading->SetBakeSide(4);
  t.shading->SetBakeSamples(4);
  double before = 0.0;
  int frames = 0;
  for (; frames < 40 && (frames < 2 || t.tracer.bakedShare() < 1.0); ++frames)
  {
    ASSERT_TRUE(t.frame(8000, 6000)); // more rays than the first time for it allows
    EXPECT_TRUE(frames < 2 || t.tracer.bakedShare() >= before);
    before = t.tracer.bakedShare();
  }
  EXPECT_EQ(t.tracer.bakedShare(), 1.0);
  EXPECT_GT(frames, 2);
}

TEST(FrameTracer, MovesNoCoarserThanWanted)
{
  Tracing t;
  t.addSlowThings();
  t.settings.interactive = true;
  t.settings.frameTime = 0.0; // never enough
  for (const double most : {1.0, 2.0, 5.5})
  {
    t.stage.renderer->GetActiveCamera()->Azimuth(3.0);
    t.settings.mostDistance = most;
    ASSERT_TRUE(t.frame());
    EXPECT_EQ(t.tracer.distance(), most);
  }
  t.stage.renderer->GetActiveCamera()->Azimuth(3.0);
  t.settings.mostDistance = 100.0;
  ASSERT_TRUE(t.frame());
  EXPECT_EQ(t.tracer.distance(), 32.0);
}

TEST(FrameTracer, FirstFramesAreCoarseAndLaterOnesShort)
{
  Tracing t;
  t.addSlowThings();
  t.showEveryTile();
  ASSERT_TRUE(t.frame());
  EXPECT_EQ(t.tracer.distance(), 32.0);
  EXPECT_LE(t.tracer.rays(), 5 * 4);
  EXPECT_GT(t.tracer.silhouettes().film->samples(), 0) << "with lines";
  double distance = t.tracer.distance();
  for (int frames = 0; !t.tracer.converged(); ++frames)
  {
    ASSERT_LT(frames, 1000);
    ASSERT_TRUE(t.frame());
    // A tile of colours, one of depths where a film begins, and depths of a sample at the end.
    EXPECT_LE(t.tracer.rays(), 2 * tile + pixels);
    EXPECT_LE(t.tracer.distance(), distance) << "never coarser again";
    EXPECT_LT(t.tracer.finerShare(), 1.0);
    EXPECT_GE(t.tracer.samples(), 1);
    distance = t.tracer.distance();
  }
  EXPECT_EQ(distance, 1.0);
}

TEST(FrameTracer, WhatWasStoppedGoesOnAndNothingIsTracedTwice)
{
  Tracing t;
  t.settings.refinement = {3};
  t.stop = true;
  long long rays = 0;
  int frames = 0;
  for (; !t.tracer.converged() && frames < 1000; ++frames)
  {
    const bool shown = t.frame();
    EXPECT_EQ(shown, t.tracer.samples() > 0) << "a picture with holes is not shown";
    EXPECT_LE(t.tracer.rays(), tile);
    EXPECT_GT(t.tracer.rays(), 0);
    rays += t.tracer.rays();
  }
  EXPECT_EQ(rays, 3 * pixels);
  Tracing atOnce;
  atOnce.settings.refinement = {3};
  atOnce.frame();
  EXPECT_EQ(t.shown(), atOnce.shown());
}

TEST(FrameTracer, AStoppedFrameKeepsWhatIsShown)
{
  Tracing t;
  t.settings.progressive = true;
  t.settings.frameTime = 0.0;
  t.settings.stillTime = 1e9;
  t.frame();
  for (int frames = 0; t.tracer.samples() < 2; ++frames)
  {
    ASSERT_LT(frames, 100);
    ASSERT_TRUE(t.frame());
  }
  t.stop = true;
  ASSERT_TRUE(t.frame());
  EXPECT_EQ(t.tracer.samples(), 2);
  EXPECT_FALSE(t.tracer.converged());
  EXPECT_EQ(t.tracer.film().width(), width);
}

TEST(FrameTracer, EveryChangeShowsAtOnceWhateverWaits)
{
  Tracing t;
  t.addSlowThings();
  t.showEveryTile();
  t.stop = true; // as if keys were held
  for (const double hue : {0.0, 0.5, 1.0})
  {
    t.actor->GetProperty()->SetColor(hue, 0.3, 0.6);
    const unsigned long version = t.tracer.version();
    EXPECT_TRUE(t.frame());
    EXPECT_NE(t.tracer.version(), version);
    EXPECT_EQ(t.tracer.samples(), 1);
    EXPECT_LE(t.tracer.rays(), 5 * 4);
  }
  t.settings.interactive = true;
  t.stage.camera()->Azimuth(20);
  const unsigned long version = t.tracer.version();
  EXPECT_TRUE(t.frame());
  EXPECT_NE(t.tracer.version(), version);
}

TEST(FrameTracer, TimeChoosesTheFirstFilm)
{
  Tracing t;
  t.settings.progressive = true;
  t.settings.stillTime = 1e9;
  t.settings.frameTime = 0.0;
  t.frame();
  EXPECT_EQ(t.tracer.distance(), 1.0);
  EXPECT_EQ(t.tracer.rays(), pixels);
  t.settings.autoAdjust = false;
  t.settings.stillTime = 0.0;
  t.stage.camera()->Azimuth(5);
  t.frame();
  EXPECT_EQ(t.tracer.distance(), 1.0) << "no lower resolution where nobody wants it";
}

TEST(FrameTracer, FinerFilmsBeginAsCopies)
{
  Tracing t;
  t.stage.paint({1, 0.5, 0.2}, 0.9);
  t.showEveryTile();
  t.settings.autoAdjust = false;
  ASSERT_TRUE(t.frame()); // a draft of full resolution
  EXPECT_FALSE(t.tracer.converged());
  const std::vector<float> draft(t.tracer.film().color(), t.tracer.film().color() + 4 * pixels);
  ASSERT_TRUE(t.frame()); // a tile of the last film
  EXPECT_GT(t.tracer.finerShare(), 0.0);
  EXPECT_LE(t.tracer.finerShare(), 2.0 * tile / pixels);
  long long different = 0;
  for (long long i = 0; i < pixels; ++i)
    different += !std::equal(&draft[4 * i], &draft[4 * i] + 4, t.tracer.film().color() + 4 * i,
      [](float a, float b) { return std::abs(a - b) < 1e-6f; });
  EXPECT_LE(different, tile);
}
