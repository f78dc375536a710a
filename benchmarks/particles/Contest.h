#pragma once

#include "../Options.h"
#include "../Timing.h"
#include "ImageCheck.h"
#include "ParticleMethod.h"
#include "Views.h"

#include <functional>
#include <limits>
#include <map>
#include <memory>

namespace mote::bench
{

constexpr double unknown = std::numeric_limits<double>::quiet_NaN(); ///< null in records

/// What one record says.
struct Measurement
{
  std::string suite = "particles";
  std::string table{}; ///< empty outside --tables
  std::string method{}, mode{}, input{}, view{};
  std::size_t particles = 0;
  int width = 0, height = 0, threads = 1, repeat = 1;
  double seconds = unknown; ///< a frame, median; then the least and the most
  double least = unknown, most = unknown;
  double buildSeconds = unknown;
  double bytesPerParticle = unknown;
  ImageErrors errors{};
  double poe = 0.0; ///< pixels of error that were allowed
  double lodSeconds = unknown;
  ParticleLodErrors lodErrors{};
  std::size_t rays = 0; ///< that are timed, where it is not one a pixel
  Record more{};        ///< of its table or suite alone

  /// Rays a microsecond.
  double mrays() const { return mrays(seconds); }
  double mrays(double t) const
  {
    return 1e-6 * (rays > 0 ? static_cast<double>(rays) : width * static_cast<double>(height)) / t;
  }
  void setTimes(const Race& race, std::size_t place);
};

/// A measurement on the input that says nothing yet.
Measurement measurementOf(
  const ParticleInput& input, int width, int height, int threads, int repeat);

Record toRecord(const Measurement& measurement);

/// Depths of the images that were asked for, each computed once.
class ReferenceImages
{
public:
  const std::vector<double>& depths(
    const ParticleInput& input, const View& view, int width, int height);

private:
  std::string treeOf_; ///< name of the input that `tree_` is of
  std::unique_ptr<reference::SphereTree> tree_;
  std::map<std::string, std::vector<double>> images_;
};

/// Somebody who casts images: a method, or one way of using a structure.
struct Contestant
{
  std::string method;
  std::vector<std::string> modes; ///< one or more; the fastest speaks for the contestant
  std::function<void(std::size_t mode, const CameraRays& rays, HitImage& image)> cast;
  const ParticleInput* input;
  int threads = 1;
  double buildSeconds = unknown;
  double bytesPerParticle = unknown;
  std::shared_ptr<ParticleMethod> own{}; ///< that casts, if any
  double poe = 0.0;                      ///< pixels of error that it makes
  double lodSeconds = unknown;           ///< for levels of detail
  /// What they make wrong, or none.
  std::function<ParticleLodErrors(const Camera& camera, int width, int height)> errors{};
};

/// A method that is built over an input.
struct BuiltMethod
{
  std::string name;
  std::shared_ptr<ParticleMethod> method;
  double seconds = unknown;
  double bytesPerParticle = unknown;
};

/// Builds the method over the input on so many threads, and says so.
BuiltMethod buildMethod(const ParticleMethodEntry& entry, const MethodOptions& options,
  const ParticleInput& input, int threads);

/// The same as one who casts images.
Contestant contestantOf(const ParticleMethodEntry& entry, const MethodOptions& options,
  const ParticleInput& input, int threads);
/// The same with each of the errors that are allowed, in pixels; once, exactly, for a method
/// without levels of detail.
std::vector<Contestant> contestantsOf(const ParticleMethodEntry& entry,
  const MethodOptions& options, const ParticleInput& input, int threads,
  const std::vector<double>& poe);

/// Contestants that cast the same views in one race, mode after mode, round after round.
class Contest
{
public:
  Contest(std::vector<View> views, int width, int height, int repeat);

  void add(Contestant contestant) { contestants_.push_back(std::move(contestant)); }
  Contestant& last() { return contestants_.back(); }
  std::size_t size() const { return contestants_.size(); }

  /// Times all contestants and keeps the image of everyone's fastest mode in each view. Then lets
  /// go of what they cast with: the structures make room for the reference, and Embree for the
  /// threads that it holds back from the whole process.
  void race();
  /// Compares the images with the reference and lets go of them.
  void check(ReferenceImages& references);

  const std::vector<View>& views() const { return views_; }
  Measurement& at(std::size_t contestant, std::size_t view)
  {
    return measurements_[contestant * views_.size() + view];
  }

private:
  void enterAll(Race& race, HitImage& image);
  void keep(const Race& race, std::size_t contestant, std::size_t view);

  std::vector<View> views_;
  int width_, height_, repeat_;
  std::vector<Contestant> contestants_;
  std::vector<std::size_t> places_; ///< in the race, of everyone's first mode in each view
  std::vector<CameraRays> rays_;    ///< by contestant and view, as those below
  std::vector<Measurement> measurements_;
  std::vector<HitImage> images_;
};

} // namespace mote::bench
