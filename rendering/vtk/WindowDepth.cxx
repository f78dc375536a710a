#include "vtk_glew.h" // before all other OpenGL headers

#include "WindowDepth.h"

#include "DepthScale.h"

#include "kernels/core/Error.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace mote
{

namespace
{

/// The pixels, of so many, that one of fewer covers, and three at the least, of which a thin line
/// is the lesser part; of an image that is not coarser the one at its middle. The first, and after
/// the last.
std::pair<int, int> spanOf(int pixel, int count, int newCount)
{
  const auto at = [&](double p) { return static_cast<int>(p * count / newCount); };
  const int middle = at(pixel + 0.5);
  if (newCount >= count)
    return {middle, middle + 1};
  const int first = at(pixel), last = at(pixel + 1);
  return last - first >= 3 ? std::pair(first, last)
                           : std::pair(std::max(middle - 1, 0), std::min(middle + 2, count));
}

} // namespace

std::vector<float> WindowDepth::resampled(int newWidth, int newHeight) const
{
  if (newWidth == width && newHeight == height)
    return distances;
  std::vector<float> samples(static_cast<std::size_t>(newWidth) * newHeight);
  std::vector<std::pair<int, int>> columns;
  for (int x = 0; x < newWidth; ++x)
    columns.push_back(spanOf(x, width, newWidth));
  tbb::parallel_for(0, newHeight,
    [&](int y)
    {
      std::vector<float> block;
      const auto [y0, y1] = spanOf(y, height, newHeight);
      const float* rows = distances.data() + static_cast<std::size_t>(y0) * width;
      float* to = samples.data() + static_cast<std::size_t>(y) * newWidth;
      // Most often nothing is there.
      if (std::all_of(rows, rows + static_cast<std::ptrdiff_t>(y1 - y0) * width,
            [first = *rows](float d) { return d == first; }))
      {
        std::fill_n(to, newWidth, *rows);
        return;
      }
      for (int x = 0; x < newWidth; ++x)
      {
        const auto [x0, x1] = columns[static_cast<std::size_t>(x)];
        block.clear();
        for (int row = 0; row < y1 - y0; ++row)
        {
          const float* from = rows + static_cast<std::size_t>(row) * width;
          block.insert(block.end(), from + x0, from + x1);
        }
        const auto middle = block.begin() + static_cast<std::ptrdiff_t>(block.size() / 2);
        if (std::any_of(block.begin(), block.end(), [&](float d) { return d != block.front(); }))
          std::nth_element(block.begin(), middle, block.end());
        to[x] = *middle;
      }
    });
  return samples;
}

void WindowDepthReader::release(vtkWindow* window)
{
  if (resolved_ && window_ && (!window || window == window_))
    resolved_->ReleaseGraphicsResources(window_);
  resolved_ = nullptr;
  window_ = nullptr;
}

void WindowDepthReader::resolve(vtkOpenGLRenderWindow* window, const int viewport[4])
{
  vtkOpenGLState* state = window->GetState();
  const bool stencil = window->GetStencilCapable() != 0;
  if (window != window_)
    release(window_);
  state->PushFramebufferBindings();
  unsigned int from = 0, buffer = 0;
  state->GetCurrentDrawFramebufferState(from, buffer);
  if (!resolved_)
  {
    // Depth goes only between buffers of one format: the one that vtkOpenGLRenderWindow asks for.
    resolved_ = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
    resolved_->SetContext(window);
    resolved_->PopulateFramebuffer(
      viewport[2], viewport[3], true, 1, VTK_UNSIGNED_CHAR, true, 32, 0, stencil);
    window_ = window;
  }
  resolved_->Resize(viewport[2], viewport[3]);
  resolved_->Bind(GL_DRAW_FRAMEBUFFER);
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, from);
  state->vtkglBlitFramebuffer(viewport[0], viewport[1], viewport[0] + viewport[2],
    viewport[1] + viewport[3], 0, 0, viewport[2], viewport[3], GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  state->PopFramebufferBindings();
}

WindowDepth WindowDepthReader::read(vtkRenderer* renderer)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
    throw Error("What stands in a window must be known, and this one is not OpenGL's.");
  vtkOpenGLState* state = window->GetState();
  int viewport[4] = {};
  glGetIntegerv(GL_VIEWPORT, viewport);
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  while (glGetError() != GL_NO_ERROR)
    ; // somebody else's
  WindowDepth depth{viewport[2], viewport[3], {}, {}};
  depth.distances.resize(static_cast<std::size_t>(depth.width) * depth.height);

  state->PushReadFramebufferBinding();
  if (samples > 1)
  {
    resolve(window, viewport);
    resolved_->Bind(GL_READ_FRAMEBUFFER);
    viewport[0] = viewport[1] = 0;
  }
  else
  {
    unsigned int from = 0, buffer = 0;
    state->GetCurrentDrawFramebufferState(from, buffer);
    state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, from);
  }
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(viewport[0], viewport[1], depth.width, depth.height, GL_DEPTH_COMPONENT, GL_FLOAT,
    depth.distances.data());
  state->PopReadFramebufferBinding();
  if (glGetError() != GL_NO_ERROR)
    throw Error("OpenGL does not tell the depth buffer's values, by which volumes end at other "
                "props and silhouettes are found.");

  const DepthScale scale(renderer->GetActiveCamera());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, depth.distances.size(), 1 << 14),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t i = range.begin(); i != range.end(); ++i)
        depth.distances[i] = scale.distanceOf(depth.distances[i]);
    });
  depth.hash = hashOf(depth.distances.data(), depth.distances.size() * sizeof(float));
  return depth;
}

} // namespace mote
