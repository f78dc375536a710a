#pragma once

#include "LodErrors.h"
#include "SecondaryRays.h"
#include "TriangleImage.h"
#include "TriangleInput.h"

#include <kernels/core/Camera.h>

#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace mote::bench
{

/// What casting a picture looks at.
struct TriangleVisits
{
  double nodes = unknown, clusters = unknown; ///< a ray, on average
  double bytes = unknown;                     ///< of memory read at all

  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
};

/// One way to find what rays meet of triangles. See ParticleMethod.
class TriangleMethod
{
public:
  virtual ~TriangleMethod() = default;

  /// Whether it has levels of detail; then it makes them, after build(). Timed.
  virtual bool makeLods() { return false; }
  /// How many pixels the levels of detail may err by from now on; 0: not at all.
  void setPoe(double poe) { poe_ = poe; }
  double poe() const { return poe_; }
  /// What they err by in a picture.
  virtual LodErrors lodErrors(const CameraRays& rays, int width, int height) const;

  /// Builds all that casting needs, anew where that was done before. Timed.
  virtual void build(const TriangleInput& input) = 0;
  /// What casting needs, all together.
  virtual std::size_t bytes() const = 0;

  /// Ways of doing a task; the fastest of them speaks for the method. Empty: it cannot.
  virtual std::vector<std::string> modes(TriangleTask task) const = 0;
  /// Casts a ray through every pixel's centre. Timed.
  virtual void cast(std::size_t mode, const CameraRays& rays, TriangleImage& image) const = 0;
  /// What that looks at, as far as anybody knows.
  virtual TriangleVisits visits(
    std::size_t mode, const CameraRays& rays, int width, int height) const;

  /// Answers which rays of a task meet a triangle. Timed.
  virtual void occlude(TriangleTask task, std::size_t mode, const SecondaryRays& rays,
    OcclusionAnswers& answers) const = 0;
  /// Finds what rays meet first, for each packet. Timed; only where TriangleTask::Reflection has
  /// modes.
  virtual void castRays(
    std::size_t mode, const SecondaryRays& rays, std::vector<PacketHits>& hits) const;

private:
  double poe_ = 0.0;
};

struct TriangleMethodEntry
{
  std::string name;
  std::string summary;
  std::unique_ptr<TriangleMethod> (*make)(int threads);
  bool draws = false; ///< into a window: not without a display, unless it is asked for by name
};

/// All of them.
const std::vector<TriangleMethodEntry>& triangleMethods();

std::unique_ptr<TriangleMethod> makeRlodMethod(int threads);
std::unique_ptr<TriangleMethod> makePlainRlodMethod(int threads);
std::unique_ptr<TriangleMethod> makeSparingRlodMethod(int threads);
std::unique_ptr<TriangleMethod> makeRlodPaperMethod(int threads);
std::unique_ptr<TriangleMethod> makeRlodPaperClampedMethod(int threads);
std::unique_ptr<TriangleMethod> makeEmbreeTriangles(int threads);
std::unique_ptr<TriangleMethod> makeEmbreeMediumTriangles(int threads);
std::unique_ptr<TriangleMethod> makeOpenGLTriangles(int threads);

} // namespace mote::bench
