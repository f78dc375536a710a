// Silhouettes in a window: those of vtkMoteRayCastPass, and of vtkMoteSilhouettePass over any
// scene.
#include "WindowTestSupport.h"

#include "vtkCamera.h"
#include "vtkHardwareSelector.h"
#include "vtkMoteShading.h"
#include "vtkMoteSilhouettePass.h"
#include "vtkMoteSilhouettes.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProp3DCollection.h"
#include "vtkProperty.h"
#include "vtkRenderStepsPass.h"
#include "vtkSelection.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <cmath>

using namespace mote::testing;

namespace
{

constexpr int width = 160, height = 120;

vtkSmartPointer<vtkActor> addPlane(Drawing& drawing, double z, double side, const Point& color)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-side, -side, z);
  plane->SetPoint1(side, -side, z);
  plane->SetPoint2(-side, side, z);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  paint(actor, color);
  drawing.renderer->AddActor(actor);
  return actor;
}

/// White lines on red balls before black: how white each pixel is, 0 to 255.
int whiteness(const Shot& shot, int x, int y)
{
  return std::min(shot.at(x, y)[1], shot.at(x, y)[2]);
}

long whiteness(const Shot& shot)
{
  long sum = 0;
  for (int y = 0; y < shot.height; ++y)
    for (int x = 0; x < shot.width; ++x)
      sum += whiteness(shot, x, y);
  return sum;
}

struct PassSilhouettes : ::testing::Test
{
  Drawing drawing{width, height};
  vtkMoteRayCastPass* pass = drawing.pass;
  vtkMoteSilhouettes* silhouettes = pass->GetSilhouettes();

  PassSilhouettes() { useWhite(silhouettes); }
  static void useWhite(vtkMoteSilhouettes* s)
  {
    s->SetColor(1, 1, 1);
    s->SetThresholdModeToWorld();
    s->SetThreshold(0.2);
  }
  void addBalls(const std::vector<Ball>& balls)
  {
    paint(drawing.addParticles(balls, {1, 0, 0}), {1, 0, 0});
    drawing.renderer->ResetCameraClippingRange();
  }
  /// Pixels of the outline of a ball in the middle, and its mean distance from where it should be.
  void expectOutline(const Shot& shot, double radius, double tolerance)
  {
    double sum = 0.0, distance = 0.0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
      {
        const double w = whiteness(shot, x, y);
        sum += w;
        distance += w * std::hypot(x + 0.5 - 0.5 * width, y + 0.5 - 0.5 * height);
      }
    EXPECT_NEAR(distance / sum, radius, tolerance);
    EXPECT_NEAR(sum / 255.0 / (2.0 * M_PI * radius), 1.5, 0.4) << "as wide as the default";
  }
  /// Of a ball about the origin, as it looks from (0, 0, 10).
  double outline(double radius) const
  {
    return 0.5 * height * (radius / std::sqrt(100.0 - radius * radius)) / (1.5 / 10.0);
  }
};

} // namespace

TEST_F(PassSilhouettes, AreOffUnlessEnabledAndThenLieOnOutlines)
{
  addBalls({{0, 0, 0, 0.8}});
  const Shot plain = drawing.shoot();
  EXPECT_EQ(whiteness(plain), 0);
  EXPECT_EQ(pass->GetSilhouetteTime(), 0.0);
  silhouettes->EnabledOn();
  const Shot lines = drawing.shoot();
  expectOutline(lines, outline(0.8), 0.3);
  EXPECT_GT(pass->GetSilhouetteTime(), 0.0);
  pass->SetSilhouettes(nullptr);
  EXPECT_EQ(differentPixels(drawing.shoot(), plain, 0), 0);
}

