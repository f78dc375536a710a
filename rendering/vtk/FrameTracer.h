#pragma once

#include "FilmEdges.h"
#include "MoteProp.h"
#include "OcclusionBaking.h"
#include "WindowDepth.h"

#include "kernels/core/Film.h"
#include "kernels/core/Progress.h"
#include "kernels/scene/Scene.h"
#include "kernels/tracing/Refinement.h"

#include <vector>

class vtkMoteShading;
class vtkMoteSilhouettes;
class vtkRenderer;

namespace mote
{

/// How one frame is to be traced; see vtkMoteRayCastPass.
struct FrameSettings
{
  Refinement refinement{4};
  bool progressive = false;
  bool autoAdjust = true;
  double frameTime = 0.08; ///< seconds that a frame may take while the view moves
  int threads = 0;
  bool interactive = false; ///< the view moves
  vtkMoteShading* shading = nullptr;
  vtkMoteSilhouettes* silhouettes = nullptr; ///< null: none
  const WindowDepth* others = nullptr;       ///< where other props stand, which end rays; or null
};

/// Keeps the traced picture of one renderer up to date with as few rays as the settings allow.
///
/// Soft shadows, ambient occlusion and paths take most of the rays of a scene that has them, and
/// volumes most of the time. While the view moves, and for the first of the samples that a
/// progressive picture shows, such a scene is drawn as a draft, with one shadow ray a light,
/// nothing of the others and volumes interpolated between fewer rays; the picture at rest begins
/// anew with all.
///
/// Edges are found in the depths of each sample. Where they are wanted otherwise than before, the
/// film stays, and rays are cast again for their depths alone.
///
/// What a picture at rest shows and has no occlusion map is baked before; a progressive picture
/// stays a draft meanwhile, with the maps that there are, and is baked for a moment each time.
class FrameTracer
{
public:
  /// Traces what is missing of the picture of these props; `width` and `height` are the viewport's
  /// in pixels. Props with nothing to draw are taken out of the list. False where none is left, or
  /// where `progress` stopped the tracing. `progress` is called on the calling thread only.
  bool trace(vtkRenderer* renderer, MoteProps& props, int width, int height,
    const FrameSettings& settings, const Progress& progress);

  const Film& film() const { return film_; }
  /// What is to be drawn over the film.
  EdgeLayer edges() const { return edges_.layer(); }
  /// Distance of neighbouring rays in pixels of the viewport.
  double distance() const { return distance_; }
  bool converged() const { return converged_; }
  /// Whether anything in the film is a preview of more; such a film never counts as converged.
  bool preview() const { return preview_; }
  /// Standard error of the film, infinite where nobody asked for it.
  double noise() const;
  double seconds() const { return seconds_; }
  /// The part of them that edges took.
  double edgeSeconds() const { return edges_.seconds(); }
  long long rays() const { return rays_; }
  /// Changes whenever the film does, or where edges are.
  unsigned long version() const { return version_; }

private:
  double distanceFor(int width, int height, const FrameSettings& settings) const;
  void begin(const std::vector<double>& signature, double distance, bool draft,
    const Refinement& refinement, int width, int height);
  bool bake(Scene& scene, const Camera& camera, int width, int height,
    const FrameSettings& settings, const Progress& progress, bool& complete);
  bool addSamples(const Scene& scene, const Camera& camera, const FrameSettings& settings,
    const float* limits, const Progress& progress);
  bool addEdges(const Scene& scene, const Camera& camera, const FrameSettings& settings,
    const float* limits, const Progress& progress);

  Film film_;
  FilmEdges edges_;
  std::vector<double> signature_; ///< all that the film depends on
  std::vector<double> view_;      ///< the same without maps, of the last call
  OcclusionBaking baking_;
  double distance_ = 1.0;
  bool draft_ = false;          ///< the film has fewer rays a hit than it should
  double secondsPerRay_ = 1e-7; ///< of the last such tracing: what the next will take, most likely
  double seconds_ = 0.0;
  long long rays_ = 0;
  unsigned long version_ = 0;
  bool converged_ = false;
  bool preview_ = false;
};

} // namespace mote
