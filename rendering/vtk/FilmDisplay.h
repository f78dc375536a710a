#pragma once

#include "GhostPixels.h"
#include "SilhouetteTracer.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkWeakPointer.h"

#include <memory>
#include <vector>

class vtkOpenGLQuadHelper;
class vtkRenderer;
class vtkTextureObject;
class vtkWindow;

namespace mote
{

/// Draws a film over a renderer's viewport with colour and depth, by OpenGL. The film may have
/// fewer pixels than the viewport.
class FilmDisplay
{
public:
  FilmDisplay();
  ~FilmDisplay();

  /// How a film comes into the window.
  enum class Way
  {
    Opaque,      ///< blended, hidden by what is nearer
    Translucent, ///< the same; VTK's translucent step collects props in framebuffers of its own
                 ///< kind, and the film goes past them straight into the window's
    Over         ///< blended over all: nothing in the film lies behind what is there
  };

  /// Blends the film, and the lines over it, over what is there, and writes the depth of what is
  /// opaque in it; lines are as near as what they belong to. Ghosts are left out. `version` tells
  /// films and places of lines apart: the same one is not converted and sent again.
  void draw(vtkRenderer* renderer, const Film& film, const SilhouetteLayer& lines,
    const GhostPixels& ghosts, unsigned long version, Way way);

  /// Writes one colour, without blending, wherever the film shows something: for selection passes.
  /// `colors` holds four bytes a pixel of the film.
  void drawFlat(vtkRenderer* renderer, const Film& film, const std::vector<unsigned char>& colors);

  void release(vtkWindow* window);
  vtkOpenGLRenderWindow* window() const { return window_; }

private:
  bool prepare(vtkRenderer* renderer);
  void upload(const Film& film, const unsigned char* colors, bool smooth);
  void convertColors(const Film& film, const SilhouetteLayer& lines, const GhostPixels& ghosts);
  void convertDepth(vtkRenderer* renderer, const Film& film, const SilhouetteLayer& lines);
  void drawQuad(bool blend);
  void drawOver();
  /// In `cloudsPass` what has no depth counts as nearest.
  void renderQuad(bool cloudsPass);
  void drawIntoWindow(vtkRenderer* renderer);

  vtkWeakPointer<vtkOpenGLRenderWindow> window_; ///< may go away unnoticed while the pass is unset
  vtkNew<vtkTextureObject> color_;
  vtkNew<vtkTextureObject> depth_;
  std::unique_ptr<vtkOpenGLQuadHelper> quad_;
  std::vector<unsigned char> colorBytes_;
  std::vector<float> windowDepth_;
  std::vector<double> shown_; ///< version, camera and lines of what the textures hold
};

} // namespace mote
