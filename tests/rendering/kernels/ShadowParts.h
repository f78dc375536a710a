#pragma once

#include "SceneParts.h"

#include <kernels/shading/LightSamples.h>
#include <kernels/tracing/RayCaster.h>

#include <support/Reference.h>

#include <string>

namespace mote::testing
{

/// How a scene is traced for a shadow test.
struct Tracing
{
  int samples = 1;
  int threads = 0;
  int side = 0; ///< of the bundles
};

/// The film of a scene, square unless `height` is given, with ids.
Film tracedFilm(
  const Scene& scene, const Camera& camera, int width, int height = 0, const Tracing& tracing = {});

/// A light that casts shadows from `samples` x `samples` points.
Light shadowLight(Light::Kind kind, const Vec3d& vector, int samples = 1, double size = 0.0);

/// How far each channel of the films differs at most, and in how many pixels by more than 0.01.
struct FilmDifference
{
  int pixels = 0;
  double rest = 0.0; ///< largest difference among the other pixels
};
FilmDifference differenceOf(const Film& a, const Film& b);

/// Root of the mean squared difference of red, over pixels that both films hit.
double rmsOf(const Film& a, const Film& b);

/// What a comparison with brute force found.
struct ShadowReport
{
  int pixels = 0;    ///< hit and compared
  int shadowed = 0;  ///< that lose light to a shadow
  int ambiguous = 0; ///< where rounding may decide
  int wrong = 0;
  std::string complaint; ///< about the first wrong pixel
};

/// The brute-force judge of shadows: every pixel, every sample of every light, every sphere of
/// every object, in long double.
///
/// The film tells what a pixel's ray hits; light is judged from there. A sphere may be larger or
/// smaller by `slack` in its object's coordinates: a pixel is right whose red lies between what
/// reaches it past larger and past smaller spheres, so near the edge of a shadow either answer
/// passes, and nowhere else. For white objects without ambient light and highlights.
class ShadowOracle
{
public:
  explicit ShadowOracle(double slack)
    : slack_(slack)
  {
  }

  /// Adds an object to the scene and to what the oracle knows.
  void add(const Particles& particles, const Mat4d& toWorld = Mat4d(1.0));
  Scene& scene() { return scene_; }

  ShadowReport judge(
    const Camera& camera, int width, int height, const Tracing& tracing = {}) const;

private:
  struct Surface
  {
    Vec3d position, normal; ///< in the world; the normal faces the eye
    std::size_t object, sphere;
  };
  struct Object
  {
    std::vector<reference::Sphere> spheres;
    Mat4d toWorld, toLocal;
  };

  Surface surfaceAt(const Film& film, std::size_t pixel, const reference::Ray& ray) const;
  bool isLit(const Surface& at, const LightSample& sample, double grown) const;

  double slack_;
  Scene scene_;
  std::vector<Object> objects_;
};

} // namespace mote::testing
