#pragma once

#include "../core/ArrayView.h"
#include "../core/ClipRegion.h"
#include "../core/ColorMix.h"
#include "../hexahedra/IsoSurface.h"
#include "../hexahedra/SliceSurface.h"
#include "../meshes/MeshSurface.h"
#include "../occlusion/OcclusionMaps.h"
#include "../particles/ParticleSurface.h"
#include "../shading/ColorMap.h"
#include "../shading/Light.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace mote
{

/// Every kind of surface; see SurfaceKind for what each does. A new one is one more alternative
/// here.
using Surface = std::variant<ParticleSurface, IsoSurface, MeshSurface, SliceSurface>;

/// Calls `visit` with the surface that the variant holds: once a bundle, rather than once a ray.
template <typename Visit>
decltype(auto) withSurface(const Surface& surface, const Visit& visit)
{
  return std::visit(visit, surface);
}

/// Where the colours of a surface come from, by the indices that its kind gives to hits. Values and
/// colours are looked up for what is seen and nothing else.
struct SurfaceColoring
{
  Vec4f constant{1.0f}; ///< where there is nothing else
  ArrayView values;     ///< looked up in `map` where not empty
  int component = 0;    ///< of `values`, or ArrayView::magnitude
  /// Where it is not 0, of `values` with three components: the vector's part along this direction,
  /// in place of a component.
  Vec3d along{0.0};
  ColorMap map;
  ArrayView direct; ///< 8-bit grey, grey+alpha, RGB or RGBA where not empty: used as they are
  std::vector<Vec4f> palette; ///< a colour an index where not empty
  /// Of `values`, one number each, or of `direct`, of hits that stand for many, by their place; see
  /// SurfaceKind. Empty: such hits have the colour of one of the many.
  ArrayView means;

  /// Colours of up to HitBlock::capacity indices: red, green, blue, alpha.
  void fill(const std::uint64_t* indices, int count, float (*colors)[4]) const;
  /// Colours of hits that are mixed: values before they are looked up in the map, so that what lies
  /// between two of them has the map's colour in between; direct colours and palettes themselves.
  void fill(const ColorMix& mix, int count, float (*colors)[4]) const;
  /// Colours of hits that stand for many, by their places among the means.
  void fillMeans(const std::uint64_t* places, int count, float (*colors)[4]) const;
  /// Colours of values that the surface itself knows.
  void fill(const double* known, int count, float (*colors)[4]) const
  {
    map.map(known, count, colors);
  }
  /// The value of an index, to be looked up in `map`.
  double valueOf(std::uint64_t index) const
  {
    return along == Vec3d(0.0)
             ? values.value(index, component)
             : along.x * values.value(index, 0) + along.y * values.value(index, 1) +
                 along.z * values.value(index, 2);
  }
  /// Whether any index is asked for.
  bool usesIndices() const { return !values.empty() || !direct.empty() || !palette.empty(); }
  /// Whether any alpha may be below 1.
  bool mayBeTransparent() const;

  bool operator==(const SurfaceColoring&) const = default;
};

/// Lines along the edges of the cells that a surface shows; see SurfaceKind::hasEdges.
struct EdgeLook
{
  double width = 0.0;                     ///< pixels; 0: no lines
  Vec4f color{0.05f, 0.05f, 0.05f, 1.0f}; ///< its alpha mixes it with the surface's

  bool operator==(const EdgeLook&) const = default;
};

/// A surface placed in a scene.
struct SurfaceObject
{
  /// What films and picks call it: not below 0. Objects may share an id.
  std::int32_t id = 0;
  /// To be changed by whoever makes the scene when something has changed that the other members do
  /// not tell: numbers behind a view, what a structure shows.
  std::uint64_t revision = 0;
  Surface surface;
  Mat4d toWorld{1.0}; ///< affine; spheres become ellipsoids where it scales unevenly
  /// Where in the world it is shown; what lies outside is not there for rays. Solids that it cuts
  /// through (see SurfaceKind::isConvex) are closed by flat faces, all else is open.
  ClipRegion clip;
  SurfaceColoring coloring;
  EdgeLook edges;
  Material material;
  /// Opacity in place of the material's where the eye looks at the inner side: where the outward
  /// normal (SurfaceKind::normalAt()) looks away from it. None: the material's.
  std::optional<float> backOpacity;
  /// By slot, or null. Local shading takes the ambient light from them in place of rays; see
  /// OcclusionOptions for what has no map.
  std::shared_ptr<const OcclusionMaps> occlusion;
  /// Whether it keeps the light of lights from others. The sky's it keeps, but see keepsSky(); and
  /// it is seen.
  bool castsShadows = true;

  /// Whether it keeps the sky's light from others: not where it casts no shadows and lets through
  /// what is behind it on both sides, like glass.
  bool keepsSky() const { return castsShadows || backOpacity || material.opacity >= 1.0f; }

  /// The opacity of all hits, where colours add none of their own to it.
  float evenOpacity() const { return backOpacity ? 1.0f : material.opacity; }
  /// Whether rays may go on behind it.
  bool mayBeTransparent() const
  {
    return material.opacity < 1.0f || backOpacity.value_or(1.0f) < 1.0f ||
           coloring.mayBeTransparent();
  }

  bool operator==(const SurfaceObject&) const = default;
};

} // namespace mote
