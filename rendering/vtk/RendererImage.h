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
  /// Brings the picture up to date; see FrameTracer::trace(). Whether the view moves, and whether
  /// to stop, is asked of the renderer's window. False, too, where there is a problem().
  ///
  /// Where there is a volume among the props, rays end at what the framebuffer that is bound shows
  /// already, whose depth is read; call when opaque props have been drawn.
  bool trace(
    vtkRenderer* renderer, MoteProps props, FrameSettings settings, const Progress& progress);

  /// Draws the picture; while a vtkHardwareSelector is at work, what it asks for instead.
  /// `translucent`: VTK calls from its translucent step.
  void draw(vtkRenderer* renderer, bool translucent = false);

  /// What kept the last trace() from tracing, or empty.
  const std::string& problem() const { return problem_; }
  /// Whether the last trace() was stopped or failed before the picture was complete.
  bool interrupted() const { return interrupted_; }

  const FrameTracer& tracer() const { return tracer_; }
  FilmDisplay& display() { return display_; }
  /// Lets go of all that lies in the window.
  void release(vtkWindow* window);
  double traceTime() const { return tracer_.seconds(); }
  double displayTime() const { return displaySeconds_; }

private:
  void drawSelection(vtkRenderer* renderer);

  FrameTracer tracer_;
  FilmDisplay display_;
  WindowDepthReader depthReader_;
  bool ended_ = false; ///< rays of the film ended at what the depth buffer held
  std::string problem_;
  bool interrupted_ = false;
  double displaySeconds_ = 0.0;
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
