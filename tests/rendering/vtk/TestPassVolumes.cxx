// Volumes in a window: where rays end at ordinary props, what is written, and when it is traced.
#include "VolumeTestSupport.h"
#include "WindowTestSupport.h"

#include "vtkCamera.h"
#include "vtkContourValues.h"
#include "vtkImageData.h"
#include "vtkLineSource.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <cmath>

using namespace mote::testing;

namespace
{

/// A view: projection, whether the pass is used, and samples that the window has for a pixel.
struct Mode
{
  bool parallel;
  bool pass;
  int samples = 0;
};

double one(const Point&)
{
  return 1.0;
}

class Volumes : public ::testing::TestWithParam<Mode>
{
protected:
  static constexpr int width = 80, height = 60;

  Volumes()
    : box(makeBox(3, one))
  {
    drawing.window->SetMultiSamples(GetParam().samples);
    drawing.pass->SetSamplesPerPixel(1);
    drawing.camera()->SetParallelProjection(GetParam().parallel);
    box.paint({1, 0, 0}, 0.6);
    drawing.renderer->AddVolume(box.volume);
  }
  Shot shoot()
  {
    drawing.renderer->ResetCameraClippingRange();
    return drawing.shoot();
  }

  Drawing drawing{width, height, GetParam().pass};
  VolumeProp box;
};

INSTANTIATE_TEST_SUITE_P(Modes, Volumes,
  ::testing::Values(Mode{false, true}, Mode{false, false}, Mode{true, true}, Mode{true, false},
    Mode{false, true, 4}, Mode{true, false, 4}),
  [](const auto& info)
  {
    return std::string(info.param.parallel ? "Parallel" : "Perspective") +
           (info.param.pass ? "Pass" : "Alone") + (info.param.samples ? "Samples" : "");
  });

/// Away from edges of depth.
bool isInner(const Shot& shot, int x, int y)
{
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
    {
      const int i = x + dx, j = y + dy;
      if (i < 0 || j < 0 || i >= shot.width || j >= shot.height ||
          (shot.depthAt(i, j) < 1) != (shot.depthAt(x, y) < 1))
        return false;
    }
  return true;
}

bool isInner(const TrueView& view, double x, double y)
{
  for (const double dx : {-1.0, 1.0})
    for (const double dy : {-1.0, 1.0})
      if ((chord(view, x + dx, y + dy) > 0.0) != (chord(view, x, y) > 0.0))
        return false;
  return true;
}

/// What the box covers before the first of the balls.
double redOf(const TrueView& view, double x, double y, const std::vector<Ball>& balls)
{
  const auto hit = view.hit(x, y, balls);
  return covered(
    0.6, chord(view, x, y, {0, 0, 0}, hit ? hit->depth : std::numeric_limits<double>::infinity()));
}

vtkSmartPointer<vtkActor> addPlane(Drawing& drawing, double z, const Point& color)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-5, -5, z);
  plane->SetPoint1(5, -5, z);
  plane->SetPoint2(-5, 5, z);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  paint(actor, color);
  drawing.renderer->AddActor(actor);
  return actor;
}

} // namespace

