#pragma once

#include "kernels/core/ContentHash.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <vector>

class vtkOpenGLFramebufferObject;
class vtkRenderer;
class vtkWindow;

namespace mote
{

/// How far away what stands in a viewport is.
struct WindowDepth
{
  int width = 0, height = 0;
  /// Along the view axis, in world units, row after row from the bottom; infinity where nothing is.
  std::vector<float> distances;
  ContentHash hash; ///< of the distances

  /// The distances for the pixels of an image of another size over the same viewport: of the pixels
  /// that one covers, at least 3x3 where it is coarser, the median. A thin line in front ends no
  /// coarse pixel.
  std::vector<float> resampled(int newWidth, int newHeight) const;
};

/// Reads the depth buffer of a renderer's viewport, by OpenGL.
class WindowDepthReader
{
public:
  /// Reads the framebuffer that is bound for drawing, over OpenGL's present viewport, whether it
  /// has one sample a pixel or many (then one of them). Throws Error where OpenGL will not have it.
  WindowDepth read(vtkRenderer* renderer);
  void release(vtkWindow* window);

private:
  void resolve(vtkOpenGLRenderWindow* window, const int viewport[4]);

  vtkWeakPointer<vtkOpenGLRenderWindow> window_;
  vtkSmartPointer<vtkOpenGLFramebufferObject> resolved_; ///< of framebuffers of many samples
};

} // namespace mote
