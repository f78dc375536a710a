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
  picksCells_ = !props.empty() && props.front()->picksCells();
  if (renderer->GetSelector())
    settings.channels |= Film::Id;
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
    drawSelection(renderer, picksCells_);
  else
    display_.draw(renderer, tracer_.film(), tracer_.silhouettes(), tracer_.ghosts(),
      tracer_.version(),
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

namespace
{

/// What the selector asks of each pixel in a pass.
struct SelectionPass
{
  SelectionPass(vtkHardwareSelector* selector, bool picksCells)
  {
    const int pass = selector->GetCurrentPass();
    isFlat = pass == vtkHardwareSelector::ACTOR_PASS || pass == vtkHardwareSelector::PROCESS_PASS;
    isLow = pass ==
            (picksCells ? vtkHardwareSelector::CELL_ID_LOW24 : vtkHardwareSelector::POINT_ID_LOW24);
    isHigh = pass == (picksCells ? vtkHardwareSelector::CELL_ID_HIGH24
                                 : vtkHardwareSelector::POINT_ID_HIGH24);
    for (int c = 0; isFlat && c < 3; ++c)
      flat[c] = static_cast<unsigned char>(selector->GetPropColorValue()[c] * 255.0f + 0.5f);
  }

  /// Writes three bytes of an id.
  void write(std::uint64_t id, unsigned char* to) const
  {
    const std::uint64_t part = isLow ? id & 0xffffff : id >> 24;
    for (int c = 0; c < 3; ++c)
      to[c] = isFlat ? flat[c] : isLow || isHigh ? static_cast<unsigned char>(part >> 8 * c) : 0;
    to[3] = 255;
  }

  bool isFlat, isLow, isHigh;
  unsigned char flat[3] = {0, 0, 0};
};

} // namespace

void RendererImage::drawSelection(vtkRenderer* renderer, bool picksCells)
{
  vtkHardwareSelector* selector = renderer->GetSelector();
  selector->BeginRenderProp(); // sets the colour that stands for the prop
  const SelectionPass pass(selector, picksCells);
  const Film& film = tracer_.film();
  const GhostPixels& ghosts = tracer_.ghosts();
  std::vector<unsigned char> colors(4 * film.pixels(), 0);
  std::uint64_t greatest = 0;
  for (std::size_t i = 0; i < film.pixels(); ++i)
  {
    const std::uint64_t id = film.has(Film::Id) ? film.id()[i] : Film::noId;
    if (!std::isfinite(film.depth()[i]) || ghosts[i] || (id == Film::noId && !pass.isFlat))
      continue;
    pass.write(id, &colors[4 * i]);
    if (id == Film::noId)
      continue; // of clouds
    greatest = std::max(greatest, id);
  }
  // Whether there is a pass for the higher bits is decided by this.
  if (pass.isLow && picksCells)
    selector->UpdateMaximumCellId(static_cast<vtkIdType>(greatest));
  else if (pass.isLow)
    selector->UpdateMaximumPointId(static_cast<vtkIdType>(greatest));
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