TEST_P(Volumes, EndAtWhatStandsInThem)
{
  // A ball half inside, one before and one behind the box.
  const std::vector<Ball> balls{{0.1, 0, 0.4, 0.5}, {-0.7, 0.6, 1.6, 0.2}, {0.6, -0.6, -1.8, 0.4}};
  paint(drawing.addTriangles(balls, {0, 0, 1}, 300), {0, 0, 1});
  const Shot shot = shoot();
  box.volume->VisibilityOff();
  const Shot empty = drawing.shoot();
  box.volume->VisibilityOn();
  const TrueView view(drawing.camera(), width, height);
  int seen[4] = {};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
    {
      if (!isInner(empty, x, y) || !isInner(view, x + 0.5, y + 0.5) ||
          !view.isClear(x + 0.5, y + 0.5, balls, 1.0))
        continue;
      const auto hit = view.hit(x + 0.5, y + 0.5, balls);
      // Of a ball that has triangles, up to 1e-4 beneath it. Where there are several samples, of
      // the window or of the film, they are up to half a pixel away.
      const bool exact = GetParam().pass && GetParam().samples == 0;
      double least = 255, most = 0;
      for (const double dx : {-0.5, 0.0, 0.5})
        for (const double dy : {-0.5, 0.0, 0.5})
          if (!exact || (dx == 0.0 && dy == 0.0))
          {
            const double red = 255 * redOf(view, x + 0.5 + dx, y + 0.5 + dy, balls);
            least = std::min(least, red);
            most = std::max(most, red);
          }
      EXPECT_GE(shot.at(x, y)[0], least - 1.5) << x << " " << y;
      EXPECT_LE(shot.at(x, y)[0], most + 1.5) << x << " " << y;
      EXPECT_NEAR(shot.at(x, y)[2], hit ? 255 - shot.at(x, y)[0] : 0, 1.5) << x << " " << y;
      EXPECT_EQ(shot.depthAt(x, y), empty.depthAt(x, y)) << "a cloud writes no depth";
      ++seen[hit ? hit->ball : 3];
    }
  for (const int number : seen)
    EXPECT_GT(number, 4);
}

TEST_P(Volumes, WindowShowsWhatIsTracedWithoutOne)
{
  drawing.addParticles({{0.3, 0.2, 0.5, 0.4}}, {0, 1, 0});
  const Shot shot = shoot();
  if (!GetParam().pass)
    return; // alone, they take other samples
  const Picture picture = trace(drawing.renderer, width, height);
  int different = 0;
  for (int i = 0; i < picture.count(); ++i)
    for (int k = 0; k < 3; ++k)
      different += std::abs(shot.color[3 * i + k] - 255 * picture.color(i)[k]) > 1.01 ? 1 : 0;
  EXPECT_EQ(different, 0);
}

TEST_P(Volumes, SurfacesWriteTheirDepth)
{
  box.mapper->SetInputData(makeBox(4, [](const Point& p) { return p[2]; }));
  box.property()->GetIsoSurfaceValues()->SetValue(0, 0.25);
  box.mapper->ShowIsoSurfacesOn();
  const Shot shot = shoot();
  const TrueView view(drawing.camera(), width, height);
  // A ball whose top touches the surface is where the depth must be.
  const std::vector<Ball> ball{{0, 0, -1e3 + 0.25, 1e3}};
  int surface = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (std::abs(x - width / 2) < 12 && std::abs(y - height / 2) < 12)
      {
        const auto hit = view.hit(x + 0.5, y + 0.5, ball);
        EXPECT_NEAR(shot.depthAt(x, y), hit->window, 2e-3);
        surface += shot.depthAt(x, y) < 1 ? 1 : 0;
      }
      else if (!isInner(view, x + 0.5, y + 0.5))
        continue;
      else if (chord(view, x + 0.5, y + 0.5) == 0.0)
      {
        EXPECT_EQ(shot.depthAt(x, y), 1);
      }
  EXPECT_EQ(surface, 23 * 23);
  // What VTK draws later is hidden by it or hides it.
  box.mapper->ShowCloudOff();
  auto glass = addPlane(drawing, 0.5, {0, 1, 0});
  glass->GetProperty()->SetOpacity(0.5);
  box.property()->SetAmbient(1);
  box.property()->SetDiffuse(0);
  box.property()->SetSpecular(0);
  const Shot before = shoot();
  glass->SetPosition(0, 0, -0.5);
  const Shot behind = shoot();
  if (GetParam().pass)
  {
    EXPECT_NEAR(before.at(width / 2, height / 2)[0], 128, 2);
    EXPECT_NEAR(before.at(width / 2, height / 2)[1], 128, 2);
  }
  EXPECT_NEAR(behind.at(width / 2, height / 2)[0], 255, 1);
  EXPECT_NEAR(behind.at(width / 2, height / 2)[1], 0, 1);
}

