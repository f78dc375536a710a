// When vtkMoteRayCastPass traces, how finely, and what it makes known of it.
#include "WindowTestSupport.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkProperty.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <sstream>
#include <thread>

#include <cmath>

using namespace mote::testing;

namespace
{

struct Frames : ::testing::Test
{
  Drawing drawing;
  vtkSmartPointer<vtkActor> actor = drawing.addParticles(someBalls(200), {1, 0.7, 0.4});
  vtkMoteRayCastPass* pass = drawing.pass;
  static constexpr int pixels = 160 * 120;

  Frames() { drawing.renderer->ResetCameraClippingRange(); }
};

} // namespace

TEST_F(Frames, CastsSamplesPerPixelRaysAtRest)
{
  drawing.shoot();
  EXPECT_EQ(pass->GetNumberOfSamples(), 4);
  EXPECT_EQ(pass->GetNumberOfRays(), 4 * pixels);
  EXPECT_TRUE(pass->IsConverged());
  EXPECT_EQ(pass->GetImageSampleDistance(), 1.0);
  EXPECT_GT(pass->GetTraceTime(), 0.0);
  EXPECT_GT(pass->GetDisplayTime(), 0.0);
  pass->SetSamplesPerPixel(6); // two more
  drawing.shoot();
  EXPECT_EQ(pass->GetNumberOfRays(), 2 * pixels);
  EXPECT_EQ(pass->GetNumberOfSamples(), 6);
}

TEST_F(Frames, UnchangedOnesAreNotTracedAgain)
{
  const Shot first = drawing.shoot();
  const Shot second = drawing.shoot();
  EXPECT_EQ(pass->GetNumberOfRays(), 0);
  EXPECT_EQ(pass->GetTraceTime(), 0.0);
  EXPECT_EQ(differentPixels(first, second, 0), 0);
  EXPECT_EQ(first.depth, second.depth);
}

TEST_F(Frames, OverlayChangesShowWithoutTracing)
{
  vtkNew<vtkTextActor> text;
  text->SetInput("one");
  text->GetTextProperty()->SetFontSize(40);
  drawing.renderer->AddActor2D(text);
  const Shot first = drawing.shoot();
  text->SetInput("two");
  const Shot second = drawing.shoot();
  EXPECT_EQ(pass->GetNumberOfRays(), 0);
  EXPECT_GT(differentPixels(first, second), 50);
  drawing.renderer->SetBackground(0, 0.2, 0);
  const Shot third = drawing.shoot();
  EXPECT_EQ(pass->GetNumberOfRays(), 0);
  EXPECT_GT(differentPixels(second, third), 1000);
}

TEST_F(Frames, OrdinaryPropsWithinTheBoundsMoveWithoutTracing)
{
  auto ball = drawing.addTriangles({{0, 0, 0, 0.3}}, {0, 0, 1});
  const Shot first = drawing.shoot();
  ball->SetPosition(0.3, 0.3, 0.2);
  const Shot second = drawing.shoot();
  EXPECT_EQ(pass->GetNumberOfRays(), 0);
  EXPECT_GT(differentPixels(first, second), 10);
}

