// vtkMoteParticlePicker against closed formulas; it needs no display.
#include "VTKTestSupport.h"

#include "vtkCamera.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkMoteParticlePicker.h"
#include "vtkPropCollection.h"

#include <cmath>
#include <sstream>

using namespace mote::testing;

namespace
{

/// A window that is never opened: it lends the renderer its size.
struct Picking : ::testing::Test
{
  static constexpr int width = 120, height = 80;
  std::vector<Ball> balls = someBalls(50);
  vtkSmartPointer<vtkPolyData> data = makeParticles(balls);
  Stage stage{data};
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkMoteParticlePicker> picker;
  vtkCamera* camera = stage.renderer->GetActiveCamera();

  Picking()
  {
    window->SetSize(width, height);
    window->AddRenderer(stage.renderer);
    camera->SetPosition(4, 3, 5);
    stage.renderer->ResetCameraClippingRange();
  }

  void compare(
    const std::vector<Ball>& truth, int x0 = 0, int y0 = 0, int w = width, int h = height)
  {
    const TrueView view(camera, w, h);
    int picked = 0;
    for (int y = 0; y < h; y += 3)
      for (int x = 0; x < w; x += 3)
      {
        if (!view.isClear(x + 0.5, y + 0.5, truth, 0.05))
          continue;
        const auto hit = view.hit(x + 0.5, y + 0.5, truth);
        ASSERT_EQ(picker->Pick(x0 + x, y0 + y, 0, stage.renderer), hit ? 1 : 0) << x << " " << y;
        ASSERT_EQ(picker->GetParticleId(), hit ? hit->ball : -1);
        if (!hit)
          continue;
        ++picked;
        EXPECT_NEAR(picker->GetDistance(), hit->depth, 1e-4);
        for (int k = 0; k < 3; ++k)
        {
          EXPECT_NEAR(picker->GetPickPosition()[k], hit->position[k], 1e-4);
          EXPECT_NEAR(picker->GetPickNormal()[k], hit->normal[k], 2e-3);
        }
        EXPECT_EQ(picker->GetActor(), stage.actor.Get());
        EXPECT_EQ(picker->GetViewProp(), stage.actor.Get());
      }
    EXPECT_GT(picked, 20);
  }

  /// Whether the particle is found at its own place in the window.
  bool finds(int id)
  {
    const Ball& b = balls[id];
    stage.renderer->SetWorldPoint(b.x, b.y, b.z, 1);
    stage.renderer->WorldToDisplay();
    const double* place = stage.renderer->GetDisplayPoint();
    picker->Pick(std::floor(place[0]), std::floor(place[1]), 0, stage.renderer);
    return picker->GetParticleId() == id;
  }
};

} // namespace

TEST_F(Picking, NamesTheInputsParticle)
{
  compare(balls);
}

TEST_F(Picking, InParallelProjection)
{
  camera->ParallelProjectionOn();
  compare(balls);
}

TEST_F(Picking, InAViewportAwayFromTheCorner)
{
  stage.renderer->SetViewport(0.5, 0.25, 1, 1);
  compare(balls, 60, 20, 60, 60);
}

TEST_F(Picking, OnAMovedActor)
{
  stage.actor->SetPosition(0.3, 0.2, -0.1);
  stage.actor->SetScale(0.8);
  stage.actor->RotateWXYZ(40, 3, 1, 2);
  std::vector<Ball> moved;
  for (const Ball& b : balls)
  {
    const double in[4] = {b.x, b.y, b.z, 1};
    double out[4];
    stage.actor->GetMatrix()->MultiplyPoint(in, out);
    moved.push_back({out[0], out[1], out[2], 0.8 * b.r});
  }
  compare(moved);
}

TEST_F(Picking, OnAnUnevenlyScaledActor)
{
  stage.mapper->SetInputData(makeParticles({{0, 0, 0, 0.5}}));
  stage.actor->SetScale(2, 1, 0.5);
  camera->SetPosition(0, 0, 10);
  camera->ParallelProjectionOn();
  stage.renderer->ResetCameraClippingRange();
  // 80 pixels are 3 high: 0.9 to the right is still within, and so high only in the middle.
  EXPECT_EQ(picker->Pick(60 + 24, 40, 0, stage.renderer), 1);
  const double x = 24.5 / 80 * 3, y = 0.5 / 80 * 3;
  const double z = 0.25 * std::sqrt(1 - x * x - 4 * y * y);
  EXPECT_NEAR(picker->GetPickPosition()[0], x, 1e-4);
  EXPECT_NEAR(picker->GetPickPosition()[2], z, 1e-4);
  const Point normal = unit({x, 4 * y, 16 * z});
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(picker->GetPickNormal()[k], normal[k], 1e-3);
  EXPECT_EQ(picker->Pick(60, 40 + 24, 0, stage.renderer), 0);
  EXPECT_EQ(picker->GetParticleId(), -1);
  EXPECT_TRUE(std::isnan(picker->GetValue()));
  EXPECT_EQ(picker->GetActor(), nullptr);
}

