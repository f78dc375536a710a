#include "vtk_glew.h" // before all other OpenGL headers

#include "FilmDisplay.h"

#include "DepthScale.h"

#include "vtkCamera.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace mote
{

namespace
{

const char* const fragmentShader = R"(//VTK::System::Dec
//VTK::Output::Dec
in vec2 texCoord;
uniform sampler2D colorTexture;
uniform sampler2D depthTexture;
uniform int cloudsPass;
void main()
{
  vec4 color = texture2D(colorTexture, texCoord);
  if (color.a <= 0.0)
    discard;
  float depth = texture2D(depthTexture, texCoord).r;
  gl_FragData[0] = color;
  gl_FragDepth = cloudsPass != 0 && depth >= 1.0 ? 0.0 : depth;
}
)";

void prepareTexture(vtkTextureObject* texture, vtkOpenGLRenderWindow* window, int filter)
{
  texture->SetContext(window);
  texture->SetMinificationFilter(filter);
  texture->SetMagnificationFilter(filter);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
}

} // namespace

FilmDisplay::FilmDisplay() = default;

FilmDisplay::~FilmDisplay() = default;

void FilmDisplay::release(vtkWindow* window)
{
  if (window_ && window)
  {
    if (quad_)
      quad_->ReleaseGraphicsResources(window);
    color_->ReleaseGraphicsResources(window);
    depth_->ReleaseGraphicsResources(window);
  }
  quad_.reset();
  shown_.clear();
  window_ = nullptr;
}

bool FilmDisplay::prepare(vtkRenderer* renderer)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
    return false;
  if (window != window_)
    release(window_);
  if (quad_ && !quad_->Program)
    release(window); // the window was closed and opened again: all that was in it has gone
  window_ = window;
  if (!quad_)
    quad_ = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, fragmentShader, nullptr);
  else
    window->GetShaderCache()->ReadyShaderProgram(quad_->Program);
  return quad_->Program != nullptr && quad_->Program->GetCompiled();
}

namespace
{

/// Calls work(first row, last, first pixel, last) for all of the film in parallel, a few rows at a
/// time.
template <typename Work>
void forRows(const Film& film, const Work& work)
{
  const auto width = static_cast<std::size_t>(film.width());
  tbb::parallel_for(tbb::blocked_range<int>(0, film.height(), 16),
    [&](const tbb::blocked_range<int>& rows)
    { work(rows.begin(), rows.end(), rows.begin() * width, rows.end() * width); });
}

} // namespace

void FilmDisplay::convertColors(
  const Film& film, const SilhouetteLayer& lines, const GhostPixels& ghosts)
{
  const auto byteOf = [](float value)
  { return static_cast<unsigned char>(std::min(value, 1.0f) * 255.0f + 0.5f); };
  colorBytes_.resize(4 * film.pixels());
  const auto drawLine = [&](std::size_t i, float share)
  {
    float color[4];
    std::copy_n(film.color() + 4 * i, 4, color);
    lines.drawOver(share, color);
    std::transform(color, color + 4, &colorBytes_[4 * i], byteOf);
  };
  forRows(film,
    [&](int first, int last, std::size_t begin, std::size_t end)
    {
      for (std::size_t i = 4 * begin; i != 4 * end; ++i)
        colorBytes_[i] = byteOf(film.color()[i]);
      lines.forCovered(first, last, drawLine);
      for (std::size_t i = begin; i != end && !ghosts.empty(); ++i)
        if (ghosts[i])
          std::fill_n(&colorBytes_[4 * i], 4, static_cast<unsigned char>(0));
    });
}

void FilmDisplay::convertDepth(
  vtkRenderer* renderer, const Film& film, const SilhouetteLayer& lines)
{
  const DepthScale scale(renderer->GetActiveCamera());
  windowDepth_.resize(film.pixels());
  const auto bringForward = [&](std::size_t i, float)
  {
    const int x = static_cast<int>(i % film.width()), y = static_cast<int>(i / film.width());
    windowDepth_[i] = scale.valueOf(
      nearSide(film.nearestDepth(), film.width(), film.height(), x, y, lines.film->reach()));
  };
  forRows(film,
    [&](int first, int last, std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i != end; ++i)
        windowDepth_[i] = scale.valueOf(film.nearestDepth()[i]);
      lines.forCovered(first, last, bringForward);
    });
}

void FilmDisplay::upload(const Film& film, const unsigned char* colors, bool smooth)
{
  const auto width = static_cast<unsigned>(film.width());
  const auto height = static_cast<unsigned>(film.height());
  // A film of fewer pixels than the viewport is smoothed; depths must not be blended.
  prepareTexture(color_, window_, smooth ? vtkTextureObject::Linear : vtkTextureObject::Nearest);
  prepareTexture(depth_, window_, vtkTextureObject::Nearest);
  color_->Create2DFromRaw(width, height, 4, VTK_UNSIGNED_CHAR, const_cast<unsigned char*>(colors));
  depth_->Create2DFromRaw(width, height, 1, VTK_FLOAT, windowDepth_.data());
}

