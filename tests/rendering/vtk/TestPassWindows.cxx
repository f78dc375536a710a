// vtkMoteRayCastPass in several viewports, layers and windows, beside other props, and when things
// go away in any order.
#include "WindowTestSupport.h"

#include "vtkAssembly.h"
#include "vtkAxesActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkOutlineFilter.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkScalarBarActor.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>

using namespace mote::testing;

namespace
{

/// Share of a part of the shot that is not black.
int bright(const Shot& shot, int x0, int y0, int x1, int y1)
{
  int sum = 0;
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x)
      sum += shot.at(x, y)[0] + shot.at(x, y)[1] + shot.at(x, y)[2] > 30 ? 1 : 0;
  return sum;
}

/// What only this drawing shows.
Shot single(int width, int height, const std::vector<Ball>& balls, double azimuth)
{
  Drawing drawing(width, height);
  drawing.addParticles(balls, {1, 1, 1});
  drawing.camera()->Azimuth(azimuth);
  return drawing.shoot();
}

} // namespace

TEST(Viewports, FourWithCamerasOfTheirOwn)
{
  const std::vector<Ball> balls = someBalls(50);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(200, 160);
  vtkNew<vtkMoteRayCastPass> shared;
  std::vector<std::unique_ptr<Drawing>> views;
  for (int k = 0; k < 4; ++k)
  {
    views.push_back(std::make_unique<Drawing>());
    Drawing& view = *views.back();
    view.window->RemoveRenderer(view.renderer);
    view.renderer->SetViewport(
      0.5 * (k % 2), 0.5 * (k / 2), 0.5 + 0.5 * (k % 2), 0.5 + 0.5 * (k / 2));
    view.addParticles(balls, {1, 1, 1});
    view.camera()->Azimuth(40 * k);
    // One pass for two renderers, one of its own, and none.
    view.renderer->SetPass(k < 2 ? shared.Get() : k == 2 ? view.pass.Get() : nullptr);
    window->AddRenderer(view.renderer);
  }
  for (int round = 0; round < 2; ++round)
  {
    const Shot shot = shoot(window);
    for (int k = 0; k < 4; ++k)
    {
      const Shot alone = single(100, 80, balls, 40 * k);
      int wrong = 0;
      for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 100; ++x)
          for (int c = 0; c < 3; ++c)
            wrong +=
              std::abs(alone.at(x, y)[c] - shot.at(x + 100 * (k % 2), y + 80 * (k / 2))[c]) > 2 ? 1
                                                                                                : 0;
      EXPECT_EQ(wrong, 0) << "view " << k << ", round " << round;
    }
  }
  window->SetSize(300, 240);
  const Shot resized = shoot(window);
  const Shot alone = single(150, 120, balls, 120);
  int wrong = 0;
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 150; ++x)
      wrong += std::abs(alone.at(x, y)[0] - resized.at(x + 150, y + 120)[0]) > 2 ? 1 : 0;
  EXPECT_EQ(wrong, 0) << "resized";
}

TEST(Windows, OddSizes)
{
  for (const auto& size : {std::array<int, 2>{1, 1}, {7, 3}, {33, 257}, {301, 17}})
  {
    Drawing drawing(size[0], size[1]);
    drawing.addParticles({{0, 0, 0, 1}}, {1, 1, 1});
    const Shot shot = drawing.shoot();
    EXPECT_EQ(shot.width, size[0]);
    EXPECT_EQ(shot.height, size[1]);
    EXPECT_LT(shot.depthAt(size[0] / 2, size[1] / 2), 1.0f) << size[0];
  }
}

TEST(Windows, MultiSampledOnesShowTheSame)
{
  Drawing plain, multi;
  multi.window->SetMultiSamples(8);
  for (Drawing* d : {&plain, &multi})
  {
    d->addParticles(someBalls(50), {1, 0.5, 0});
    d->renderer->ResetCameraClippingRange();
  }
  EXPECT_LE(differentPixels(plain.shoot(), multi.shoot(), 4), 0);
}

TEST(Windows, BlendOverTheBackground)
{
  Drawing drawing;
  drawing.renderer->GradientBackgroundOn();
  drawing.renderer->SetBackground(0, 0, 1);
  drawing.renderer->SetBackground2(0, 1, 0);
  const Shot empty = drawing.shoot();
  paint(drawing.addParticles({{0, 0, 0, 0.5}}, {1, 0, 0}), {1, 0, 0});
  drawing.pass->SetSamplesPerPixel(16);
  const Shot shot = drawing.shoot();
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 160; ++x)
    {
      // At the edge it is between the two.
      const double share = shot.at(x, y)[0] / 255.0;
      for (int c = 1; c < 3; ++c)
        EXPECT_NEAR(shot.at(x, y)[c], (1 - share) * empty.at(x, y)[c], 2.5);
    }
}

