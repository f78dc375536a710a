// What vtkMoteRayCastPass shows and says while a structure is built on another thread.
#include "WindowTestSupport.h"

#include "vtkProperty.h"

#include <chrono>
#include <thread>

using namespace mote::testing;

namespace
{

std::vector<Ball> manyBalls()
{
  std::vector<Ball> balls = someBalls(150000);
  for (Ball& ball : balls)
    ball.r *= 0.05;
  return balls;
}

struct PassPreview : ::testing::Test
{
  Drawing drawing;
  vtkSmartPointer<vtkActor> actor = drawing.addParticles(manyBalls(), {1, 0.7, 0.4});
  vtkMoteParticleMapper* mapper = vtkMoteParticleMapper::SafeDownCast(actor->GetMapper());
  vtkMoteRayCastPass* pass = drawing.pass;

  PassPreview()
  {
    drawing.renderer->ResetCameraClippingRange(); // which builds
    mapper->PreviewOn();
    mapper->SetPreviewSize(1000);
  }

  /// Frames until one is exact; false after a minute.
  bool drawUntilExact()
  {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (!pass->IsConverged() && std::chrono::steady_clock::now() < end)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      drawing.window->Render();
    }
    return pass->IsConverged();
  }
};

} // namespace

TEST_F(PassPreview, SaysSoUntilThePictureIsExact)
{
  const Shot before = drawing.shoot();
  EXPECT_FALSE(pass->IsPreview());
  EXPECT_TRUE(pass->IsConverged());
  // The same particles again; a frame or more of them may be a preview.
  Shot preview;
  for (int i = 0; i < 50 && !pass->IsPreview(); ++i)
  {
    mapper->StopBuild();
    mapper->SetRadiusScale(i % 2 == 0 ? 0.5 : 1.0);
    preview = drawing.shoot();
  }
  ASSERT_TRUE(pass->IsPreview());
  EXPECT_FALSE(pass->IsConverged());
  EXPECT_EQ(pass->GetNumberOfSamples(), 4);
  EXPECT_GT(differentPixels(before, preview), 1000);
  mapper->SetRadiusScale(1.0);
  drawing.window->Render();
  ASSERT_TRUE(drawUntilExact());
  EXPECT_FALSE(pass->IsPreview());
  EXPECT_EQ(differentPixels(before, read(drawing.window), 0), 0);
}

TEST_F(PassPreview, CoversWhatTheWholeCovers)
{
  // A cloud of particles, seen as one: enlarged they hide about as much of the background.
  const auto covered = [](const Shot& shot)
  {
    int count = 0;
    for (const float depth : shot.depth)
      count += depth < 1.0f;
    return count;
  };
  mapper->SetRadiusScale(2.0);
  Shot preview;
  for (int i = 0; i < 50 && !pass->IsPreview(); ++i)
  {
    mapper->SetRadiusScale(2.0 + 1e-6 * i);
    preview = drawing.shoot();
  }
  ASSERT_TRUE(pass->IsPreview());
  ASSERT_TRUE(drawUntilExact());
  const double exact = covered(drawing.shoot());
  EXPECT_GT(exact, 1000);
  EXPECT_NEAR(covered(preview), exact, 0.25 * exact);
}