void FilmDisplay::renderQuad(bool cloudsPass)
{
  color_->Activate();
  depth_->Activate();
  quad_->Program->SetUniformi("cloudsPass", cloudsPass);
  quad_->Program->SetUniformi("colorTexture", color_->GetTextureUnit());
  quad_->Program->SetUniformi("depthTexture", depth_->GetTextureUnit());
  quad_->Render();
  depth_->Deactivate();
  color_->Deactivate();
}

void FilmDisplay::drawQuad(bool blend)
{
  vtkOpenGLState* state = window_->GetState();
  const vtkOpenGLState::ScopedglEnableDisable keepDepthTest(state, GL_DEPTH_TEST);
  const vtkOpenGLState::ScopedglEnableDisable keepBlend(state, GL_BLEND);
  const vtkOpenGLState::ScopedglDepthMask keepMask(state);
  const vtkOpenGLState::ScopedglBlendFuncSeparate keepFunction(state);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
  if (blend)
  {
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  }
  else
    state->vtkglDisable(GL_BLEND);
  renderQuad(false);
}

void FilmDisplay::drawOver()
{
  vtkOpenGLState* state = window_->GetState();
  const vtkOpenGLState::ScopedglEnableDisable keepDepthTest(state, GL_DEPTH_TEST);
  const vtkOpenGLState::ScopedglEnableDisable keepBlend(state, GL_BLEND);
  const vtkOpenGLState::ScopedglDepthMask keepMask(state);
  const vtkOpenGLState::ScopedglDepthFunc keepDepthFunction(state);
  const vtkOpenGLState::ScopedglColorMask keepColors(state);
  const vtkOpenGLState::ScopedglBlendFuncSeparate keepFunction(state);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  // Colours first. Rays have ended at other props. But a pixel of a coarse film may be of several
  // of the window, and a surface in it must not cover what stands before it, such as a thin line.
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(GL_FALSE);
  renderQuad(true);
  // Then depths alone. A cloud has none: its pixels hold 1, which is nearer than nothing.
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglDepthFunc(GL_LESS);
  state->vtkglDepthMask(GL_TRUE);
  renderQuad(false);
}

void FilmDisplay::drawIntoWindow(vtkRenderer* renderer)
{
  vtkOpenGLState* state = window_->GetState();
  const vtkOpenGLState::ScopedglViewport keepViewport(state);
  const vtkOpenGLState::ScopedglScissor keepScissor(state);
  int width = 0, height = 0, x = 0, y = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &x, &y);
  state->PushDrawFramebufferBinding();
  window_->GetRenderFramebuffer()->Bind(GL_DRAW_FRAMEBUFFER);
  state->vtkglViewport(x, y, width, height);
  state->vtkglScissor(x, y, width, height);
  // Depth peeling asks for the same picture again and again, and blends by maximum.
  const vtkOpenGLState::ScopedglDepthFunc keepDepthFunction(state);
  state->vtkglDepthFunc(GL_LESS);
  GLint equation = GL_FUNC_ADD;
  glGetIntegerv(GL_BLEND_EQUATION_RGB, &equation);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  drawQuad(true);
  state->vtkglBlendEquation(static_cast<GLenum>(equation));
  state->PopDrawFramebufferBinding();
}

void FilmDisplay::draw(vtkRenderer* renderer, const Film& film, const SilhouetteLayer& lines,
  const GhostPixels& ghosts, unsigned long version, Way way)
{
  if (!prepare(renderer))
    return;
  const double* range = renderer->GetActiveCamera()->GetClippingRange();
  std::vector<double> wanted = {double(version), range[0], range[1]};
  if (lines.film)
    for (int c = 0; c < 3; ++c)
      wanted.push_back(lines.color[c]);
  if (wanted != shown_)
  {
    convertColors(film, lines, ghosts);
    convertDepth(renderer, film, lines);
    int width = 0, height = 0, x = 0, y = 0;
    renderer->GetTiledSizeAndOrigin(&width, &height, &x, &y);
    upload(film, colorBytes_.data(), width != film.width() || height != film.height());
    shown_ = wanted;
  }
  if (way == Way::Translucent)
    drawIntoWindow(renderer);
  else if (way == Way::Over)
    drawOver();
  else
    drawQuad(true);
}

void FilmDisplay::drawFlat(
  vtkRenderer* renderer, const Film& film, const std::vector<unsigned char>& colors)
{
  if (!prepare(renderer))
    return;
  shown_.clear();
  convertDepth(renderer, film, {});
  upload(film, colors.data(), false);
  drawQuad(false);
}

} // namespace mote