TEST_F(Picking, GivesTheValueThatColours)
{
  std::vector<double> values;
  for (int i = 0; i < 50; ++i)
    values.push_back(1000 + i);
  addValues(data, "value", values);
  int found = 0;
  for (int id = 0; id < 50; ++id)
    if (finds(id))
    {
      ++found;
      EXPECT_EQ(picker->GetValue(), 1000 + id);
    }
  EXPECT_GT(found, 10);
  stage.mapper->ScalarVisibilityOff();
  for (int id = 0; id < 50; ++id)
    EXPECT_TRUE(!finds(id) || std::isnan(picker->GetValue()));
}

TEST_F(Picking, NearestOfSeveralActors)
{
  stage.mapper->SetInputData(makeParticles({{0, 0, 0, 0.5}}));
  Stage front(makeParticles({{9, 9, 9, 0.1}, {0.8, 0.6, 1, 0.2}})); // on the way to the first
  stage.renderer->AddActor(front.actor);
  stage.renderer->ResetCameraClippingRange();
  const int x = width / 2, y = height / 2;
  ASSERT_EQ(picker->Pick(x, y, 0, stage.renderer), 1);
  EXPECT_EQ(picker->GetActor(), front.actor.Get());
  EXPECT_EQ(picker->GetParticleId(), 1);
  front.actor->PickableOff();
  ASSERT_EQ(picker->Pick(x, y, 0, stage.renderer), 1);
  EXPECT_EQ(picker->GetActor(), stage.actor.Get());
  front.actor->PickableOn();
  front.actor->VisibilityOff();
  ASSERT_EQ(picker->Pick(x, y, 0, stage.renderer), 1);
  EXPECT_EQ(picker->GetActor(), stage.actor.Get());
  front.actor->VisibilityOn();
  picker->PickFromListOn();
  EXPECT_EQ(picker->Pick(x, y, 0, stage.renderer), 0);
  picker->AddPickList(stage.actor);
  ASSERT_EQ(picker->Pick(x, y, 0, stage.renderer), 1);
  EXPECT_EQ(picker->GetActor(), stage.actor.Get());
}

TEST_F(Picking, SeesThroughHiddenParticles)
{
  stage.mapper->SetInputData(makeParticles({{0, 0, 0, 0.5}, {0.8, 0.6, 1, 0.2}}));
  addValues(stage.mapper->GetInput(), "value", {1, 2});
  const int x = width / 2, y = height / 2;
  ASSERT_EQ(picker->Pick(x, y, 0, stage.renderer), 1);
  EXPECT_EQ(picker->GetParticleId(), 1);
  stage.mapper->UseVisibilityRangeOn();
  stage.mapper->SetVisibilityRange(0, 1);
  ASSERT_EQ(picker->Pick(x, y, 0, stage.renderer), 1);
  EXPECT_EQ(picker->GetParticleId(), 0);
}

TEST_F(Picking, WithoutWhatItNeeds)
{
  Complaints complaints(picker);
  EXPECT_EQ(picker->Pick(1, 1, 0, nullptr), 0);
  EXPECT_EQ(complaints.errors, 1);
  vtkNew<vtkRenderer> noWindow;
  noWindow->AddActor(stage.actor);
  EXPECT_EQ(picker->Pick(0, 0, 0, noWindow), 0);
}

TEST_F(Picking, WithACameraWithoutDirection)
{
  Complaints complaints(picker);
  camera->SetPosition(0, 0, 10);
  camera->SetViewUp(0, 0, 1);
  EXPECT_EQ(picker->Pick(width / 2, height / 2, 0, stage.renderer), 0);
  EXPECT_EQ(complaints.errors, 1);
}

TEST_F(Picking, FiresEventsAndPrints)
{
  struct Counter
  {
    int starts = 0, picks = 0, ends = 0;
    void count(vtkObject*, unsigned long event, void*)
    {
      ++(event == vtkCommand::StartPickEvent ? starts
         : event == vtkCommand::PickEvent    ? picks
                                             : ends);
    }
  } counter;
  picker->AddObserver(vtkCommand::StartPickEvent, &counter, &Counter::count);
  picker->AddObserver(vtkCommand::PickEvent, &counter, &Counter::count);
  picker->AddObserver(vtkCommand::EndPickEvent, &counter, &Counter::count);
  picker->Pick(0, 0, 0, stage.renderer);
  EXPECT_EQ(counter.starts, 1);
  EXPECT_EQ(counter.picks, 0);
  EXPECT_EQ(counter.ends, 1);
  std::ostringstream text;
  picker->Print(text);
  EXPECT_NE(text.str().find("ParticleId: -1"), std::string::npos);
}