TEST(Windows, ScalarBarAxesAndOutlineBeside)
{
  Drawing drawing(320, 240);
  auto actor = drawing.addParticles(someBalls(50), {1, 1, 1});
  auto* mapper = vtkMoteParticleMapper::SafeDownCast(actor->GetMapper());
  addValues(mapper->GetInput(), "v", std::vector<double>(50, 0.5));
  drawing.renderer->ResetCameraClippingRange();
  const Shot without = drawing.shoot();
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(mapper->GetLookupTable());
  drawing.renderer->AddActor2D(bar);
  const Shot withBar = drawing.shoot();
  EXPECT_GT(differentPixels(without, withBar), 500);
  EXPECT_EQ(drawing.pass->GetNumberOfRays(), 0);
  vtkNew<vtkAxesActor> axes;
  drawing.renderer->AddActor(axes);
  const Shot withAxes = drawing.shoot();
  EXPECT_GT(differentPixels(withBar, withAxes), 100);
  vtkNew<vtkOutlineFilter> outline;
  outline->SetInputData(mapper->GetInput());
  vtkNew<vtkPolyDataMapper> lines;
  lines->SetInputConnection(outline->GetOutputPort());
  vtkNew<vtkActor> box;
  box->SetMapper(lines);
  drawing.renderer->AddActor(box);
  EXPECT_GT(differentPixels(withAxes, drawing.shoot()), 50);
}

TEST(Windows, PartsOfAssembliesAreDrawnInPlace)
{
  Drawing drawing;
  auto actor = drawing.addParticles({{0, 0, 0, 0.3}}, {1, 1, 1});
  drawing.renderer->RemoveActor(actor);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(actor);
  assembly->SetPosition(1, 0.5, 0);
  drawing.renderer->AddActor(assembly);
  drawing.renderer->ResetCameraClippingRange();
  const Shot shot = drawing.shoot();
  EXPECT_GT(shot.at(80 + 40, 60 + 20)[0], 50) << "moved with the assembly";
  EXPECT_EQ(shot.at(80, 60)[0], 0);
}

TEST(Layers, EachWithItsOwnPicture)
{
  Drawing drawing;
  drawing.addTriangles({{0, 0, 0, 0.9}}, {0, 0, 1});
  drawing.renderer->SetLayer(0);
  drawing.window->SetNumberOfLayers(2);
  vtkNew<vtkRenderer> top;
  vtkNew<vtkMoteRayCastPass> topPass;
  top->SetPass(topPass);
  top->SetLayer(1);
  drawing.window->AddRenderer(top);
  placeCamera(top->GetActiveCamera());
  vtkNew<vtkMoteParticleMapper> mapper;
  mapper->SetInputData(makeParticles({{0, 0, -5, 0.4}})); // farther, yet in the upper layer
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  paint(actor, {1, 0, 0});
  top->AddActor(actor);
  top->ResetCameraClippingRange();
  const Shot shot = drawing.shoot();
  EXPECT_EQ(shot.at(80, 60)[0], 255);
  EXPECT_EQ(shot.at(80, 60)[2], 0);
  EXPECT_GT(shot.at(80 + 25, 60)[2], 0) << "the lower layer shows beside it";
  EXPECT_EQ(shot.at(80 + 25, 60)[0], 0);
}

