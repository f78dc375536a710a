// Depth compositing of vtkMoteRayCastPass, and of the mapper alone, with true VTK geometry.
#include "WindowTestSupport.h"

#include "vtkCamera.h"
#include "vtkCylinderSource.h"
#include "vtkImageData.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropPicker.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <cmath>

using namespace mote::testing;

namespace
{

/// A view: projection, and whether the pass is used.
struct Mode
{
  bool parallel;
  bool pass;
};

std::string nameOf(const ::testing::TestParamInfo<Mode>& info)
{
  return std::string(info.param.parallel ? "Parallel" : "Perspective") +
         (info.param.pass ? "Pass" : "Alone");
}

class Depth : public ::testing::TestWithParam<Mode>
{
protected:
  Depth()
  {
    drawing.pass->SetSamplesPerPixel(1);
    drawing.camera()->SetPosition(4, 3, 5);
    drawing.camera()->SetParallelProjection(GetParam().parallel);
    drawing.camera()->SetParallelScale(1.4);
    drawing.camera()->SetViewAngle(24);
  }
  void reset() { drawing.renderer->ResetCameraClippingRange(); }

  Drawing drawing{160, 120, GetParam().pass};
};

INSTANTIATE_TEST_SUITE_P(Modes, Depth,
  ::testing::Values(Mode{false, true}, Mode{false, false}, Mode{true, true}, Mode{true, false}),
  nameOf);

vtkSmartPointer<vtkActor> add(vtkRenderer* renderer, vtkPolyDataAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
  return actor;
}

/// Pixels that are not alike, not counting those at an edge of the first picture.
struct Mismatch
{
  int inner = 0, compared = 0;
  double depth = 0.0; ///< largest difference of depth values
};

Mismatch compareInside(const Shot& a, const Shot& b, int tolerance)
{
  Mismatch m;
  for (int y = 1; y + 1 < a.height; ++y)
    for (int x = 1; x + 1 < a.width; ++x)
    {
      bool edge = false;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          for (const Shot* s : {&a, &b})
            edge = edge || std::abs(s->depthAt(x + dx, y + dy) - s->depthAt(x, y)) > 0.04;
      if (edge)
        continue;
      ++m.compared;
      bool different = false;
      for (int k = 0; k < 3; ++k)
        different = different || std::abs(a.at(x, y)[k] - b.at(x, y)[k]) > tolerance;
      m.inner += different ? 1 : 0;
      m.depth = std::max(m.depth, double(std::abs(a.depthAt(x, y) - b.depthAt(x, y))));
    }
  return m;
}

} // namespace

TEST_P(Depth, ParticlesLookAsTriangulatedSpheresDo)
{
  const std::vector<Ball> balls = someBalls(40);
  auto mote = drawing.addParticles(balls, {1, 0.7, 0.4});
  auto triangles = drawing.addTriangles(balls, {1, 0.7, 0.4});
  reset();
  triangles->VisibilityOff();
  const Shot ours = drawing.shoot();
  triangles->VisibilityOn();
  mote->VisibilityOff();
  const Shot theirs = drawing.shoot();
  const Mismatch m = compareInside(theirs, ours, 6);
  EXPECT_GT(m.compared, 160 * 120 / 2);
  EXPECT_LE(m.inner, m.compared / (GetParam().pass ? 200 : 30)) << "alone it smooths edges";
  EXPECT_LT(m.depth, 0.04);
  int silhouette = 0;
  for (std::size_t i = 0; i < ours.depth.size(); ++i)
    silhouette += (ours.depth[i] < 1) != (theirs.depth[i] < 1) ? 1 : 0;
  EXPECT_LE(silhouette, GetParam().pass ? 60 : 400) << "4 samples reach a little farther";
}

TEST_P(Depth, ValuesAreThoseOfTheSpheres)
{
  const std::vector<Ball> balls = someBalls(40);
  drawing.addParticles(balls, {1, 1, 1});
  reset();
  const Shot shot = drawing.shoot();
  const TrueView view(drawing.camera(), 160, 120);
  int covered = 0, wrong = 0;
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 160; ++x)
    {
      if (!view.isClear(x + 0.5, y + 0.5, balls, 0.6))
        continue;
      const auto hit = view.hit(x + 0.5, y + 0.5, balls);
      const double expected = hit ? hit->window : 1.0;
      covered += hit ? 1 : 0;
      // Alone, four samples a pixel are taken, and the nearest counts.
      wrong += std::abs(shot.depthAt(x, y) - expected) > (GetParam().pass ? 2e-5 : 0.02) ? 1 : 0;
    }
  EXPECT_GT(covered, 1000);
  EXPECT_EQ(wrong, 0);
}

