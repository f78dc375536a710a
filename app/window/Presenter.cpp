#include <vtk_glew.h> // before what includes OpenGL

#include "Presenter.h"

#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkXOpenGLRenderWindow.h>

#include <GL/glx.h>

#include <algorithm>
#include <cstdint>
#include <sstream>

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

bool hasExtension(::Display* display, const char* wanted)
{
  std::istringstream names(glXQueryExtensionsString(display, DefaultScreen(display)));
  for (std::string name; names >> name;)
    if (name == wanted)
      return true;
  return false;
}

} // namespace

Presenter::Presenter(vtkRenderWindow* window)
  : window_(window)
  , isOwn_(vtkXOpenGLRenderWindow::SafeDownCast(window) != nullptr)
{
  if (isOwn_)
    window_->SwapBuffersOff();
}

/// Copies the colours of these columns into the back buffer: whether there was a frame to copy.
bool Presenter::copyToBack(int columns)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(window_);
  vtkOpenGLFramebufferObject* rendered = window->GetRenderFramebuffer();
  if (!rendered || !window->GetMapped())
    return false;
  const int height = window->GetSize()[1];
  window->MakeCurrent();
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  rendered->Bind(GL_READ_FRAMEBUFFER);
  rendered->ActivateReadBuffer(0);
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  state->vtkglDrawBuffer(GL_BACK_LEFT);
  {
    vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
    state->vtkglDisable(GL_SCISSOR_TEST);
    glBlitFramebuffer(
      0, 0, columns, height, 0, 0, columns, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  state->PopFramebufferBindings();
  return true;
}

void Presenter::present()
{
  if (!isOwn_)
    return; // VTK has shown it
  if (!window_->GetAbortRender() && this->copyToBack(window_->GetSize()[0]))
    glXSwapBuffers(xDisplayOf(window_), xWindowOf(window_));
}

void Presenter::presentLeft(int columns)
{
  if (!isOwn_)
    return window_->Frame();
  ::Display* display = xDisplayOf(window_);
  if (!isAsked_ && hasExtension(display, "GLX_MESA_copy_sub_buffer"))
    copySubBuffer_ = reinterpret_cast<CopySubBuffer>(
      glXGetProcAddress(reinterpret_cast<const GLubyte*>("glXCopySubBufferMESA")));
  isAsked_ = true;
  const int* size = window_->GetSize();
  // What a swap leaves in the back buffer is not told: only this copies a part of it.
  const int copied = copySubBuffer_ ? std::min(columns, size[0]) : size[0];
  if (!this->copyToBack(copied))
    return;
  if (copySubBuffer_)
    copySubBuffer_(display, xWindowOf(window_), 0, 0, copied, size[1]);
  else
    glXSwapBuffers(display, xWindowOf(window_));
}

} // namespace mote::app
