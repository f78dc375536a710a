#include <vtk_glew.h> // before what includes OpenGL

#include "Presenter.h"

#include "SharedImage.h"

#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkXOpenGLRenderWindow.h>

#include <GL/glx.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstring>

namespace mote::app
{

namespace
{

::Display* xDisplayOf(vtkRenderWindow* window)
{
  return static_cast<::Display*>(window->GetGenericDisplayId());
}

::Window xWindowOf(vtkRenderWindow* window)
{
  return reinterpret_cast<std::uintptr_t>(window->GetGenericWindowId());
}

/// Whether the processor does what a graphics card would.
bool isSoftware()
{
  const char* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  for (const char* software : {"llvmpipe", "softpipe", "swrast", "Software Rasterizer"})
    if (name && std::strstr(name, software))
      return true;
  return false;
}

/// 0xaabbggrr to 0xffrrggbb: where windows may let others shine through, this one does not.
std::uint32_t asRedFirst(std::uint32_t pixel)
{
  return 0xff000000u | (pixel & 0x00ff00u) | ((pixel & 0xffu) << 16) | ((pixel >> 16) & 0xffu);
}

} // namespace

Presenter::Presenter(vtkRenderWindow* window)
  : window_(window)
  , isOwn_(vtkXOpenGLRenderWindow::SafeDownCast(window) != nullptr)
{
  if (isOwn_)
    window_->SwapBuffersOff();
}

Presenter::~Presenter() = default;

bool Presenter::present()
{
  if (window_->GetAbortRender())
    return false;
  if (isOwn_)
    this->present(window_->GetSize()[0]);
  return true;
}

void Presenter::presentLeft(int columns)
{
  if (isOwn_)
    this->present(std::min(columns, window_->GetSize()[0]));
  else
    window_->Frame();
}

void Presenter::present(int columns)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(window_);
  vtkOpenGLFramebufferObject* rendered = window->GetRenderFramebuffer();
  if (!rendered || !window->GetMapped() || columns <= 0)
    return;
  window->MakeCurrent();
  if (!isAsked_ && isSoftware())
    image_ = SharedImage::create(xDisplayOf(window_), xWindowOf(window_));
  isAsked_ = true;
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  rendered->Bind(GL_READ_FRAMEBUFFER);
  rendered->ActivateReadBuffer(0);
  const bool isShown = this->showPixels(columns);
  if (!isShown)
    this->copyToBack();
  state->PopFramebufferBindings();
  if (!isShown)
    glXSwapBuffers(xDisplayOf(window_), xWindowOf(window_));
}

/// Reads columns of the frame that is bound, and gives them to the X server: false where it takes
/// none.
bool Presenter::showPixels(int columns)
{
  const int* size = window_->GetSize();
  if (!image_ || !image_->fit(size[0], size[1]))
    return false;
  const auto width = static_cast<std::size_t>(columns);
  const int height = size[1];
  pixels_.resize(width * static_cast<std::size_t>(height));
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, columns, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels_.data());
  tbb::parallel_for(tbb::blocked_range<int>(0, height, 64),
    [&](const tbb::blocked_range<int>& rows)
    {
      for (int y = rows.begin(); y < rows.end(); ++y)
      {
        const std::uint32_t* from =
          pixels_.data() + width * static_cast<std::size_t>(height - 1 - y);
        std::transform(from, from + width, image_->row(y), asRedFirst);
      }
    });
  image_->show(0, columns);
  return true;
}

/// All of the frame that is bound: what a swap leaves in the back buffer is not told.
void Presenter::copyToBack()
{
  vtkOpenGLState* state = static_cast<vtkOpenGLRenderWindow*>(window_)->GetState();
  const int* size = window_->GetSize();
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  state->vtkglDrawBuffer(GL_BACK_LEFT);
  vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
  state->vtkglDisable(GL_SCISSOR_TEST);
  glBlitFramebuffer(
    0, 0, size[0], size[1], 0, 0, size[0], size[1], GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

} // namespace mote::app
