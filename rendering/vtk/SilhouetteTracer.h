#pragma once

#include "DataArrayView.h"
#include "MoteProp.h"

#include "kernels/core/Progress.h"
#include "kernels/scene/Scene.h"
#include "kernels/tracing/SilhouetteFilm.h"
#include "kernels/tracing/Tiles.h"

#include <string>
#include <vector>

class vtkMoteSilhouettes;

namespace mote
{

/// The same scene without what takes time and leaves depths as they are.
Scene withoutLight(const Scene& scene);

/// The least step of a silhouette in world units, for particles in a box of this diagonal: see
/// vtkMoteSilhouettes::ThresholdModes.
double stepOf(vtkMoteSilhouettes* silhouettes, const Scene& particles, double diagonal);

/// Lines to be drawn over a film, in the size of the film.
struct SilhouetteLayer
{
  const SilhouetteFilm* film = nullptr; ///< null: no lines
  Vec3f color{0.0f};

  /// As SilhouetteFilm has it.
  template <typename Visit>
  void forCovered(int first, int last, const Visit& visit) const
  {
    if (film)
      film->forCovered(first, last, visit);
  }
  /// Puts the lines over premultiplied red, green, blue and alpha of a pixel, of which they cover a
  /// share.
  void drawOver(float share, float* rgba) const
  {
    for (int c = 0; c < 4; ++c)
      rgba[c] += share * ((c < 3 ? color[c] : 1.0f) - rgba[c]);
  }
  /// The same over so many rows of pixels.
  void drawOver(int rows, float* rgba) const
  {
    forCovered(0, rows, [&](std::size_t i, float share) { this->drawOver(share, rgba + 4 * i); });
  }
};

/// Keeps the silhouettes of a film up to date with a vtkMoteSilhouettes, and casts the film's rays
/// again where that needs depths that the film no longer has.
class SilhouetteTracer
{
public:
  /// Takes the options, which may be null for none, as they are for this scene of these props, of a
  /// film whose neighbouring pixels are `distance` pixels of the picture apart. Forgets silhouettes
  /// that were found with others.
  void prepare(
    vtkMoteSilhouettes* silhouettes, const MoteProps& props, const Scene& scene, double distance);

  /// Whether there are silhouettes to draw.
  bool wanted() const { return wanted_; }
  /// How far from what they belong to lines cover pixels; 0 where none are wanted.
  int reach() const { return wanted_ ? silhouetteReach(options_) + 1 : 0; }
  /// What the film must have for add(), besides colour and depth.
  unsigned channels() const { return wanted_ ? groups_.channels() : 0u; }
  /// Forgets all silhouettes: the film begins anew.
  void clear();
  /// Counts seconds() anew.
  void startFrame() { seconds_ = 0.0; }

  /// Adds the silhouettes in the film's latest sample where those of the samples before are there.
  /// `limits` as RayCaster has them.
  void add(const Film& film, const Camera& camera, const float* limits, int threads);
  /// Whether some of the film's first samples have no silhouettes yet.
  bool isBehind(int samples) const;
  /// Finds the silhouettes of the next sample, whether the film has it yet or not, by casting its
  /// rays for their depths alone. False where `progress` stopped that; another call goes on from
  /// there.
  bool catchUp(const Scene& scene, const Film& film, const Camera& camera, const float* limits,
    int threads, const Progress& progress);

  /// The lines over the film; valid until it, or they, change.
  SilhouetteLayer layer() const
  {
    if (!wanted_ || silhouettes_.samples() == 0)
      return {};
    return {&silhouettes_, color_};
  }
  /// Spent in add() and catchUp() since startFrame().
  double seconds() const { return seconds_; }

private:
  bool takeGroups(const std::string& name, const MoteProps& props);

  bool wanted_ = false;
  SilhouetteOptions options_;
  Vec3f color_{0.0f};
  SilhouetteGroups groups_;
  std::vector<DataArrayView> values_; ///< behind those of groups_
  std::vector<vtkMTimeType> viewed_;  ///< their arrays' times; 0: no array
  std::string reported_;              ///< the array that was missed last
  SilhouetteFilm silhouettes_;
  Film again_;      ///< for rays that are cast again
  TilesDone tiles_; ///< of its sample, where that was stopped
  double seconds_ = 0.0;
};

} // namespace mote