TEST(Tiles, LargeImagesHaveNoSeams)
{
  for (const bool parallel : {false, true})
  {
    const std::vector<Ball> balls = someBalls(100);
    Drawing small(100, 80), large(200, 160);
    for (Drawing* d : {&small, &large})
    {
      d->addParticles(balls, {1, 0.7, 0.4});
      d->camera()->SetParallelProjection(parallel);
      d->renderer->ResetCameraClippingRange();
    }
    vtkNew<vtkWindowToImageFilter> grab;
    grab->SetInput(small.window);
    grab->SetScale(2);
    grab->Update();
    auto* pixels =
      vtkUnsignedCharArray::SafeDownCast(grab->GetOutput()->GetPointData()->GetScalars());
    Shot tiled;
    tiled.width = grab->GetOutput()->GetDimensions()[0];
    tiled.height = grab->GetOutput()->GetDimensions()[1];
    tiled.color.assign(pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
    EXPECT_LE(differentPixels(tiled, large.shoot(), 3), 40);
  }
}

TEST(Lifetimes, WindowGoesFirst)
{
  vtkNew<vtkMoteParticleMapper> mapper;
  mapper->SetInputData(makeParticles({{0, 0, 0, 0.5}}));
  vtkNew<vtkMoteRayCastPass> pass;
  for (const bool withPass : {true, false, true})
  {
    Drawing drawing;
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    drawing.renderer->AddActor(actor);
    drawing.renderer->SetPass(withPass ? pass.Get() : nullptr);
    EXPECT_GT(bright(drawing.shoot(), 60, 40, 100, 80), 100);
  }
}

TEST(Lifetimes, MapperAndPassGoFirst)
{
  Drawing drawing(160, 120, false);
  for (const bool withPass : {true, false, true})
  {
    vtkNew<vtkMoteRayCastPass> pass;
    auto actor = drawing.addParticles({{0, 0, 0, 0.5}}, {1, 1, 1});
    drawing.renderer->SetPass(withPass ? pass.Get() : nullptr);
    EXPECT_GT(bright(drawing.shoot(), 60, 40, 100, 80), 100);
    drawing.renderer->RemoveActor(actor);
    drawing.renderer->SetPass(nullptr);
  }
  EXPECT_EQ(bright(drawing.shoot(), 0, 0, 160, 120), 0);
}

TEST(Lifetimes, PassMovesBetweenWindows)
{
  vtkNew<vtkMoteRayCastPass> pass;
  const std::vector<Ball> balls{{0, 0, 0, 0.5}};
  auto first = std::make_unique<Drawing>();
  first->addParticles(balls, {1, 1, 1});
  first->renderer->SetPass(pass);
  const Shot expected = first->shoot();
  Drawing second;
  second.addParticles(balls, {1, 1, 1});
  second.renderer->SetPass(pass); // shared for a while
  EXPECT_EQ(differentPixels(expected, second.shoot(), 1), 0);
  EXPECT_EQ(differentPixels(expected, first->shoot(), 1), 0);
  first->renderer->SetPass(nullptr); // so that the window, going away, does not tell the pass
  first.reset();
  EXPECT_EQ(differentPixels(expected, second.shoot(), 1), 0);
  Drawing third;
  third.addParticles(balls, {1, 1, 1});
  third.renderer->SetPass(pass);
  EXPECT_EQ(differentPixels(expected, third.shoot(), 1), 0);
  EXPECT_EQ(differentPixels(expected, second.shoot(), 1), 0);
}

TEST(Lifetimes, RendererMovesBetweenWindows)
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkMoteRayCastPass> pass;
  renderer->SetPass(pass);
  vtkNew<vtkMoteParticleMapper> mapper;
  mapper->SetInputData(makeParticles({{0, 0, 0, 0.5}}));
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
  placeCamera(renderer->GetActiveCamera());
  for (int round = 0; round < 3; ++round)
  {
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(0);
    window->SetSize(160, 120);
    window->AddRenderer(renderer);
    EXPECT_GT(bright(shoot(window), 60, 40, 100, 80), 100) << round;
    window->RemoveRenderer(renderer);
  }
}

TEST(Lifetimes, ResourcesReleasedAreMadeAgain)
{
  Drawing drawing;
  auto actor = drawing.addParticles({{0, 0, 0, 0.5}}, {1, 1, 1});
  const Shot first = drawing.shoot();
  drawing.pass->ReleaseGraphicsResources(drawing.window);
  EXPECT_EQ(differentPixels(first, drawing.shoot(), 0), 0);
  drawing.pass->ReleaseGraphicsResources(nullptr);
  EXPECT_EQ(differentPixels(first, drawing.shoot(), 0), 0);
  drawing.renderer->SetPass(nullptr);
  drawing.shoot();
  actor->GetMapper()->ReleaseGraphicsResources(drawing.window);
  EXPECT_LE(differentPixels(first, drawing.shoot(), 2), 0);
  drawing.window->Finalize();
  EXPECT_LE(differentPixels(first, drawing.shoot(), 2), 0) << "the window's context is a new one";
}

TEST(Lifetimes, ManyWindowsOneAfterTheOther)
{
  vtkNew<vtkMoteRayCastPass> pass;
  for (int round = 0; round < 8; ++round)
  {
    Drawing drawing(64, 48);
    drawing.addParticles({{0, 0, 0, 1}}, {1, 1, 1});
    drawing.renderer->SetPass(pass);
    EXPECT_GT(bright(drawing.shoot(), 20, 14, 44, 34), 100);
    if (round % 2)
      drawing.renderer->SetPass(nullptr);
  }
}

TEST(Lifetimes, WindowReopensWhileThePassIsAway)
{
  Drawing drawing;
  drawing.addParticles({{0, 0, 0, 0.5}}, {1, 1, 1});
  const Shot first = drawing.shoot();
  drawing.renderer->SetPass(nullptr);
  drawing.window->Finalize();
  drawing.renderer->SetPass(drawing.pass);
  EXPECT_EQ(differentPixels(first, drawing.shoot(), 0), 0);
}
