#pragma once

#include "../particles/OcclusionRays.h"
#include "TriangleImage.h"
#include "TriangleInput.h"

#include <kernels/core/Camera.h>

#include <memory>
#include <string>
#include <vector>

namespace mote::bench
{

/// One way to find what rays meet of triangles. See ParticleMethod.
class TriangleMethod
{
public:
  virtual ~TriangleMethod() = default;

  /// Builds all that casting needs, anew where that was done before. Timed.
  virtual void build(const TriangleInput& input) = 0;
  /// What casting needs, all together.
  virtual std::size_t bytes() const = 0;

  /// Ways of casting; the fastest of them speaks for the method.
  virtual std::vector<std::string> modes() const = 0;
  /// Casts a ray through every pixel's centre. Timed.
  virtual void cast(std::size_t mode, const CameraRays& rays, TriangleImage& image) const = 0;
  /// Nodes and leaves that a ray of the image takes on average, or NaN where nobody knows.
  virtual std::pair<double, double> visits(
    std::size_t mode, const CameraRays& rays, int width, int height) const;

  virtual std::vector<std::string> occlusionModes() const = 0;
  /// Answers which rays meet a triangle. Timed.
  virtual void occlude(
    std::size_t mode, const OcclusionRays& rays, OcclusionAnswers& answers) const = 0;
};

struct TriangleMethodEntry
{
  std::string name;
  std::string summary;
  std::unique_ptr<TriangleMethod> (*make)(int threads);
};

/// All of them.
const std::vector<TriangleMethodEntry>& triangleMethods();

std::unique_ptr<TriangleMethod> makeRlodMethod(int threads);
std::unique_ptr<TriangleMethod> makeEmbreeTriangles(int threads);
std::unique_ptr<TriangleMethod> makeEmbreeMediumTriangles(int threads);

} // namespace mote::bench
