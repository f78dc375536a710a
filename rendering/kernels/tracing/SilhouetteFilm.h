#pragma once

#include "../core/ArrayView.h"
#include "../core/Camera.h"
#include "../core/Film.h"
#include "../imaging/Silhouettes.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace mote
{

/// What belongs together: there are silhouettes between groups also where there is no step.
struct SilhouetteGroups
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

  /// What a film must have besides colour and depth for its silhouettes to be found.
  unsigned channels() const
  {
    return Film::LatestDepth | (by == By::Nothing ? 0u : unsigned(Film::LatestId));
  }
};

/// How depths along the view axis, row after row from the bottom of what the camera sees, are a
/// depth image; those of a film's sample number `sample`.
DepthImage depthImageOf(
  const float* depth, int width, int height, const Camera& camera, int sample = 0);

/// The silhouettes of a film: the mean over its samples of the lines found in each sample's depths.
/// As the samples' rays are displaced in their pixels, the mean is antialiased.
class SilhouetteFilm
{
public:
  /// More samples than these make no smoother lines.
  static constexpr int mostSamples = 64;

  /// Forgets all samples.
  void clear() { samples_ = 0; }

  /// Adds the silhouettes in the depths of the latest sample of `film`, which the camera saw and
  /// which has groups.channels(). That sample must be number samples(). `limits` are those of
  /// RayCaster::setLimits(), or null: lines stand out against what ends rays where that is
  /// farther than what they belong to by the step at least, and are hidden elsewhere.
  void add(const Film& film, const Camera& camera, const SilhouetteOptions& options,
    const SilhouetteGroups& groups, const float* limits = nullptr, int threads = 0);

  /// The same for a depth image, as large as those added before.
  void add(const DepthImage& image, const SilhouetteOptions& options, const float* limits = nullptr,
    int threads = 0);

  int samples() const { return samples_; }
  /// Calls visit(pixel, share) for the pixels of the rows [first, last) that silhouettes cover,
  /// rows from the bottom; the share is in (0, 1].
  template <typename Visit>
  void forCovered(int first, int last, const Visit& visit) const
  {
    for (int y = first; y < last; ++y)
      for (int block = 0; block < blocks_; ++block)
      {
        if (covered_[static_cast<std::size_t>(y) * blocks_ + block] == 0)
          continue;
        const int end = std::min(width_, (block + 1) * coveredColumns);
        for (int x = block * coveredColumns; x < end; ++x)
        {
          const std::size_t pixel = static_cast<std::size_t>(y) * width_ + x;
          if (mean_[pixel] > 0.0f)
            visit(pixel, mean_[pixel]);
        }
      }
  }
  /// See silhouetteReach().
  int reach() const { return reach_; }

private:
  void findGroups(const Film& film, const SilhouetteGroups& groups);
  void addRows(const DepthImage& image, const SilhouetteFinder& finder, double step,
    const float* limits, const PixelBox& box);
  void hideBehind(const DepthImage& image, const float* limits, double step, const PixelBox& box,
    float* coverage, const std::uint8_t* covered) const;

  static constexpr int coveredColumns = SilhouetteFinder::coveredColumns;

  int samples_ = 0;
  int reach_ = 1;
  int width_ = 0;
  int blocks_ = 0;                    ///< in a row, of SilhouetteFinder::coveredColumns pixels
  std::vector<float> mean_;           ///< anything where not covered_
  std::vector<std::uint8_t> covered_; ///< a block each
  std::vector<std::uint64_t> group_;
};

/// Search radius in pixels from a line to the surface it outlines.
int silhouetteReach(const SilhouetteOptions& options);

/// The least of a film's depths within `reach` pixels each way of a pixel: how far away a line that
/// covers it is.
float nearSide(const float* depth, int width, int height, int x, int y, int reach);

} // namespace mote