TEST_F(Frames, EveryChangeIsTraced)
{
  drawing.shoot();
  const auto traced = [&]
  {
    drawing.shoot();
    const bool did = pass->GetNumberOfRays() > 0;
    drawing.shoot();
    EXPECT_EQ(pass->GetNumberOfRays(), 0) << "and then no more";
    return did;
  };
  auto* mapper = vtkMoteParticleMapper::SafeDownCast(actor->GetMapper());
  vtkPolyData* data = vtkPolyData::SafeDownCast(mapper->GetInput());
  drawing.camera()->Azimuth(5);
  EXPECT_TRUE(traced()) << "camera";
  drawing.camera()->SetWindowCenter(0.1, 0);
  EXPECT_TRUE(traced()) << "window centre";
  drawing.camera()->ParallelProjectionOn();
  EXPECT_TRUE(traced()) << "projection";
  actor->SetPosition(0.1, 0, 0);
  EXPECT_TRUE(traced()) << "actor";
  actor->GetProperty()->SetColor(0, 1, 0);
  EXPECT_TRUE(traced()) << "property";
  vtkNew<vtkProperty> property;
  actor->SetProperty(property);
  EXPECT_TRUE(traced()) << "another property";
  mapper->SetRadiusScale(0.5);
  EXPECT_TRUE(traced()) << "radii";
  addValues(data, "v", std::vector<double>(200, 0.5));
  EXPECT_TRUE(traced()) << "values";
  mapper->SetScalarRange(0, 0.6);
  EXPECT_TRUE(traced()) << "range";
  mapper->UseVisibilityRangeOn();
  EXPECT_TRUE(traced()) << "visibility";
  data->GetPoints()->SetPoint(0, 0, 0, 1);
  data->GetPoints()->Modified();
  EXPECT_TRUE(traced()) << "points";
  vtkLight* light = vtkLight::SafeDownCast(drawing.renderer->GetLights()->GetItemAsObject(0));
  light->SetIntensity(0.4);
  EXPECT_TRUE(traced()) << "light";
  auto other = drawing.addParticles({{0, 0, 1, 0.2}}, {1, 0, 0});
  EXPECT_TRUE(traced()) << "actor added";
  other->VisibilityOff();
  EXPECT_TRUE(traced()) << "actor hidden";
  drawing.window->SetSize(170, 120);
  EXPECT_TRUE(traced()) << "size";
}

TEST_F(Frames, MovingViewsAreCoarserAndRestIsFullAgain)
{
  const Shot full = drawing.shoot();
  pass->SetInteractiveFrameTime(0.001);
  drawing.window->SetDesiredUpdateRate(15);
  drawing.camera()->Azimuth(1);
  drawing.shoot();
  drawing.camera()->Azimuth(-1);
  drawing.window->SetSize(640, 480); // more than a millisecond's work
  drawing.shoot();
  EXPECT_GT(pass->GetImageSampleDistance(), 1.0);
  EXPECT_EQ(pass->GetNumberOfSamples(), 1);
  EXPECT_LT(pass->GetNumberOfRays(), 640 * 480);
  EXPECT_FALSE(pass->IsConverged());
  drawing.window->SetSize(160, 120);
  drawing.window->SetDesiredUpdateRate(0.001);
  const Shot still = drawing.shoot();
  EXPECT_EQ(pass->GetImageSampleDistance(), 1.0);
  EXPECT_EQ(pass->GetNumberOfSamples(), 4);
  EXPECT_TRUE(pass->IsConverged());
  EXPECT_EQ(differentPixels(full, still, 1), 0);
}

TEST_F(Frames, MovingViewsAreOneSampleWithoutAdjustment)
{
  pass->AutoAdjustResolutionOff();
  pass->SetInteractiveFrameTime(0.001);
  drawing.window->SetSize(640, 480);
  drawing.window->SetDesiredUpdateRate(15);
  drawing.shoot();
  EXPECT_EQ(pass->GetImageSampleDistance(), 1.0);
  EXPECT_EQ(pass->GetNumberOfRays(), 640 * 480);
  EXPECT_FALSE(pass->IsConverged());
}

TEST_F(Frames, ProgressiveOnesConvergeToTheSamePicture)
{
  pass->SetSamplesPerPixel(16);
  const Shot atOnce = drawing.shoot();
  Drawing step;
  step.addParticles(someBalls(200), {1, 0.7, 0.4});
  step.renderer->ResetCameraClippingRange();
  step.pass->SetSamplesPerPixel(16);
  step.pass->ProgressiveOn();
  step.pass->SetInteractiveFrameTime(0.001);
  int frames = 0;
  int samples = 0;
  do
  {
    step.window->Render();
    ASSERT_LT(++frames, 20);
    EXPECT_GT(step.pass->GetNumberOfSamples(), samples);
    samples = step.pass->GetNumberOfSamples();
    EXPECT_EQ(step.pass->IsConverged(), samples == 16);
  } while (!step.pass->IsConverged());
  EXPECT_GT(frames, 1);
  EXPECT_EQ(differentPixels(atOnce, step.shoot(), 0), 0);
  EXPECT_EQ(step.pass->GetNumberOfRays(), 0);
}