TEST_P(Depth, InterpenetratingPropsHideOneAnother)
{
  const std::vector<Ball> balls{{0, 0, 0, 0.6}, {0.7, 0.4, -0.3, 0.4}};
  const Point red{1, 0, 0}, green{0, 1, 0}, blue{0, 0, 1}, yellow{1, 1, 0};
  auto mote = drawing.addParticles(balls, red);
  auto triangles = drawing.addTriangles(balls, red, 256);
  paint(mote, red);
  paint(triangles, red);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-1, -1, 0.1);
  plane->SetPoint1(1, -1, 0.1);
  plane->SetPoint2(-1, 1, 0.3);
  paint(add(drawing.renderer, plane), green);
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetRadius(0.25);
  cylinder->SetHeight(2);
  cylinder->SetResolution(64);
  paint(add(drawing.renderer, cylinder), blue);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(0.4, 0, 0.5);
  sphere->SetRadius(0.35);
  sphere->SetThetaResolution(128);
  sphere->SetPhiResolution(128);
  paint(add(drawing.renderer, sphere), yellow);
  reset();
  mote->VisibilityOff();
  const Shot theirs = drawing.shoot();
  mote->VisibilityOn();
  triangles->VisibilityOff();
  const Shot ours = drawing.shoot();
  int wrong = 0, seen = 0;
  for (int y = 2; y < 118; ++y)
    for (int x = 2; x < 158; ++x)
    {
      bool even = true; // away from edges and seams
      for (int dy = -2; dy <= 2; ++dy)
        for (int dx = -2; dx <= 2; ++dx)
          even =
            even && std::equal(theirs.at(x, y), theirs.at(x, y) + 3, theirs.at(x + dx, y + dy));
      if (!even)
        continue;
      seen += theirs.at(x, y)[0] == 255 && theirs.at(x, y)[1] == 0 ? 1 : 0;
      wrong += std::equal(theirs.at(x, y), theirs.at(x, y) + 3, ours.at(x, y)) ? 0 : 1;
    }
  EXPECT_GT(seen, 500);
  EXPECT_EQ(wrong, 0);
}

TEST_P(Depth, IntersectingMoteActors)
{
  const std::vector<Ball> first{{-0.2, 0, 0, 0.6}, {0.9, 0.5, 0, 0.3}};
  const std::vector<Ball> second{{0.2, 0, 0.1, 0.6}, {0.8, 0.5, 0.1, 0.3}};
  std::vector<Ball> all = first;
  all.insert(all.end(), second.begin(), second.end());
  paint(drawing.addParticles(first, {1, 0, 0}), {1, 0, 0});
  paint(drawing.addParticles(second, {0, 1, 0}), {0, 1, 0});
  reset();
  const Shot shot = drawing.shoot();
  const TrueView view(drawing.camera(), 160, 120);
  int wrong = 0, seen[2] = {0, 0};
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 160; ++x)
      if (view.isClear(x + 0.5, y + 0.5, all, 1.0))
        if (const auto hit = view.hit(x + 0.5, y + 0.5, all))
        {
          const int which = hit->ball < 2 ? 0 : 1;
          ++seen[which];
          wrong += shot.at(x, y)[which] == 255 && shot.at(x, y)[1 - which] == 0 ? 0 : 1;
        }
  EXPECT_GT(seen[0], 500);
  EXPECT_GT(seen[1], 500);
  EXPECT_EQ(wrong, 0);
}

TEST_P(Depth, TranslucentPropInFrontBlends)
{
  paint(drawing.addParticles({{0, 0, 0, 0.8}}, {1, 0, 0}), {1, 0, 0});
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-5, -5, 0);
  plane->SetPoint1(5, -5, 0);
  plane->SetPoint2(-5, 5, 0);
  auto glass = add(drawing.renderer, plane);
  paint(glass, {0, 0, 1});
  glass->GetProperty()->SetOpacity(0.5);
  glass->SetPosition(0, 0, 1.5); // before all of the ball
  drawing.camera()->SetPosition(0, 0, 10);
  reset();
  Shot shot = drawing.shoot();
  EXPECT_NEAR(shot.at(80, 60)[0], 128, 2);
  EXPECT_NEAR(shot.at(80, 60)[2], 128, 2);
  EXPECT_NEAR(shot.at(5, 5)[0], 0, 2);
  EXPECT_NEAR(shot.at(5, 5)[2], 128, 2);
  glass->SetPosition(0, 0, -1.5); // behind it
  reset();
  shot = drawing.shoot();
  EXPECT_NEAR(shot.at(80, 60)[0], 255, 1);
  EXPECT_NEAR(shot.at(80, 60)[2], 0, 1);
  EXPECT_NEAR(shot.at(5, 5)[2], 128, 2);
}

TEST_P(Depth, TranslucentParticlesShowWhatIsBehindThem)
{
  auto actor = drawing.addParticles({{0, 0, 0, 0.8}}, {1, 0, 0});
  paint(actor, {1, 0, 0});
  actor->GetProperty()->SetOpacity(0.5);
  drawing.renderer->SetBackground(0, 0, 1);
  drawing.camera()->SetPosition(0, 0, 10);
  reset();
  for (const bool peeling : {false, true})
  {
    drawing.renderer->SetUseDepthPeeling(peeling);
    drawing.renderer->SetViewport(0, 0, 1, 1);
    Shot shot = drawing.shoot();
    EXPECT_NEAR(shot.at(80, 60)[0], 128, 2);
    EXPECT_NEAR(shot.at(80, 60)[2], 128, 2);
    EXPECT_EQ(shot.at(3, 3)[2], 255);
    drawing.renderer->SetViewport(0.5, 0.5, 1, 1);
    shot = drawing.shoot();
    EXPECT_NEAR(shot.at(120, 90)[0], 128, 2);
    EXPECT_NEAR(shot.at(120, 90)[2], 128, 2);
    EXPECT_EQ(shot.at(82, 62)[2], 255);
  }
}