TEST_F(PassSilhouettes, ChangesAtRestLeaveTheSamplesAsTheyAre)
{
  addBalls(someBalls(60));
  pass->SetSamplesPerPixel(6);
  const Shot plain = drawing.shoot();
  const int pixels = width * height;
  silhouettes->EnabledOn();
  const Shot later = drawing.shoot();
  EXPECT_EQ(pass->GetNumberOfRays(), 6 * pixels) << "for depths alone";
  EXPECT_EQ(pass->GetNumberOfSamples(), 6);
  EXPECT_TRUE(pass->IsConverged());
  EXPECT_GT(differentPixels(later, plain), 500);
  silhouettes->SetColor(0, 1, 1);
  EXPECT_GT(differentPixels(drawing.shoot(), later), 500);
  EXPECT_EQ(pass->GetNumberOfRays(), 0) << "another colour";
  silhouettes->EnabledOff();
  EXPECT_EQ(differentPixels(drawing.shoot(), plain, 0), 0);
  EXPECT_EQ(pass->GetNumberOfRays(), 0) << "off";
  silhouettes->EnabledOn();
  silhouettes->SetColor(1, 1, 1);
  EXPECT_EQ(differentPixels(drawing.shoot(), later, 0), 0);
  EXPECT_EQ(pass->GetNumberOfRays(), 0) << "on again";
  // Lines that came later are those that a new picture has.
  Drawing fresh(width, height);
  useWhite(fresh.pass->GetSilhouettes());
  fresh.pass->GetSilhouettes()->EnabledOn();
  fresh.pass->SetSamplesPerPixel(6);
  paint(fresh.addParticles(someBalls(60), {1, 0, 0}), {1, 0, 0});
  fresh.renderer->ResetCameraClippingRange();
  EXPECT_EQ(differentPixels(fresh.shoot(), later, 0), 0);
  EXPECT_EQ(fresh.pass->GetNumberOfRays(), 6 * pixels);
  silhouettes->SetThreshold(0.05);
  EXPECT_GT(differentPixels(drawing.shoot(), later), 100);
  EXPECT_EQ(pass->GetNumberOfRays(), 6 * pixels);
  pass->SetSamplesPerPixel(8);
  drawing.shoot();
  EXPECT_EQ(pass->GetNumberOfSamples(), 8);
  EXPECT_TRUE(pass->IsConverged());
}

TEST_F(PassSilhouettes, ComeWithDraftsAndProgress)
{
  addBalls(someBalls(60));
  silhouettes->EnabledOn();
  silhouettes->SetThickness(3);
  pass->GetShading()->SetAmbientOcclusionSamples(2);
  drawing.window->SetDesiredUpdateRate(15);
  drawing.camera()->Azimuth(1);
  const Shot moving = drawing.shoot();
  EXPECT_GT(whiteness(moving), 200000);
  EXPECT_FALSE(pass->IsConverged());
  drawing.window->SetDesiredUpdateRate(0.0001);
  const Shot rest = drawing.shoot();
  EXPECT_TRUE(pass->IsConverged());
  EXPECT_GT(whiteness(rest), 200000);
  pass->ProgressiveOn();
  pass->SetInteractiveFrameTime(0.001);
  drawing.camera()->Azimuth(-1);
  drawing.camera()->Azimuth(1);
  silhouettes->SetThreshold(0.3);
  int frames = 0;
  do
    drawing.shoot();
  while (!pass->IsConverged() && ++frames < 100);
  EXPECT_TRUE(pass->IsConverged());
  EXPECT_GE(frames, 1) << "silhouettes are found little by little, too";
}

TEST_F(PassSilhouettes, AreAsNearAsWhatTheyBelongTo)
{
  addBalls({{0, 0, 0, 0.8}});
  silhouettes->EnabledOn();
  const Shot alone = drawing.shoot();
  auto plane = addPlane(drawing, -1.2, 5, {0, 0, 0}); // behind
  drawing.renderer->ResetCameraClippingRange();
  const Shot before = drawing.shoot();
  EXPECT_LT(differentPixels(before, alone, 8), 20);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
    {
      const bool line = whiteness(alone, x, y) > 0;
      ASSERT_TRUE(!line || before.depthAt(x, y) < before.depthAt(1, 1)) << x << " " << y;
    }
  plane->SetPosition(0, 0, 2.4); // in front
  drawing.renderer->ResetCameraClippingRange();
  EXPECT_EQ(whiteness(drawing.shoot()), 0);
  plane->SetPosition(0, 0, 1.7); // cuts the ball's front off
  drawing.renderer->ResetCameraClippingRange();
  EXPECT_EQ(whiteness(drawing.shoot()), 0);
}

