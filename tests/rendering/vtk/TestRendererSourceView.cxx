// What vtkMoteRendererSource shows against VTK's own projection matrices and closed formulas.
#include "VTKTestSupport.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>

using namespace mote::testing;

namespace
{

struct View : ::testing::Test
{
  static constexpr int width = 90, height = 60;
  std::vector<Ball> balls = someBalls(60);
  Stage stage{makeParticles(balls)};
  vtkCamera* camera = stage.renderer->GetActiveCamera();

  View()
  {
    camera->SetPosition(4, 3, 5);
    camera->SetFocalPoint(0.1, 0.2, 0);
    camera->SetViewUp(0.1, 1, 0.2);
    camera->SetViewAngle(25);
  }

  /// Every pixel that is not at an edge must be what the true view says.
  void compare(const std::vector<Ball>& truth)
  {
    const Picture picture = stage.trace(width, height);
    const TrueView view(camera, width, height); // after the clipping range was set
    int clear = 0, covered = 0, wrong = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
      {
        if (!view.isClear(x + 0.5, y + 0.5, truth, 0.05))
          continue;
        ++clear;
        const auto hit = view.hit(x + 0.5, y + 0.5, truth);
        const int pixel = picture.at(x, y);
        if (picture.particle(pixel) != (hit ? hit->ball : -1))
        {
          ++wrong;
          continue;
        }
        if (!hit)
          continue;
        ++covered;
        EXPECT_NEAR(picture.depth(pixel), hit->depth, 2e-5 * hit->depth);
        for (int k = 0; k < 3; ++k)
          EXPECT_NEAR(picture.normal(pixel)[k], hit->normal[k], 2e-3);
      }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(clear, width * height / 2);
    EXPECT_GT(covered, 100);
  }
  void compare() { compare(balls); }
};

/// A ball of radius 1 that fills most of the picture.
struct Lit : ::testing::Test
{
  static constexpr int size = 48;
  std::vector<Ball> balls{{0, 0, 0, 1}};
  Stage stage{makeParticles(balls)};
  vtkCamera* camera = stage.renderer->GetActiveCamera();
  vtkNew<vtkLight> light;

  Lit()
  {
    stage.renderer->AddLight(light);
    stage.actor->GetProperty()->SetColor(1, 0.8, 0.6);
    stage.actor->GetProperty()->SetAmbient(0.1);
    stage.actor->GetProperty()->SetDiffuse(0.7);
  }

  /// `toLight` gives the direction to the light from a point, unit length.
  template <typename ToLight>
  void compare(const ToLight& toLight, const Point& color = {1, 1, 1})
  {
    const Picture picture = stage.trace(size, size);
    const TrueView view(camera, size, size);
    int lit = 0;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x)
      {
        const auto hit = view.hit(x + 0.5, y + 0.5, balls);
        if (!hit || !view.isClear(x + 0.5, y + 0.5, balls))
          continue;
        const double cosine = std::max(0.0, dot(hit->normal, toLight(hit->position)));
        lit += cosine > 0 ? 1 : 0;
        for (int k = 0; k < 3; ++k)
        {
          const double base = std::array<double, 3>{1, 0.8, 0.6}[k];
          const double expected = std::min(1.0, base * (0.1 + 0.7 * cosine * color[k]));
          EXPECT_NEAR(picture.color(picture.at(x, y))[k], expected, 2e-3);
        }
      }
    EXPECT_GT(lit, 20);
  }
};

} // namespace

TEST_F(View, ParticleAtUpperRightAppearsThere)
{
  Stage corner(makeParticles({{1, 0.9, 0, 0.2}}));
  const Picture picture = corner.trace(64, 64);
  for (int i = 0; i < picture.count(); ++i)
    if (picture.particle(i) == 0)
    {
      EXPECT_GT(i % 64, 45);
      EXPECT_GT(i / 64, 43); // row 0 is the bottom row
    }
  EXPECT_GT(picture.covered(), 10);
}

TEST_F(View, Perspective)
{
  compare();
}

TEST_F(View, Parallel)
{
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.3);
  compare();
}

TEST_F(View, ShiftedWindowCentre)
{
  camera->SetWindowCenter(0.3, -0.2);
  compare();
  camera->ParallelProjectionOn();
  compare();
}