TEST_P(Depth, ClippingRangeOfTheUserCutsAsItCutsTriangles)
{
  const std::vector<Ball> balls{{0, 0, 0, 0.8}, {0.9, 0.6, -0.5, 0.4}};
  auto mote = drawing.addParticles(balls, {1, 1, 1});
  auto triangles = drawing.addTriangles(balls, {1, 1, 1}, 256);
  paint(mote, {1, 1, 1});
  paint(triangles, {1, 1, 1});
  drawing.camera()->SetPosition(0, 0, 10);
  for (const auto& range : {std::array<double, 2>{9.7, 10.2}, {9.3, 10.0}, {5, 9.5}})
  {
    drawing.camera()->SetClippingRange(range[0], range[1]);
    triangles->VisibilityOff();
    mote->VisibilityOn();
    const Shot ours = drawing.shoot();
    triangles->VisibilityOn();
    mote->VisibilityOff();
    const Shot theirs = drawing.shoot();
    EXPECT_LE(differentPixels(ours, theirs, 100), GetParam().pass ? 60 : 160) << range[0];
  }
}

TEST_P(Depth, CameraAmongTheParticles)
{
  const std::vector<Ball> balls = someBalls(300);
  auto mote = drawing.addParticles(balls, {1, 0.7, 0.4});
  auto triangles = drawing.addTriangles(balls, {1, 0.7, 0.4}, 64);
  drawing.camera()->SetPosition(0, 0, 0);
  drawing.camera()->SetFocalPoint(0, 0, -1);
  drawing.camera()->SetViewAngle(70);
  if (GetParam().parallel)
    drawing.camera()->SetParallelScale(0.8);
  reset();
  triangles->VisibilityOff();
  const Shot ours = drawing.shoot();
  triangles->VisibilityOn();
  mote->VisibilityOff();
  const Shot theirs = drawing.shoot();
  const Mismatch m = compareInside(theirs, ours, 12);
  EXPECT_GT(m.compared, 160 * 120 / 4);
  EXPECT_LE(m.inner, m.compared / (GetParam().pass ? 50 : 20));
}

TEST_P(Depth, PropPickerFindsActorAndPosition)
{
  const std::vector<Ball> left{{-0.7, 0, 0, 0.5}}, right{{0.7, 0, 0, 0.5}};
  auto a = drawing.addParticles(left, {1, 0, 0});
  auto b = drawing.addParticles(right, {0, 1, 0});
  auto c = drawing.addTriangles({{0, 0.9, 0, 0.3}}, {0, 0, 1});
  drawing.camera()->SetPosition(0, 0, 10);
  drawing.camera()->SetParallelScale(1.5);
  reset();
  drawing.shoot();
  const TrueView view(drawing.camera(), 160, 120);
  vtkNew<vtkPropPicker> picker;
  const auto pickAt = [&](const Ball& ball)
  {
    drawing.renderer->SetWorldPoint(ball.x, ball.y, ball.z, 1);
    drawing.renderer->WorldToDisplay();
    const double* place = drawing.renderer->GetDisplayPoint();
    const double x = std::floor(place[0]), y = std::floor(place[1]);
    picker->Pick(x, y, 0, drawing.renderer);
    const auto hit = view.hit(x + 0.5, y + 0.5, {ball});
    for (int k = 0; k < 3 && hit && picker->GetViewProp(); ++k)
      EXPECT_NEAR(picker->GetPickPosition()[k], hit->position[k], 0.05);
    return picker->GetActor();
  };
  EXPECT_EQ(pickAt(left[0]), a);
  EXPECT_EQ(pickAt(right[0]), b);
  EXPECT_EQ(pickAt({0, 0.9, 0, 0.3}), c);
  EXPECT_EQ(picker->Pick(2, 2, 0, drawing.renderer), 0);
  const Shot after = drawing.shoot();
  EXPECT_EQ(after.at(2, 2)[0], 0) << "the selection's colours are gone";
}

TEST(PassOrNone, GiveTheSamePicture)
{
  for (const bool parallel : {false, true})
  {
    Drawing with(200, 150, true), without(200, 150, false);
    for (Drawing* d : {&with, &without})
    {
      d->addParticles(someBalls(100), {1, 0.7, 0.4});
      d->addTriangles({{0, 0, 0, 0.5}}, {0, 0, 1});
      d->camera()->SetParallelProjection(parallel);
      d->renderer->ResetCameraClippingRange();
    }
    with.pass->SetSamplesPerPixel(4);
    // Blending over an edge of what was drawn later gives a few pixels another look.
    EXPECT_LE(differentPixels(with.shoot(), without.shoot()), 150);
  }
}
