#pragma once

#include "FilmCost.h"
#include "GhostPixels.h"
#include "MoteProp.h"
#include "OcclusionBaking.h"
#include "SilhouetteTracer.h"
#include "WindowDepth.h"

#include "kernels/core/Film.h"
#include "kernels/core/Progress.h"
#include "kernels/scene/Scene.h"
#include "kernels/tracing/Refinement.h"
#include "kernels/tracing/Tiles.h"

#include <cstdint>
#include <optional>
#include <vector>

class vtkMoteShading;
class vtkMoteSilhouettes;
class vtkRenderer;

namespace mote
{

/// How one frame is to be traced; see vtkMoteRayCastPass and vtkMoteRendererSource.
struct FrameSettings
{
  Refinement refinement{4};
  unsigned channels = 0; ///< of the finished film, besides what refinement and silhouettes need
  bool progressive = false;
  bool refines = true; ///< where progressive and at rest
  bool autoAdjust = true;
  double frameTime = 0.08;    ///< seconds that a frame may take while the view moves
  bool roughDrafts = true;    ///< drafts of clouds may be rougher than the scene says
  double mostDistance = 32.0; ///< of rays in pixels while the view moves, whatever time it takes
  double stillTime = 0.1; ///< seconds after which a progressive frame at rest shows what there is
  int threads = 0;
  bool interactive = false; ///< the view moves
  vtkMoteShading* shading = nullptr;
  vtkMoteSilhouettes* silhouettes = nullptr; ///< null: none
  const WindowDepth* others = nullptr;       ///< where other props stand, which end rays; or null
};

/// The times of change of all that the look of props depends on, besides place, camera and lights.
std::vector<vtkMTimeType> timesOf(const MoteProps& props);

/// Keeps the traced picture of one renderer up to date with as few rays as the settings allow.
///
/// A picture that moves or is progressive begins, whatever has changed, with a first film that is
/// as fine as the frame's time allows, as far as the ones before tell (see FilmCost). It is
/// never stopped, so that each change is seen. A progressive picture at rest then gets finer films,
/// the last of which has full resolution and all samples. A finer film begins as an enlarged copy
/// of the one before and is traced tile by tile: each frame traces some, and what was stopped goes
/// on in the next. A picture that is neither is traced at once.
///
/// Soft shadows, ambient occlusion and paths take most of the rays of a scene that has them, and
/// clouds most of the time. All films of such a scene but the last are drafts, with one shadow ray
/// a light, nothing of the others and clouds interpolated between fewer rays.
///
/// Where some particles are ghosts (see GhostPixels), and rays take long, those through pixels that
/// are left to other ranks are not cast, but for one that finds that out.
///
/// Silhouettes are found in the depths of each sample. Where they are wanted otherwise than before,
/// the film stays, and rays are cast again for their depths alone.
///
/// What a picture at rest shows and has no occlusion map is baked before; a progressive picture
/// stays a draft meanwhile, of full resolution and with the maps that there are, and is baked for a
/// moment each time.
class FrameTracer
{
public:
  /// Traces what is missing of the picture of these props; `width` and `height` are the viewport's
  /// in pixels. Props with nothing to draw are taken out of the list. False where film() shows
  /// nothing of them yet, because `progress` stopped the tracing, and where there are none: then
  /// the film is empty. `progress` is called on the calling thread only.
  bool trace(vtkRenderer* renderer, MoteProps& props, int width, int height,
    const FrameSettings& settings, const Progress& progress);

  const Film& film() const { return film_; }
  /// What is to be drawn over the film.
  SilhouetteLayer silhouettes() const { return silhouettes_.layer(); }
  /// What of it is not to be drawn.
  const GhostPixels& ghosts() const { return ghosts_; }
  /// Distance of neighbouring rays in pixels of the viewport, where the film is coarsest.
  double distance() const { return shownDistance_; }
  /// Samples that every pixel has.
  int samples() const;
  /// The share of the film that is finer than distance() tells, in [0, 1).
  double finerShare() const;
  /// The share of the particles in view whose occlusion is baked, where that is asked for and not
  /// all of it is done; else 1.
  double bakedShare() const { return bakedShare_; }
  bool converged() const { return converged_; }
  /// Whether anything in the film is a preview of more; such a film never counts as converged.
  bool preview() const { return preview_; }
  /// Standard error of the film, infinite where nobody asked for it.
  double noise() const;
  double seconds() const { return seconds_; }
  /// The part of them that silhouettes took.
  double silhouetteSeconds() const { return silhouettes_.seconds(); }
  /// Cast by the last trace(), but for films that were given up as too coarse or too fine.
  long long rays() const { return rays_; }
  /// Changes whenever the film does, or where silhouettes are.
  unsigned long version() const { return version_; }

private:
  struct Frame;

  /// All that a film depends on but its resolution and occlusion maps. It keeps no data alive.
  struct View
  {
    int width = 0, height = 0; ///< of the viewport in pixels
    Camera camera;
    Scene scene;
    ContentHash others; ///< of where other props stand

    bool operator==(const View&) const = default;
  };
  /// A view by its number, and the times of the maps it was traced with.
  struct Shown
  {
    std::uint64_t view = 0; ///< 0: none
    std::vector<double> maps;

    bool operator==(const Shown&) const = default;
  };

  bool takeView(View view);

  double distanceFor(const Frame& frame, double seconds) const;
  bool isLast() const { return distance_ == 1.0 && !draft_; }
  bool lacksChannels(const FrameSettings& settings) const;
  bool isDone(const FrameSettings& settings) const;
  bool forget(int width, int height, const FrameSettings& settings);
  bool bake(Frame& frame, const Camera& camera, bool& complete);
  void begin(Frame& frame, double distance, bool draft);
  double nextDistance() const;
  void beginNext(Frame& frame, bool last);
  void traceFirst(Frame& frame);
  void sharpen(Frame& frame, bool anew);
  void keepUp(Frame& frame, bool changed);
  bool spareGhosts(Frame& frame);
  bool addSample(Frame& frame);
  bool addSilhouettes(Frame& frame, int samples);

  Film film_;
  TilesDone tiles_; ///< of the sample that is being traced
  SilhouetteTracer silhouettes_;
  GhostPixels ghosts_;
  Film seen_; ///< of the film's view, where rays are spared for ghosts; else without samples
  std::optional<View> viewed_; ///< by the last call
  std::uint64_t view_ = 0;     ///< its number
  Shown shown_;                ///< by the film
  OcclusionBaking baking_;
  double bakingTime_ = 0.0;    ///< seconds that a frame of a progressive picture bakes
  double distance_ = 1.0;      ///< of the film's rays
  double shownDistance_ = 1.0; ///< of those of the film before, while the first sample is traced
  unsigned channels_ = 0;      ///< of the film, besides those of silhouettes
  bool draft_ = false;         ///< the film has fewer rays a hit than it should
  bool shows_ = false;         ///< the film shows all of the view, however coarsely
  FilmCost cost_;              ///< of first films
  double seconds_ = 0.0;
  long long rays_ = 0;
  unsigned long version_ = 0;
  double bakedShare_ = 1.0;
  bool converged_ = false;
  bool preview_ = false;
};

} // namespace mote
