// vtkMoteAreaPicker against particles one by one; and volumes by vtkMoteParticlePicker. They need
// no display.
#include "VTKTestSupport.h"
#include "VolumeTestSupport.h"

#include "vtkCamera.h"
#include "vtkDoubleArray.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkIdTypeArray.h"
#include "vtkMoteAreaPicker.h"
#include "vtkMoteParticlePicker.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"

#include <cmath>
#include <set>
#include <sstream>

using namespace mote::testing;

namespace
{

struct AreaPicking : ::testing::Test
{
  static constexpr int width = 120, height = 80;
  std::vector<Ball> balls = someBalls(200);
  vtkSmartPointer<vtkPolyData> data = makeParticles(balls);
  Stage stage{data};
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkMoteAreaPicker> picker;
  vtkCamera* camera = stage.renderer->GetActiveCamera();

  AreaPicking()
  {
    window->SetSize(width, height);
    window->AddRenderer(stage.renderer);
    camera->SetPosition(4, 3, 5);
    stage.renderer->ResetCameraClippingRange();
  }

  std::set<vtkIdType> found() const
  {
    std::set<vtkIdType> all;
    for (int i = 0; i < picker->GetNumberOfProps(); ++i)
    {
      EXPECT_EQ(picker->GetProp(i), stage.actor.Get());
      vtkIdTypeArray* ids = picker->GetParticles(i);
      for (vtkIdType k = 0; k < ids->GetNumberOfValues(); ++k)
        EXPECT_TRUE(all.insert(ids->GetValue(k)).second);
    }
    return all;
  }
};

} // namespace

TEST_F(AreaPicking, FindsWhatIsSeenInTheRectangleAlone)
{
  picker->SetSamplesPerPixel(1);
  const int x0 = 40, y0 = 20, x1 = 75, y1 = 55;
  const vtkIdType count = picker->Pick(x1, y0, x0, y1, stage.renderer); // any opposite corners
  EXPECT_EQ(count, static_cast<vtkIdType>(found().size()));
  const std::set<vtkIdType> seen = found();
  vtkNew<vtkMoteParticlePicker> one;
  std::set<vtkIdType> truth;
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x)
      if (one->Pick(x, y, 0, stage.renderer))
        truth.insert(one->GetParticleId());
  EXPECT_GT(truth.size(), 20u);
  EXPECT_EQ(seen, truth);
}

TEST_F(AreaPicking, GoesThroughWhereAsked)
{
  for (const bool parallel : {false, true})
  {
    camera->SetParallelProjection(parallel);
    picker->ThroughOn();
    picker->Pick(30, 10, 80, 60, stage.renderer);
    std::set<vtkIdType> truth;
    for (std::size_t i = 0; i < balls.size(); ++i)
    {
      stage.renderer->SetWorldPoint(balls[i].x, balls[i].y, balls[i].z, 1);
      stage.renderer->WorldToDisplay();
      const double* place = stage.renderer->GetDisplayPoint();
      if (place[0] - 0.5 >= 30 && place[0] - 0.5 <= 80 && place[1] - 0.5 >= 10 &&
          place[1] - 0.5 <= 60)
        truth.insert(static_cast<vtkIdType>(i));
    }
    EXPECT_GT(truth.size(), 20u);
    EXPECT_EQ(found(), truth);
  }
}

TEST_F(AreaPicking, FindsParticlesByTheirImages)
{
  const double vectors[9] = {4.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  stage.mapper->SetReplication(2, 1, 1);
  stage.mapper->SetReplicationVectors(vectors);
  camera->SetPosition(2, 0, 30);
  camera->SetFocalPoint(2, 0, 0);
  stage.renderer->ResetCameraClippingRange();
  for (const bool through : {false, true})
  {
    picker->SetThrough(through);
    const vtkIdType left = picker->Pick(0, 0, width / 2, height, stage.renderer);
    const std::set<vtkIdType> ofLeft = found();
    EXPECT_GT(left, 20);
    picker->Pick(width / 2, 0, width, height, stage.renderer);
    EXPECT_GT(found().size(), 20u);
    picker->Pick(0, 0, width, height, stage.renderer);
    EXPECT_GE(found().size(), ofLeft.size());
    if (through)
    {
      EXPECT_EQ(found().size(), balls.size());
    }
  }
}

TEST_F(AreaPicking, FindsNothingThatIsHiddenByRange)
{
  stage.mapper->SetCenterRange(0, 0.0, 10.0);
  for (const bool through : {false, true})
  {
    picker->SetThrough(through);
    EXPECT_GT(picker->Pick(0, 0, width, height, stage.renderer), 10);
    for (const vtkIdType id : found())
      EXPECT_GE(balls[static_cast<std::size_t>(id)].x, 0.0);
  }
  stage.mapper->SetCenterRange(0, 100.0, 101.0);
  EXPECT_EQ(picker->Pick(0, 0, width, height, stage.renderer), 0);
  EXPECT_EQ(picker->GetNumberOfProps(), 0);
  EXPECT_EQ(picker->GetProp(0), nullptr);
  EXPECT_EQ(picker->GetParticles(-1), nullptr);
  std::ostringstream text;
  picker->Print(text);
  EXPECT_NE(text.str().find("Through"), std::string::npos);
}

TEST(CloudPicking, NamesTheCellThatKeepsBackMost)
{
  // Opaque where the value is near 0.5 in z, and clear elsewhere.
  constexpr int n = 8;
  VolumeStage stage(makeBox(n, [](const Point& p) { return p[2]; }), true);
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const auto& [value, alpha] : {std::pair{0.3, 0.0}, {0.5, 0.9}, {0.7, 0.0}})
    opacity->AddPoint(value, alpha);
  stage.property()->SetScalarOpacity(opacity);
  stage.property()->SetScalarOpacityUnitDistance(0.05);
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetSize(32, 32);
  window->AddRenderer(stage.renderer);
  stage.renderer->ResetCameraClippingRange();
  vtkNew<vtkMoteParticlePicker> picker;
  EXPECT_EQ(picker->Pick(16, 16, 0, stage.renderer), 0); // is looked through
  picker->PickCloudsOn();
  int picked = 0;
  for (int y = 0; y < 32; y += 3)
    for (int x = 0; x < 32; x += 3)
    {
      const double px = 3.0 * (x + 0.5) / 32 - 1.5, py = 3.0 * (y + 0.5) / 32 - 1.5;
      const bool isInside = std::abs(px) < 1.0 && std::abs(py) < 1.0;
      ASSERT_EQ(picker->Pick(x, y, 0, stage.renderer), isInside ? 1 : 0) << x << " " << y;
      if (!isInside)
        continue;
      ++picked;
      const double* at = picker->GetPickPosition();
      EXPECT_NEAR(at[0], px, 1e-3);
      EXPECT_NEAR(at[1], py, 1e-3);
      EXPECT_NEAR(at[2], 0.5, 0.2);
      EXPECT_NEAR(picker->GetValue(), at[2], 1e-3);
      EXPECT_GT(picker->GetCloudOpacity(), 0.5);
      double bounds[6];
      vtkUnstructuredGrid::SafeDownCast(stage.mapper->GetInputDataObject(0, 0))
        ->GetCellBounds(picker->GetCellId(), bounds);
      for (int axis = 0; axis < 3; ++axis)
      {
        EXPECT_GE(at[axis], bounds[2 * axis] - 1e-6);
        EXPECT_LE(at[axis], bounds[2 * axis + 1] + 1e-6);
      }
    }
  EXPECT_GT(picked, 30);
}
