#pragma once

#include "FilmDisplay.h"
#include "FrameTracer.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace mote
{

/// The traced picture of some props in one renderer, and its way onto the screen.
class RendererImage
{
public:
  /// Brings the picture up to date, see FrameTracer::trace(), and draws it; while a
  /// vtkHardwareSelector is at work, what it asks for instead. Whether the view moves, and whether
  /// to stop, is asked of the renderer's window. `translucent`: VTK calls from its translucent
  /// step. False where nothing is drawn. What keeps it from tracing is an error of `owner`, once.
  ///
  /// Where there is a volume among the props, rays end at what the framebuffer that is bound shows
  /// already, whose depth is read; call when opaque props have been drawn.
  bool render(vtkObject* owner, vtkRenderer* renderer, const MoteProps& props,
    const FrameSettings& settings, const Progress& progress = {}, bool translucent = false);

  /// Whether the last render() drew something.
  bool shown() const { return shown_; }
  /// Whether there is nothing left to trace: all is there, or nothing to draw is.
  bool converged() const { return shown_ ? tracer_.converged() : !interrupted_; }

  const FrameTracer& tracer() const { return tracer_; }
  FilmDisplay& display() { return display_; }
  /// Lets go of all that lies in the window.
  void release(vtkWindow* window);
  /// Seconds that the last render() took to draw; 0 where it drew nothing.
  double displayTime() const { return shown_ ? displaySeconds_ : 0.0; }
  double time() const { return tracer_.seconds() + this->displayTime(); }

private:
  bool trace(
    vtkRenderer* renderer, MoteProps props, FrameSettings settings, const Progress& progress);
  void draw(vtkRenderer* renderer, bool translucent);
  void drawSelection(vtkRenderer* renderer, bool picksCells);

  FrameTracer tracer_;
  FilmDisplay display_;
  WindowDepthReader depthReader_;
  bool picksCells_ = false;
  bool ended_ = false;   ///< rays of the film ended at what the depth buffer held
  std::string problem_;  ///< what kept the last trace() from tracing, or empty
  std::string reported_; ///< so that it is told once and not every frame
  bool interrupted_ = false;
  bool shown_ = false;
  double displaySeconds_ = 0.0; ///< of the last draw()
};

/// The images of one mapper or pass, a renderer each.
class RendererImages
{
public:
  RendererImage& of(vtkRenderer* renderer);
  /// Forgets the images shown in this window, or all where it is null.
  void release(vtkWindow* window);

private:
  std::map<vtkRenderer*, std::unique_ptr<RendererImage>> images_;
};

} // namespace mote
