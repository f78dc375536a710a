#include "RendererImage.h"

#include "SceneBridge.h"

#include "kernels/scene/RayCaster.h"

#include "vtkHardwareSelector.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <array>
#include <chrono>

namespace mote
{

bool RendererImage::trace(vtkRenderer* renderer, std::vector<vtkActor*> actors,
  FrameSettings settings, const Progress& progress)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  settings.interactive = window && window->GetDesiredUpdateRate() >= 1.0;
  int width = 0, height = 0, x = 0, y = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &x, &y);
  const bool shown = tracer_.trace(renderer, actors, width, height, settings,
    [&](double done)
    { return !(window && window->CheckAbortStatus()) && (!progress || progress(done)); });
  actors_ = actors;
  return shown;
}

void RendererImage::draw(vtkRenderer* renderer)
{
  const auto start = std::chrono::steady_clock::now();
  if (renderer->GetSelector())
    drawSelection(renderer);
  else
    display_.draw(renderer, tracer_.film(), tracer_.version());
  displaySeconds_ =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void RendererImage::drawSelection(vtkRenderer* renderer)
{
  vtkHardwareSelector* selector = renderer->GetSelector();
  const int pass = selector->GetCurrentPass();
  int width = 0, height = 0, x = 0, y = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &x, &y);
  std::vector<vtkActor*> actors = actors_;
  const Scene scene = sceneOf(renderer, actors);
  Film film;
  film.resize(width, height, Film::Id);
  RayCaster(scene).addSample(
    cameraOf(renderer, double(width) / height, width, height), film);

  std::vector<unsigned char> colors(4 * film.pixels(), 0);
  const std::uint64_t last = scene.particles.empty() ? 0 : film.pixels();
  std::uint64_t largest = 0;
  for (std::uint64_t i = 0; i < last; ++i)
  {
    if (film.object()[i] < 0)
      continue;
    // The selector takes 0 for "nothing here", so ids count from 1.
    const std::uint64_t id = film.id()[i] + 1;
    largest = std::max(largest, id);
    std::uint64_t code = 0;
    if (pass == vtkHardwareSelector::POINT_ID_LOW24)
      code = id & 0xffffff;
    else if (pass == vtkHardwareSelector::POINT_ID_HIGH24)
      code = (id >> 24) & 0xffffff;
    else if (pass == vtkHardwareSelector::ACTOR_PASS)
    {
      const float* prop = selector->GetPropColorValue();
      for (int c = 0; c < 3; ++c)
        code |= static_cast<std::uint64_t>(prop[c] * 255.0f + 0.5f) << (8 * c);
    }
    for (int c = 0; c < 3; ++c)
      colors[4 * i + c] = static_cast<unsigned char>((code >> (8 * c)) & 0xff);
    colors[4 * i + 3] = 255;
  }
  selector->UpdateMaximumPointId(static_cast<vtkIdType>(largest));
  display_.drawFlat(renderer, film, colors);
}

RendererImage& RendererImages::of(vtkRenderer* renderer)
{
  auto& image = images_[renderer];
  if (!image)
    image = std::make_unique<RendererImage>();
  return *image;
}

void RendererImages::release(vtkWindow* window)
{
  for (auto it = images_.begin(); it != images_.end();)
  {
    if (window && it->second->display().window() != window)
    {
      ++it;
      continue;
    }
    it->second->display().release(window);
    it = images_.erase(it);
  }
}

} // namespace mote
