#pragma once

#include "../core/SurfaceKind.h"
#include "HexField.h"
#include "HexStructure.h"
#include "HiddenCells.h"
#include "IsoCrossing.h"

#include <memory>
#include <optional>
#include <vector>

namespace mote
{

/// The surfaces where a trilinear field on hexahedra takes one of some values: a SurfaceKind. Slots
/// name the iso-value and the cell, ids are cells of the input, and colours go by the iso-value, or
/// by another field at the same place. Both sides are alike: normals look at whoever sees them.
class IsoSurface
{
public:
  static constexpr bool isConvex = false;
  static constexpr bool mayMixColors = false;
  static constexpr bool hasValues = true;
  static constexpr bool hasEdges = false;
  static constexpr bool mayErr = false;

  IsoSurface() = default; ///< of no structure
  /// The field is on the structure's mesh; `values` are as the user's scalar has them, and those
  /// that are not finite have no surface. Hidden cells, null for none, have none either. `colors`
  /// is a field on the same mesh, null for the one that is followed.
  IsoSurface(std::shared_ptr<const HexStructure> structure, std::shared_ptr<const HexField> field,
    const std::vector<double>& values, std::shared_ptr<const HiddenCells> hidden = nullptr,
    std::shared_ptr<const HexField> colors = nullptr);

  /// The first surface on a ray in the mesh's coordinates.
  template <typename Counts = NoCounts>
  std::optional<IsoHit> first(const HexRay& ray, Counts&& counts = {}) const;

  Box bounds() const { return meshOf(*structure_).bounds(); }
  double rounding() const;
  void cast(RayBundle& rays, std::int32_t index) const;
  void cast(RayPacket& rays, std::int32_t index) const;
  void occlude(RayBundle& rays, std::int32_t index) const;
  void occlude(RayPacket& rays, std::int32_t index) const;
  int bundleSide(const CameraRays&, int, int, int) const { return 16; }
  void fetch(HitBlock&) const {}
  void place(HitBlock& block, const HitPlacing& placing) const;
  Vec3d normalAt(std::uint64_t slot, const Vec3d& point) const;
  bool encloses(std::uint64_t, const Vec3d&) const { return false; }
  /// The places of values among the iso-values.
  void colorIndices(const std::uint64_t* slots, int count, std::uint64_t* indices) const;
  /// As the user's scalar has them: iso-values, or those of the field of the colours.
  void values(const std::uint64_t* slots, const Vec3d* points, int count, double* values) const;
  void inputIds(const std::uint64_t* slots, int count, std::uint64_t* ids) const;
  std::size_t slots() const { return 0; }
  std::vector<FeatureSize> featureSizes() const { return {}; }

  IsoSurface unowned() const;
  bool operator==(const IsoSurface&) const = default;

private:
  bool isMet(const ScalarRange& range) const;
  template <typename Rays, typename Found>
  void meetEach(const Rays& rays, int first, int last, const Found& found) const;
  template <typename Found>
  bool meetTogether(const RayBundle& rays, int first, int last, const Found& found) const;
  template <typename Found>
  void meetAll(const RayBundle& rays, const Found& found) const;
  template <typename Found>
  void meetAll(const RayPacket& rays, const Found& found) const;
  template <typename Rays>
  void castAll(Rays& rays, std::int32_t index) const;
  template <typename Rays>
  void occludeAll(Rays& rays) const;

  std::shared_ptr<const HexStructure> structure_;
  std::shared_ptr<const HexField> field_;
  std::shared_ptr<const HiddenCells> hidden_; ///< null: none
  std::shared_ptr<const HexField> colors_;    ///< null: the iso-values
  std::vector<double> values_;                ///< from the field's offset
  std::vector<double> asked_;                 ///< the same as the user has them
};

static_assert(SurfaceKind<IsoSurface>);

} // namespace mote