TEST_F(View, HorizontalViewAngle)
{
  camera->UseHorizontalViewAngleOn();
  camera->SetViewAngle(30);
  compare();
}

TEST_F(View, WideAngleFromWithin)
{
  camera->SetPosition(0.1, 0, 0.05);
  camera->SetFocalPoint(0.5, 0.4, -0.2);
  camera->SetViewAngle(100);
  compare();
}

TEST_F(View, FarFromTheOrigin)
{
  const Point shift = {1e5, -2e5, 3e5};
  for (Ball& b : balls)
    b = {b.x + shift[0], b.y + shift[1], b.z + shift[2], b.r};
  stage.mapper->SetInputData(makeParticles(balls));
  camera->SetFocalPoint(shift.data());
  camera->SetPosition(4 + shift[0], 3 + shift[1], 5 + shift[2]);
  // VTK's matrices lose digits here: the truth is taken about the origin.
  vtkNew<vtkCamera> near;
  near->SetPosition(4, 3, 5);
  near->SetFocalPoint(0, 0, 0);
  near->SetViewUp(camera->GetViewUp());
  near->SetViewAngle(camera->GetViewAngle());
  const Picture picture = stage.trace(width, height);
  near->SetClippingRange(camera->GetClippingRange());
  const TrueView view(near, width, height);
  const std::vector<Ball> truth = someBalls(60);
  int wrong = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (view.isClear(x + 0.5, y + 0.5, truth))
      {
        const auto hit = view.hit(x + 0.5, y + 0.5, truth);
        wrong += picture.particle(picture.at(x, y)) != (hit ? hit->ball : -1) ? 1 : 0;
      }
  EXPECT_EQ(wrong, 0);
}

TEST_F(View, MovedAndEvenlyScaledActor)
{
  stage.actor->SetPosition(0.4, -0.3, 0.2);
  stage.actor->SetScale(0.7);
  stage.actor->RotateWXYZ(50, 1, 2, 3);
  std::vector<Ball> moved;
  for (const Ball& b : balls)
  {
    const double in[4] = {b.x, b.y, b.z, 1};
    double out[4];
    stage.actor->GetMatrix()->MultiplyPoint(in, out);
    moved.push_back({out[0], out[1], out[2], 0.7 * b.r});
  }
  compare(moved);
}

TEST_F(View, UnevenlyScaledActorShowsEllipsoids)
{
  Stage flat(makeParticles({{0, 0, 0, 0.5}}));
  flat.renderer->GetActiveCamera()->ParallelProjectionOn();
  flat.actor->SetScale(2, 1, 0.5);
  const Picture picture = flat.trace(60, 60); // 3 by 3
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 60; ++x)
    {
      const double px = (x + 0.5) / 20 - 1.5, py = (y + 0.5) / 20 - 1.5;
      const double inside = 1 - px * px - py * py / 0.25; // half axes 1, 0.5, 0.25
      if (std::abs(inside) < 0.02)
        continue;
      const int pixel = picture.at(x, y);
      ASSERT_EQ(picture.particle(pixel), inside > 0 ? 0 : -1) << x << " " << y;
      if (inside <= 0)
        continue;
      const double z = 0.25 * std::sqrt(inside);
      EXPECT_NEAR(picture.depth(pixel), 10 - z, 1e-4);
      const Point normal = unit({px, py / 0.25, z / 0.0625});
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(picture.normal(pixel)[k], normal[k], 2e-3);
    }
}

TEST_F(View, MirroredActor)
{
  stage.actor->SetScale(-1, 1, 1);
  std::vector<Ball> mirrored = balls;
  for (Ball& b : mirrored)
    b.x = -b.x;
  compare(mirrored);
}

TEST_F(View, FlattenedActorDoesNoHarm)
{
  stage.actor->SetScale(1, 1, 0);
  const Picture picture = stage.trace(width, height);
  for (int i = 0; i < picture.count(); ++i)
    for (int k = 0; k < 4; ++k)
      EXPECT_TRUE(picture.color(i)[k] >= 0 && picture.color(i)[k] <= 1);
}