TEST_P(Volumes, StayInTheirViewport)
{
  paint(drawing.addTriangles({{0, 0, 0, 0.5}}, {0, 0, 1}, 100), {0, 0, 1});
  drawing.window->SetSize(2 * width, 2 * height);
  drawing.renderer->SetViewport(0.5, 0.5, 1, 1);
  const Shot corner = shoot();
  drawing.window->SetSize(width, height);
  drawing.renderer->SetViewport(0, 0, 1, 1);
  const Shot whole = shoot();
  int different = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
    {
      different += corner.at(width + x, height + y)[0] != whole.at(x, y)[0] ||
                   corner.at(width + x, height + y)[2] != whole.at(x, y)[2];
      EXPECT_EQ(corner.at(x, y)[0], 0);
    }
  EXPECT_LE(different, 2);
}

TEST_P(Volumes, LieOverOpaqueAndUnderTranslucentProps)
{
  addPlane(drawing, -1.5, {0, 0, 1});
  auto glass = addPlane(drawing, 1.5, {0, 1, 0});
  glass->GetProperty()->SetOpacity(0.5);
  const Shot shot = shoot();
  const TrueView view(drawing.camera(), width, height);
  const double red = covered(0.6, chord(view, width / 2 + 0.5, height / 2 + 0.5));
  const unsigned char* c = shot.at(width / 2, height / 2);
  if (GetParam().pass)
  {
    EXPECT_NEAR(c[0], 128 * red, 2);
    EXPECT_NEAR(c[1], 128, 2);
    EXPECT_NEAR(c[2], 128 * (1 - red), 2);
  }
  else
  {
    // VTK draws volumes after all that is translucent.
    EXPECT_NEAR(c[0], 255 * red, 2);
    EXPECT_NEAR(c[1], 128 * (1 - red), 2);
  }
}

TEST(VolumesPassOrNone, GiveTheSamePicture)
{
  for (const bool parallel : {false, true})
  {
    Drawing with(120, 90, true), without(120, 90, false);
    std::vector<VolumeProp> boxes(2);
    std::size_t next = 0;
    for (Drawing* d : {&with, &without})
    {
      VolumeProp& box = boxes[next++];
      box.mapper->SetInputData(makeBox(4, [](const Point& p) { return p[0] + p[1]; }));
      vtkNew<vtkPiecewiseFunction> opacity;
      opacity->AddPoint(-1, 0);
      opacity->AddPoint(2, 0.9);
      box.property()->SetScalarOpacity(opacity);
      d->renderer->AddVolume(box.volume);
      d->addTriangles({{0.2, 0.1, 0.3, 0.5}}, {0, 0, 1});
      d->camera()->SetParallelProjection(parallel);
      d->camera()->Azimuth(30);
      d->renderer->ResetCameraClippingRange();
      d->pass->SetSamplesPerPixel(4);
    }
    EXPECT_LE(differentPixels(with.shoot(), without.shoot()), 0);
  }
}

namespace
{

struct VolumeFrames : ::testing::Test
{
  Drawing drawing{64, 48};
  VolumeProp box{makeBox(3, one)};
  vtkSmartPointer<vtkActor> ball = drawing.addTriangles({{0, 0, 0, 0.3}}, {0, 0, 1});

  VolumeFrames()
  {
    drawing.pass->SetSamplesPerPixel(1);
    drawing.renderer->AddVolume(box.volume);
    drawing.camera()->SetClippingRange(5, 15);
    EXPECT_TRUE(traced());
    EXPECT_FALSE(traced());
  }
  bool traced()
  {
    drawing.window->Render();
    return drawing.pass->GetNumberOfRays() > 0;
  }
};

} // namespace

TEST_F(VolumeFrames, TracedAgainWhereAPropMoves)
{
  ball->SetPosition(0.4, 0, 0);
  EXPECT_TRUE(traced());
  EXPECT_FALSE(traced());
  ball->GetProperty()->SetColor(1, 1, 0);
  EXPECT_FALSE(traced()) << "it still stands where it stood";
}

