#pragma once

#include "../core/ArrayView.h"
#include "../core/Camera.h"
#include "../core/Film.h"
#include "../imaging/Silhouettes.h"

#include <cstdint>
#include <vector>

namespace mote
{

/// What belongs together, so that edges stand between it and the rest also where there is no step.
struct EdgeGroups
{
  enum class By
  {
    Nothing,  ///< there are no groups
    Object,   ///< of the scene
    Particle, ///< each is a group of its own
    Value     ///< particles of the same value; objects without values are groups of their own
  };

  By by = By::Nothing;
  std::vector<ArrayView> values; ///< an object of the scene each, in input order; By::Value alone

  /// What a film must have besides colour and depth for its edges to be found.
  unsigned channels() const
  {
    return Film::LatestDepth | (by == By::Nothing ? 0u : unsigned(Film::LatestId));
  }
};

/// How depths along the view axis, row after row from the bottom of what the camera sees, are a
/// depth image; those of a film's sample number `sample`.
DepthImage depthImageOf(
  const float* depth, int width, int height, const Camera& camera, int sample = 0);

/// The edges of a film: the mean over its samples of the edges in each sample's depths. As the
/// samples' rays are displaced in their pixels, the mean is antialiased.
class EdgeFilm
{
public:
  /// More samples than these make no smoother edges.
  static constexpr int mostSamples = 64;

  /// Forgets all samples.
  void clear() { samples_ = 0; }

  /// Adds the edges in the depths of the latest sample of `film`, which the camera saw and which
  /// has groups.channels(). That sample must be number samples(). `limits` are those of
  /// RayCaster::setLimits(), or null: edges stand out against what ends rays where that is farther
  /// than what they belong to by the step at least, and are hidden elsewhere.
  void add(const Film& film, const Camera& camera, const SilhouetteOptions& options,
    const EdgeGroups& groups, const float* limits = nullptr, int threads = 0);

  int samples() const { return samples_; }
  /// The share of each pixel that edges cover, in [0, 1], row after row from the bottom.
  const float* coverage() const { return mean_.data(); }
  /// See silhouetteReach().
  int reach() const { return reach_; }

private:
  void findGroups(const Film& film, const EdgeGroups& groups);
  void addRows(const Film& film, const DepthImage& image, const SilhouetteOptions& options,
    const float* limits, const PixelBox& box);
  void hideBehind(
    const Film& film, const float* limits, double step, const PixelBox& box, float* edges) const;

  int samples_ = 0;
  int reach_ = 1;
  std::vector<float> mean_;
  std::vector<std::uint64_t> group_;
};

/// How far in pixels, each way, from where lines are drawn what they belong to is to be found.
int silhouetteReach(const SilhouetteOptions& options);

/// The least of a film's depths within `reach` pixels each way of a pixel: how far away an edge
/// that covers it is.
float nearSide(const float* depth, int width, int height, int x, int y, int reach);

} // namespace mote