TEST_F(View, ClippingRangeOfTheUserHolds)
{
  vtkNew<vtkMoteRendererSource> source;
  source->SetRenderer(stage.renderer);
  source->SetSize(width, height);
  source->SetSamplesPerPixel(1);
  source->IdsOn();
  source->DepthOn();
  source->NormalsOn();
  source->ResetClippingRangeOff();
  const double middle = std::sqrt(50.0);
  camera->SetClippingRange(middle - 0.3, middle + 0.3);
  source->Update();
  EXPECT_NEAR(camera->GetClippingRange()[0], middle - 0.3, 1e-12);
  const Picture picture{width, height, source->GetOutput()};
  const TrueView view(camera, width, height);
  int cut = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (view.isClear(x + 0.5, y + 0.5, balls))
      {
        const auto hit = view.hit(x + 0.5, y + 0.5, balls);
        EXPECT_EQ(picture.particle(picture.at(x, y)), hit ? hit->ball : -1);
        cut += hit && hit->depth > middle - 0.3 + 1e-6 &&
                   dot(hit->normal, minus({4, 3, 5}, hit->position)) < 0
                 ? 1
                 : 0;
      }
  EXPECT_GT(cut, 5) << "some are seen from within";
}

TEST_F(Lit, SceneLight)
{
  light->SetLightTypeToSceneLight();
  light->SetPosition(3, 4, 5);
  light->SetFocalPoint(1, 0, 0);
  const Point to = unit({2, 4, 5});
  compare([&](const Point&) { return to; });
}

TEST_F(Lit, ColourAndIntensity)
{
  light->SetLightTypeToSceneLight();
  light->SetPosition(0, 0, 5);
  light->SetColor(1, 0.5, 0.25);
  light->SetIntensity(0.8);
  compare([](const Point&) { return Point{0, 0, 1}; }, {0.8, 0.4, 0.2});
}

TEST_F(Lit, Headlight)
{
  light->SetLightTypeToHeadlight();
  camera->SetPosition(6, 6, -2);
  const Point to = unit({6, 6, -2});
  compare([&](const Point&) { return to; });
  camera->Azimuth(70);
  Point position;
  camera->GetPosition(position.data());
  compare([&](const Point&) { return unit(position); });
}

TEST_F(Lit, CameraLight)
{
  light->SetLightTypeToCameraLight();
  light->SetPosition(1, 0, 1); // to the right of the camera, which is at (0, 0, 1) there
  light->SetFocalPoint(0, 0, 0);
  compare([](const Point&) { return unit({1, 0, 1}); });
  camera->SetPosition(10, 0, 0); // its right is now -z
  compare([](const Point&) { return unit({1, 0, -1}); });
}

TEST_F(Lit, PositionalLight)
{
  light->SetLightTypeToSceneLight();
  light->PositionalOn();
  light->SetConeAngle(90); // every direction
  light->SetPosition(1.2, 0.5, 1.5);
  compare([](const Point& p) { return unit(minus({1.2, 0.5, 1.5}, p)); });
}

TEST_F(Lit, LightsAddUpAndOnesSwitchedOffDoNot)
{
  light->SetLightTypeToSceneLight();
  light->SetPosition(0, 0, 5);
  light->SetIntensity(0.5);
  vtkNew<vtkLight> second, off;
  second->SetLightTypeToSceneLight();
  second->SetPosition(0, 0, 1);
  second->SetIntensity(0.3);
  off->SetLightTypeToSceneLight();
  off->SwitchOff();
  stage.renderer->AddLight(second);
  stage.renderer->AddLight(off);
  compare([](const Point&) { return Point{0, 0, 1}; }, {0.8, 0.8, 0.8});
}

TEST_F(Lit, WithoutLightsAHeadlight)
{
  stage.renderer->RemoveAllLights();
  camera->SetPosition(0, 8, 6);
  compare([](const Point&) { return Point{0, 0.8, 0.6}; });
}

TEST_F(Lit, NotWhereThePropertySaysSo)
{
  stage.actor->GetProperty()->LightingOff();
  const Picture picture = stage.trace(size, size);
  const float* color = picture.color(picture.at(size / 2 - 12, size / 2));
  EXPECT_NEAR(color[0], 1.0, 1e-6);
  EXPECT_NEAR(color[1], 0.8, 1e-6);
}
