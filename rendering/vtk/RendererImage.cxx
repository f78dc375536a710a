#include "RendererImage.h"

#include "vtkHardwareSelector.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace mote
{

bool RendererImage::render(vtkObject* owner, vtkRenderer* renderer, const MoteProps& props,
  const FrameSettings& settings, const Progress& progress, bool translucent)
{
  shown_ = this->trace(renderer, props, settings, progress);
  if (shown_)
    this->draw(renderer, translucent);
  if (!problem_.empty() && problem_ != reported_)
    vtkErrorWithObjectMacro(owner, << problem_);
  reported_ = problem_;
  return shown_;
}

bool RendererImage::trace(
  vtkRenderer* renderer, MoteProps props, FrameSettings settings, const Progress& progress)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  // Drawing the picture takes its part of a frame, too.
  settings.frameTime = std::max(0.25 * settings.frameTime, settings.frameTime - displaySeconds_);
  settings.interactive = window && window->GetDesiredUpdateRate() >= 1.0;
  int width = 0, height = 0, x = 0, y = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &x, &y);
  problem_.clear();
  interrupted_ = false;
  ended_ = std::any_of(props.begin(), props.end(), [](const auto& p) { return p->isVolume(); });
  try
  {
    WindowDepth others;
    if (ended_)
    {
      others = depthReader_.read(renderer);
      settings.others = &others;
    }
    return tracer_.trace(renderer, props, width, height, settings,
      [&](double done)
      {
        interrupted_ = (window && window->CheckAbortStatus()) || (progress && !progress(done));
        return !interrupted_;
      });
  }
  catch (const std::exception& error)
  {
    problem_ = error.what();
    interrupted_ = true;
    return false;
  }
}

void RendererImage::draw(vtkRenderer* renderer, bool translucent)
{
  const auto start = std::chrono::steady_clock::now();
  if (renderer->GetSelector())
    drawSelection(renderer);
  else
    display_.draw(renderer, tracer_.film(), tracer_.silhouettes(), tracer_.version(),
      ended_        ? FilmDisplay::Way::Over
      : translucent ? FilmDisplay::Way::Translucent
                    : FilmDisplay::Way::Opaque);
  displaySeconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void RendererImage::release(vtkWindow* window)
{
  display_.release(window);
  depthReader_.release(window);
}

void RendererImage::drawSelection(vtkRenderer* renderer)
{
  vtkHardwareSelector* selector = renderer->GetSelector();
  selector->BeginRenderProp(); // sets the colour that stands for the prop
  unsigned char code[4] = {0, 0, 0, 255};
  if (selector->GetCurrentPass() == vtkHardwareSelector::ACTOR_PASS)
    for (int c = 0; c < 3; ++c)
      code[c] = static_cast<unsigned char>(selector->GetPropColorValue()[c] * 255.0f + 0.5f);
  const Film& film = tracer_.film();
  std::vector<unsigned char> colors(4 * film.pixels(), 0);
  for (std::size_t i = 0; i < film.pixels(); ++i)
    if (std::isfinite(film.depth()[i]))
      std::copy_n(code, 4, &colors[4 * i]);
  display_.drawFlat(renderer, film, colors);
  selector->EndRenderProp();
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
    it->second->release(window);
    it = images_.erase(it);
  }
}

} // namespace mote
