// One bundle from end to end, included once per SIMD instruction set by whoever casts bundles.

#if defined(MOTE_COHERENT_GRID_CAST_BUNDLE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MOTE_COHERENT_GRID_CAST_BUNDLE_INL_H
#undef MOTE_COHERENT_GRID_CAST_BUNDLE_INL_H
#else
#define MOTE_COHERENT_GRID_CAST_BUNDLE_INL_H
#endif

#include "CoherentGridCast-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mote
{
namespace HWY_NAMESPACE
{

template <int K, typename Policy>
void castAlong(const CoherentGridView& view, Pencil& pencil, RayBundle& bundle, std::int32_t object,
  std::vector<std::uint64_t>& hits, CastCounts* counts)
{
  GridCaster<K, Policy> caster(view, pencil, bundle, object, hits, counts);
  for (int layer = 0; layer < view.layers(); ++layer)
    caster.run(view.layer(layer));
}

/// Casts a bundle; false, with nothing done, where its rays do not travel the same way along one
/// axis.
template <typename Policy>
bool castBundle(
  const CoherentGridView& view, RayBundle& bundle, std::int32_t object, CastCounts* counts)
{
  Vec3d least(std::numeric_limits<double>::infinity()), most(-least);
  for (int k = 0; k < view.layers(); ++k)
  {
    const CoherentGridView::Layer layer = view.layer(k);
    const Vec3d lower(layer.lower);
    least = glm::min(least, lower - double(layer.reach));
    most = glm::max(
      most, lower + double(layer.cellSize) * Vec3d(layer.resolution) + double(layer.reach));
  }
  Pencil p;
  bool coherent = false;
  const Spread spread = spreadOf(bundle);
  if (!placePencil(
        {view.grid.origin(), view.grid.unit()}, bundle, spread, least, most, p, coherent))
    return coherent || bundle.count == 1;
  prepareProjection(spread, p);
  prepareRays(bundle, p);
  prepareBlocks(bundle, p);

  static thread_local std::vector<std::uint64_t> hits;
  hits.assign(1, RayBundle::noHit);
  switch (p.K)
  {
  case 0:
    castAlong<0, Policy>(view, p, bundle, object, hits, counts);
    break;
  case 1:
    castAlong<1, Policy>(view, p, bundle, object, hits, counts);
    break;
  default:
    castAlong<2, Policy>(view, p, bundle, object, hits, counts);
  }
  keepAnswers<Policy>(p, hits.data(), object, bundle);
  return true;
}

} // namespace HWY_NAMESPACE
} // namespace mote
HWY_AFTER_NAMESPACE();

#endif
