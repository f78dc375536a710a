#include "WindowTestSupport.h"

#include "vtkAppendPolyData.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkLight.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <cstdlib>

namespace
{

/// X servers start anew when their last client leaves, and refuse others meanwhile. So one window
/// stays open between the tests.
class OpenWindow : public ::testing::Environment
{
public:
  void SetUp() override
  {
    m_window = vtkSmartPointer<vtkRenderWindow>::New();
    m_window->SetOffScreenRendering(1);
    m_window->SetSize(8, 8);
    m_window->Render();
  }
  void TearDown() override { m_window = nullptr; }

private:
  vtkSmartPointer<vtkRenderWindow> m_window;
};

[[maybe_unused]] const auto* const environment =
  ::testing::AddGlobalTestEnvironment(new OpenWindow);

} // namespace

namespace mote::testing
{

Shot read(vtkRenderWindow* window)
{
  Shot shot;
  shot.width = window->GetSize()[0];
  shot.height = window->GetSize()[1];
  vtkNew<vtkUnsignedCharArray> color;
  window->GetPixelData(0, 0, shot.width - 1, shot.height - 1, 0, color);
  shot.color.assign(color->GetPointer(0), color->GetPointer(0) + color->GetNumberOfValues());
  vtkNew<vtkFloatArray> depth;
  window->GetZbufferData(0, 0, shot.width - 1, shot.height - 1, depth);
  shot.depth.assign(depth->GetPointer(0), depth->GetPointer(0) + depth->GetNumberOfValues());
  return shot;
}

Shot shoot(vtkRenderWindow* window)
{
  window->Render();
  return read(window);
}

int differentPixels(const Shot& a, const Shot& b, int tolerance)
{
  if (a.width != b.width || a.height != b.height)
    return a.width * a.height + b.width * b.height;
  int sum = 0;
  for (std::size_t pixel = 0; pixel < a.color.size() / 3; ++pixel)
  {
    bool different = false;
    for (int k = 0; k < 3; ++k)
      different =
        different || std::abs(a.color[3 * pixel + k] - b.color[3 * pixel + k]) > tolerance;
    sum += different ? 1 : 0;
  }
  return sum;
}

void placeCamera(vtkCamera* camera)
{
  camera->SetPosition(0, 0, 10);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewAngle(2.0 * 180.0 / M_PI * std::atan(1.5 / 10.0));
  camera->SetParallelScale(1.5);
}

Drawing::Drawing(int width, int height, bool withPass)
{
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  window->AddRenderer(renderer);
  if (withPass)
    renderer->SetPass(pass);
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(3, 4, 5);
  renderer->AddLight(light);
  placeCamera(camera());
}

vtkCamera* Drawing::camera() const
{
  return renderer->GetActiveCamera();
}

vtkSmartPointer<vtkActor> Drawing::addParticles(const std::vector<Ball>& balls, const Point& color)
{
  vtkNew<vtkMoteParticleMapper> mapper;
  mapper->SetInputData(makeParticles(balls));
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  renderer->AddActor(actor);
  return actor;
}

vtkSmartPointer<vtkActor> Drawing::addTriangles(
  const std::vector<Ball>& balls, const Point& color, int resolution)
{
  vtkNew<vtkAppendPolyData> all;
  for (const Ball& ball : balls)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetCenter(ball.x, ball.y, ball.z);
    sphere->SetRadius(ball.r);
    sphere->SetThetaResolution(resolution);
    sphere->SetPhiResolution(resolution);
    all->AddInputConnection(sphere->GetOutputPort());
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(all->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  renderer->AddActor(actor);
  return actor;
}

void paint(vtkActor* actor, const Point& color)
{
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetAmbient(1);
  actor->GetProperty()->SetDiffuse(0);
}

} // namespace mote::testing
