#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace mote
{

/// The image that a scene is traced into. Row 0 is the bottom row, as in VTK images.
///
/// Colour is kept as the mean over the samples of a pixel, with alpha = the share of samples that
/// hit (colour is premultiplied by it). Depth, id and normal belong to the ray through the pixel's
/// centre, which is the first sample; the latest channels to the sample taken last, whose rays are
/// displaced in their pixels as RayCaster::sampleOffset() says. Channels that nobody asked for take
/// no memory.
class Film
{
public:
  static constexpr std::uint64_t noId = std::numeric_limits<std::uint64_t>::max();

  enum Channel : unsigned
  {
    Id = 1u,          ///< input index of the particle, and index of its object in the scene
    Normal = 2u,      ///< unit normal in world coordinates
    Variance = 4u,    ///< of the samples of a pixel
    LatestDepth = 8u, ///< depth of the latest sample
    LatestId = 16u    ///< what Id tells, of the latest sample
  };

  /// Sets the size in pixels and the channels besides colour and depth, and forgets all samples.
  void resize(int width, int height, unsigned channels = 0);

  int width() const { return width_; }
  int height() const { return height_; }
  std::size_t pixels() const { return static_cast<std::size_t>(width_) * height_; }
  /// Samples that each pixel has received so far.
  int samples() const { return samples_; }
  void setSamples(int n) { samples_ = n; }
  bool has(Channel c) const { return (channels_ & c) != 0; }
  std::size_t bytes() const;

  /// Four floats a pixel, premultiplied red, green, blue and alpha; in [0, 1], but what paths find
  /// may be brighter.
  float* color() { return color_.data(); }
  const float* color() const { return color_.data(); }
  /// Distance along the view axis in world units; +infinity where nothing was hit.
  float* depth() { return depth_.data(); }
  const float* depth() const { return depth_.data(); }
  /// Nearest depth over all samples of the pixel: what a partly covered pixel is composited with.
  float* nearestDepth() { return nearest_.empty() ? depth_.data() : nearest_.data(); }
  const float* nearestDepth() const { return nearest_.empty() ? depth_.data() : nearest_.data(); }
  /// From the second sample on nearestDepth() differs from depth(), and is stored apart.
  void splitNearestDepth();
  /// Depth of the latest sample; that of the first where LatestDepth was not asked for.
  float* latestDepth() { return latest_.empty() ? depth_.data() : latest_.data(); }
  const float* latestDepth() const { return latest_.empty() ? depth_.data() : latest_.data(); }
  /// From the second sample on latestDepth() differs from depth(), and is stored apart where asked.
  void splitLatestDepth();
  std::uint64_t* id() { return id_.data(); }
  const std::uint64_t* id() const { return id_.data(); }
  std::int32_t* object() { return object_.data(); }
  const std::int32_t* object() const { return object_.data(); }
  /// Empty unless LatestId was asked for.
  std::uint64_t* latestId() { return latestId_.data(); }
  const std::uint64_t* latestId() const { return latestId_.data(); }
  std::int32_t* latestObject() { return latestObject_.data(); }
  const std::int32_t* latestObject() const { return latestObject_.data(); }
  /// Three floats a pixel; 0 0 0 where nothing was hit.
  float* normal() { return normal_.data(); }
  const float* normal() const { return normal_.data(); }
  /// Sum over the samples of the squared distance of their colour from its mean, a pixel each; the
  /// mean over the four channels.
  float* squares() { return squares_.data(); }
  const float* squares() const { return squares_.data(); }
  /// Variance of one sample of a pixel, estimated from all; 0 before there are two.
  float variance(std::size_t pixel) const
  {
    return samples_ > 1 ? squares_[pixel] / static_cast<float>(samples_ - 1) : 0.0f;
  }

private:
  int width_ = 0;
  int height_ = 0;
  int samples_ = 0;
  unsigned channels_ = 0;
  std::vector<float> color_;
  std::vector<float> depth_;
  std::vector<float> nearest_;
  std::vector<float> latest_;
  std::vector<std::uint64_t> id_;
  std::vector<std::int32_t> object_;
  std::vector<std::uint64_t> latestId_;
  std::vector<std::int32_t> latestObject_;
  std::vector<float> normal_;
  std::vector<float> squares_;
};

} // namespace mote