TEST_F(VolumeFrames, TracedAgainWhereThePropertyChanges)
{
  const auto expect = [&](const char* what)
  {
    EXPECT_TRUE(traced()) << what;
    EXPECT_FALSE(traced()) << what;
  };
  box.property()->GetScalarOpacity()->AddPoint(3, 0.2);
  expect("a point of the opacities");
  box.property()->SetScalarOpacityUnitDistance(2);
  expect("unit distance");
  box.property()->SetDiffuse(0.4);
  expect("material");
  box.mapper->ShowIsoSurfacesOn();
  expect("iso-surfaces");
  box.property()->GetIsoSurfaceValues()->SetValue(0, 0.5);
  expect("iso-value");
  box.volume->SetPosition(0, 0.1, 0);
  expect("place");
  box.mapper->SetSampleDistance(0.1);
  expect("mapper");
  box.mapper->GetInput()->GetPointData()->GetScalars()->Modified();
  box.mapper->GetInput()->Modified();
  expect("scalars");
}

TEST_F(VolumeFrames, MovingViewsAreCoarser)
{
  drawing.pass->SetInteractiveFrameTime(0.001);
  drawing.window->SetSize(400, 300);
  drawing.window->SetDesiredUpdateRate(15);
  for (int i = 0; i < 3; ++i)
  {
    drawing.camera()->Azimuth(1);
    drawing.window->Render();
  }
  EXPECT_GT(drawing.pass->GetImageSampleDistance(), 1.0);
  EXPECT_FALSE(drawing.pass->IsConverged());
  drawing.window->SetDesiredUpdateRate(0.001);
  const Shot fine = drawing.shoot();
  EXPECT_EQ(drawing.pass->GetImageSampleDistance(), 1.0);
  EXPECT_TRUE(drawing.pass->IsConverged());
  EXPECT_GT(fine.at(120, 150)[0], 50);
}

TEST_F(VolumeFrames, ThinLinesStayBeforeCoarseSurfaces)
{
  ball->VisibilityOff();
  box.mapper->SetInputData(makeBox(3, [](const Point& p) { return p[2]; }));
  box.mapper->ShowIsoSurfacesOn();
  box.property()->GetIsoSurfaceValues()->SetValue(0, 0.0);
  vtkNew<vtkLineSource> line;
  line->SetPoint1(-0.9, -0.6, 1.2);
  line->SetPoint2(0.9, 0.5, 1.2);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(line->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0, 1, 0);
  actor->GetProperty()->LightingOff();
  drawing.renderer->AddActor(actor);
  drawing.window->SetSize(400, 300);
  const auto greenPixels = [](const Shot& shot)
  {
    int count = 0;
    for (int y = 0; y < shot.height; ++y)
      for (int x = 0; x < shot.width; ++x)
        count += shot.at(x, y)[1] > 200 && shot.at(x, y)[0] < 50;
    return count;
  };
  const int fine = greenPixels(drawing.shoot());
  ASSERT_GT(fine, 60);
  drawing.pass->SetInteractiveFrameTime(0.001);
  drawing.pass->SetMostDistance(2);
  drawing.window->SetDesiredUpdateRate(15);
  for (int i = 0; i < 3; ++i)
  {
    drawing.camera()->Azimuth(0.1);
    drawing.window->Render();
  }
  ASSERT_GT(drawing.pass->GetImageSampleDistance(), 1.0);
  EXPECT_GE(greenPixels(read(drawing.window)), 0.95 * fine);
}

TEST_F(VolumeFrames, ProgressivePicturesEndAtProps)
{
  drawing.pass->SetSamplesPerPixel(8);
  drawing.pass->SetInteractiveFrameTime(0.001);
  drawing.pass->ProgressiveOn();
  int frames = 0;
  do
    drawing.window->Render();
  while (!drawing.pass->IsConverged() && ++frames < 50);
  const Shot bitByBit = read(drawing.window);
  drawing.pass->ProgressiveOff();
  drawing.camera()->Azimuth(1);
  drawing.window->Render();
  drawing.camera()->Azimuth(-1);
  EXPECT_LE(differentPixels(bitByBit, drawing.shoot()), 2);
}