TEST_F(PassSilhouettes, OfAnySceneStandInTheDepthBuffer)
{
  for (const int samples : {0, 4})
  {
    Drawing scene(width, height, false);
    scene.window->SetMultiSamples(samples);
    vtkNew<vtkMoteSilhouettePass> lines;
    useWhite(lines->GetSilhouettes());
    scene.renderer->SetPass(lines);
    paint(scene.addTriangles({{0, 0, 0, 0.8}}, {1, 0, 0}, 256), {1, 0, 0});
    scene.renderer->ResetCameraClippingRange();
    expectOutline(scene.shoot(), outline(0.8), 0.6);
    EXPECT_GT(lines->GetSilhouetteTime(), 0.0);
    EXPECT_EQ(lines->GetNumberOfRenderedProps(), 1);
    // What stands before something else; the wall has none, as it fills the view.
    auto wall = addPlane(scene, -2, 9, {0, 0, 0});
    scene.renderer->ResetCameraClippingRange();
    expectOutline(scene.shoot(), outline(0.8), 0.6);
    wall->SetPosition(0, 0, 1.95); // hardly behind
    scene.renderer->ResetCameraClippingRange();
    lines->GetSilhouettes()->SetThreshold(1.5);
    EXPECT_EQ(whiteness(scene.shoot()), 0);
    lines->GetSilhouettes()->EnabledOff();
    scene.shoot();
    EXPECT_EQ(lines->GetSilhouetteTime(), 0.0);
  }
}

TEST_F(PassSilhouettes, OfDepthBuffersStayInTheirViewportBelowTexts)
{
  Drawing scene(width, height, false);
  vtkNew<vtkMoteSilhouettePass> lines;
  useWhite(lines->GetSilhouettes());
  scene.renderer->SetPass(lines);
  scene.renderer->SetViewport(0.5, 0, 1, 1);
  paint(scene.addTriangles({{0, 0, 0, 0.8}}, {1, 0, 0}), {1, 0, 0});
  scene.renderer->ResetCameraClippingRange();
  const Shot shot = scene.shoot();
  EXPECT_GT(whiteness(shot), 10000);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width / 2; ++x)
      ASSERT_EQ(whiteness(shot, x, y), 0);
  vtkNew<vtkTextActor> text;
  text->SetInput("MMMMMM");
  text->GetTextProperty()->SetFontSize(40);
  text->GetTextProperty()->SetColor(0, 0, 1);
  text->GetTextProperty()->SetBackgroundColor(0, 0, 1);
  text->GetTextProperty()->SetBackgroundOpacity(1);
  text->SetPosition(0, 40);
  scene.renderer->AddActor2D(text);
  const Shot covered = scene.shoot();
  int blue = 0;
  for (int x = width / 2; x < width; ++x)
  {
    blue += covered.at(x, 60)[2] == 255 && covered.at(x, 60)[1] == 0 ? 1 : 0;
    EXPECT_EQ(whiteness(covered, x, 60), 0) << "over the text at " << x;
  }
  EXPECT_GT(blue, 40);
  // A pass of one's own that does not render GetLinePass() has them over everything.
  vtkNew<vtkRenderStepsPass> own;
  lines->SetDelegatePass(own);
  EXPECT_GT(whiteness(scene.shoot()), 10000);
}

TEST_F(PassSilhouettes, OfRaysComeFromTheRays)
{
  addBalls(someBalls(60));
  silhouettes->EnabledOn();
  const Shot direct = drawing.shoot();
  silhouettes->EnabledOff();
  vtkNew<vtkMoteSilhouettePass> lines;
  useWhite(lines->GetSilhouettes());
  lines->SetDelegatePass(pass);
  drawing.renderer->SetPass(lines);
  EXPECT_EQ(differentPixels(drawing.shoot(), direct, 0), 0);
  EXPECT_EQ(pass->GetSilhouettes(), silhouettes) << "its own again";
  lines->SetDepthSourceToDepthBuffer();
  const Shot buffer = drawing.shoot();
  EXPECT_GT(differentPixels(buffer, direct), 300) << "not smooth";
  EXPECT_NEAR(double(whiteness(buffer)), double(whiteness(direct)), 0.35 * whiteness(direct));
  lines->SetDelegatePass(nullptr);
  Complaints complaints(lines);
  drawing.shoot();
  EXPECT_EQ(complaints.errors, 1);
}

TEST_F(PassSilhouettes, DoNotDisturbSelection)
{
  Drawing scene(width, height, false);
  vtkNew<vtkMoteSilhouettePass> lines;
  scene.renderer->SetPass(lines);
  auto left = scene.addParticles({{-0.7, 0, 0, 0.5}}, {1, 0, 0});
  scene.addTriangles({{0.7, 0, 0, 0.5}}, {0, 1, 0});
  scene.renderer->ResetCameraClippingRange();
  scene.shoot();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.renderer);
  selector->SetArea(0, 0, width - 1, height - 1);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  EXPECT_EQ(selection->GetNumberOfNodes(), 2u);
}