TEST_F(Frames, ThatDoNotRefineShowWhatThereIs)
{
  pass->SetSamplesPerPixel(16);
  pass->ProgressiveOn();
  pass->SetInteractiveFrameTime(0.001);
  const Shot first = drawing.shoot();
  const int samples = pass->GetNumberOfSamples();
  pass->RefiningOff();
  EXPECT_EQ(differentPixels(first, drawing.shoot(), 0), 0);
  EXPECT_EQ(pass->GetNumberOfRays(), 0);
  EXPECT_EQ(pass->GetNumberOfSamples(), samples);
  EXPECT_FALSE(pass->IsConverged());
  // Another view is no longer what there is.
  drawing.camera()->Azimuth(20);
  EXPECT_GT(differentPixels(first, drawing.shoot(), 0), 0);
  EXPECT_GT(pass->GetNumberOfRays(), 0);
  drawing.camera()->Azimuth(-20);
  pass->RefiningOn();
  for (int frames = 0; frames == 0 || !pass->IsConverged(); ++frames)
  {
    ASSERT_LT(frames, 40);
    drawing.window->Render();
  }
  // What is not progressive is traced as always.
  const Shot best = drawing.shoot();
  pass->ProgressiveOff();
  pass->RefiningOff();
  drawing.camera()->Azimuth(20);
  drawing.shoot();
  EXPECT_TRUE(pass->IsConverged());
  drawing.camera()->Azimuth(-20);
  EXPECT_EQ(differentPixels(best, drawing.shoot(), 0), 0);
}

TEST_F(Frames, RefinementEndsAtTheNoiseLevel)
{
  pass->SetSamplesPerPixel(1000);
  pass->SetNoiseLevel(0.02);
  EXPECT_TRUE(std::isinf(pass->GetNoise()));
  const Shot atOnce = drawing.shoot();
  const int samples = pass->GetNumberOfSamples();
  EXPECT_TRUE(pass->IsConverged());
  EXPECT_LE(pass->GetNoise(), 0.02);
  EXPECT_GE(samples, 4);
  EXPECT_LT(samples, 100);
  drawing.shoot();
  EXPECT_EQ(pass->GetNumberOfRays(), 0) << "nothing more to do";
  pass->SetNoiseLevel(0.01); // goes on from there
  pass->ProgressiveOn();
  pass->SetInteractiveFrameTime(0.001);
  for (int frames = 0; frames == 0 || !pass->IsConverged(); ++frames)
  {
    ASSERT_LT(frames, 400);
    drawing.window->Render();
    EXPECT_GT(pass->GetNumberOfSamples(), samples);
  }
  EXPECT_LE(pass->GetNoise(), 0.01);
  // Moving is one sample, and rest is the same picture again.
  drawing.window->SetDesiredUpdateRate(15);
  drawing.camera()->Azimuth(1);
  drawing.shoot();
  EXPECT_EQ(pass->GetNumberOfSamples(), 1);
  drawing.camera()->Azimuth(-1);
  drawing.window->SetDesiredUpdateRate(0.001);
  pass->ProgressiveOff();
  pass->SetNoiseLevel(0.02);
  EXPECT_EQ(differentPixels(atOnce, drawing.shoot(), 0), 0);
  EXPECT_EQ(pass->GetNumberOfSamples(), samples);
  // A picture that was traced without looking at the noise is traced again for it.
  pass->SetNoiseLevel(0.0);
  pass->SetSamplesPerPixel(5);
  drawing.camera()->Azimuth(1);
  drawing.shoot();
  pass->SetNoiseLevel(0.02);
  pass->SetSamplesPerPixel(1000);
  drawing.shoot();
  EXPECT_TRUE(pass->IsConverged());
  EXPECT_LE(pass->GetNoise(), 0.02);
}

TEST_F(Frames, ProgressComesFromTheDrawingThread)
{
  struct Listener
  {
    double last = 0;
    int count = 0;
    bool otherThread = false;
    std::thread::id thread = std::this_thread::get_id();
    void progress(vtkObject*, unsigned long, void* done)
    {
      const double now = *static_cast<double*>(done);
      EXPECT_GE(now, 0.0);
      EXPECT_LE(now, 1.0);
      last = std::max(last, now);
      ++count;
      otherThread = otherThread || std::this_thread::get_id() != thread;
    }
  } listener;
  pass->AddObserver(vtkCommand::ProgressEvent, &listener, &Listener::progress);
  drawing.shoot();
  EXPECT_GT(listener.count, 2);
  EXPECT_GT(listener.last, 0.7);
  EXPECT_FALSE(listener.otherThread);
}

