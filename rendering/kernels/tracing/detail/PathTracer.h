#pragma once

#include "../../shading/Reflectance.h"
#include "SurfaceShader.h"

namespace mote
{

/// Finds the light that comes to the camera's hits by paths: from the sky and the lights, straight
/// and by way of other surfaces.
///
/// One path a hit and film sample, so that the mean over film samples tends to the truth. At each
/// surface every light is asked by one ray to one of its points (all lights cast shadows here), and
/// the path goes on in one direction until it meets the sky; beyond a few surfaces it lives on by
/// chance, in proportion to what it carries. The sky is behind all that is there, but not in the
/// picture. Surfaces are Reflectance by their colour times Material::diffuse; those that answer no
/// light, diffuse and metallic being 0, shine by Material::ambient, which has no other part here.
/// Surfaces hide what is behind them whatever their opacity. A metal that is met after a diffuse
/// surface is taken to be rough, so that no bright specks remain (Jendersie, Grosch, "Microfacet
/// Model Regularization for Robust Light Transport", 2019). Sources: Kajiya, "The Rendering
/// Equation", 1986; docs/ambient-occlusion.md.
class PathTracer
{
public:
  /// `shaders` are those of the scene's surfaces; `camera` tells where headlights stand, its origin
  /// being the rays' reference point. All must outlive this.
  PathTracer(const SceneRays& rays, const std::vector<SurfaceShader>& shaders,
    const CameraRays& camera, int filmSample);

  /// Fills `out` of a block that has colours, positions, normals, sides and seeds.
  void shade(SurfaceBlock& block) const;

private:
  struct Path;
  struct Work;

  void begin(Work& work, const SurfaceBlock& block) const;
  bool meet(Work& work, Path& path, const Vec3f& color) const;
  void addLight(Work& work, std::size_t light, int bounce) const;
  void goOn(Work& work, int bounce) const;
  void follow(Work& work, int& arrived) const;

  /// A light as the square of points it shines from, counted from the reference point.
  struct PathLight
  {
    LightSquare square;
    Vec3f color;
  };

  const SceneRays& rays_;
  const std::vector<SurfaceShader>& shaders_;
  std::vector<PathLight> lights_;
  std::uint32_t sample_;
};

} // namespace mote