namespace
{

/// Stops all that asks, or all that tells of progress, as a user who holds a key.
struct Aborter
{
  vtkRenderWindow* window;
  bool on = true;
  int asked = 0;

  Aborter(vtkRenderWindow* w, vtkObject* asking, unsigned long event)
    : window(w)
  {
    asking->AddObserver(event, this, &Aborter::check);
  }
  void check()
  {
    ++asked;
    if (on)
      window->SetAbortRender(1);
  }
};

} // namespace

TEST_F(Frames, AbortedOnesHaveNotConverged)
{
  Aborter aborter(drawing.window, drawing.window, vtkCommand::AbortCheckEvent);
  drawing.window->Render();
  EXPECT_FALSE(pass->IsConverged());
  aborter.on = false;
  drawing.window->SetAbortRender(0);
  drawing.shoot();
  EXPECT_TRUE(pass->IsConverged());
  EXPECT_EQ(pass->GetNumberOfSamples(), 4);
}

TEST_F(Frames, ProgressiveOnesShowEveryChangeWhateverWaits)
{
  pass->ProgressiveOn();
  auto box = drawing.addTriangles({{0, 0, 0, 0.5}}, {0, 0, 1}); // VTK asks before it draws one
  Aborter aborter(drawing.window, pass, vtkCommand::ProgressEvent);
  Shot before;
  for (const double hue : {0.2, 0.6, 1.0})
  {
    actor->GetProperty()->SetColor(hue, 1 - hue, 0.3);
    drawing.window->Render();
    EXPECT_EQ(aborter.asked, 0) << "it is short";
    EXPECT_EQ(drawing.window->GetAbortRender(), 0);
    EXPECT_GE(pass->GetNumberOfSamples(), 1);
    const Shot now = read(drawing.window);
    if (before.width > 0)
    {
      EXPECT_GT(differentPixels(before, now), 1000);
    }
    before = now;
  }
  drawing.window->Render(); // sharpens, and is stopped
  EXPECT_GT(aborter.asked, 0);
  EXPECT_FALSE(pass->IsConverged());
  aborter.on = false;
  for (int frames = 0; !pass->IsConverged(); ++frames)
  {
    ASSERT_LT(frames, 20);
    drawing.window->Render();
  }
  pass->ProgressiveOff();
  const Shot sharp = read(drawing.window);
  actor->GetProperty()->Modified();
  EXPECT_EQ(differentPixels(sharp, drawing.shoot(), 0), 0);
}

TEST_F(Frames, WithNothingToDrawConverge)
{
  actor->VisibilityOff();
  const Shot shot = drawing.shoot();
  EXPECT_TRUE(pass->IsConverged());
  EXPECT_EQ(pass->GetNumberOfRays(), 0);
  EXPECT_EQ(std::count(shot.depth.begin(), shot.depth.end(), 1.0f), pixels);
  auto* mapper = vtkMoteParticleMapper::SafeDownCast(actor->GetMapper());
  actor->VisibilityOn();
  mapper->SetInputData(nullptr);
  drawing.shoot();
  EXPECT_TRUE(pass->IsConverged());
}

TEST_F(Frames, CameraWithoutDirectionIsAnErrorOnce)
{
  Complaints complaints(pass), camera(drawing.camera());
  drawing.camera()->SetViewUp(0, 0, 1);
  drawing.window->Render();
  drawing.window->Render();
  EXPECT_EQ(complaints.errors, 1);
  EXPECT_FALSE(pass->IsConverged());
}

TEST_F(Frames, WithoutDelegateIsAnError)
{
  Complaints complaints(pass);
  pass->SetDelegatePass(nullptr);
  drawing.window->Render();
  EXPECT_GE(complaints.errors, 1);
}

TEST_F(Frames, PrintSelfTellsItsState)
{
  std::ostringstream text;
  pass->Print(text);
  for (const char* part : {"SamplesPerPixel: 4", "Progressive: Off", "AutoAdjustResolution: On"})
    EXPECT_NE(text.str().find(part), std::string::npos) << part;
}
