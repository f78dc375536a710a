#pragma once

#include "CellCrossings.h"
#include "HexField.h"

#include <array>
#include <cstdint>
#include <vector>

namespace mote
{

/// A span, a field's values where it begins and ends (at the faces that it names, and only there),
/// and the cell's bendOf() the field.
struct ValuedSpan
{
  CellSpan span;
  double valueIn = 0.0, valueOut = 0.0, bend = 0.0;
};

/// The spans of up to 64 rays that have been found and not yet been told of, each ray's ordered by
/// tIn and then by cell.
class BundleSpans
{
public:
  static constexpr std::size_t rays = 64;

  void add(std::size_t ray, const ValuedSpan& span)
  {
    if (!(span.span.tIn < span.span.tOut))
      return;
    std::vector<ValuedSpan>& spans = of_[ray];
    spans.push_back(span);
    ++size_;
    for (std::size_t i = spans.size() - 1; i > 0 && isBefore(span, spans[i - 1]); --i)
      std::swap(spans[i - 1], spans[i]);
  }
  const std::vector<ValuedSpan>& of(std::size_t ray) const { return of_[ray]; }
  void dropFirst(std::size_t ray, std::size_t count)
  {
    std::vector<ValuedSpan>& spans = of_[ray];
    spans.erase(spans.begin(), spans.begin() + static_cast<std::ptrdiff_t>(count));
    size_ -= count;
  }
  void clear()
  {
    for (std::vector<ValuedSpan>& spans : of_)
      spans.clear();
    size_ = 0;
  }
  std::size_t size() const { return size_; } ///< of all rays together

private:
  static bool isBefore(const ValuedSpan& a, const ValuedSpan& b)
  {
    return a.span.tIn != b.span.tIn ? a.span.tIn < b.span.tIn : a.span.cell < b.span.cell;
  }

  std::array<std::vector<ValuedSpan>, rays> of_;
  std::size_t size_ = 0;
};

/// The lines of up to 64 rays, tested against one cell at a time, with the rays in SIMD lanes: a
/// CrossingLine each, with the same answers to the last bit. What is seldom (a line that meets a
/// cell twice, faces that are folded or collapsed, products that decide by their rounding) is left
/// to the CrossingLine.
///
/// Signs of all rays are gathered into words of 64 bits, a ray a bit, so that windings are found
/// for all rays at once. Rays beside the cell are passed over eight at a time, those of bundles in
/// the order of bundleOffset() 4 x 2 neighbours. Where rays pass a face, its roots are found for
/// as many of them at once as there are lanes.
class LineBundle
{
public:
  static constexpr int capacity = 64;

  /// 1 to 64 rays, not copied. Their lines should be nearly parallel.
  LineBundle(const HexRay* rays, int count);

  /// Whether the rays can be taken together: along the same axis most of all, and with SIMD that is
  /// worth it. If not, addSpans() must not be called.
  bool isCoherent() const { return isCoherent_; }

  /// Adds the parts of the rays of `wanted`, a bit each, in a cell. Values are of `field`, if any,
  /// which has values at points.
  void addSpans(const HexMesh& mesh, std::uint32_t cell, const HexField* field,
    std::uint64_t wanted, BundleSpans& spans) const;

  /// The lines as LineFrames, number by number; lanes that have no ray repeat the first one.
  struct Lanes
  {
    static constexpr std::size_t groups = 8; ///< of eight rays each
    alignas(64) std::array<double, capacity> originX, originY, originZ, shearX, shearY, inverse;
    /// The least and greatest of each group.
    struct Bounds
    {
      alignas(64) std::array<double, groups> lower, upper;
    };
    Bounds groupX, groupY, groupZ, groupShearX, groupShearY;
    Vec3d middle;            ///< a line's direction between all others, the third coordinate 1
    double reachX, reachY;   ///< from there to the farthest shears
    double farthest;         ///< what origins count, at most, where they are not subtracted first
    std::array<int, 3> axes; ///< the frame's order of axes
    bool isFan;              ///< all rays have the same origin
  };

private:
  void addSeldom(const HexMesh& mesh, std::uint32_t cell, const CornerValues* values, double bend,
    std::size_t ray, BundleSpans& spans) const;

  const HexRay* rays_;
  int count_;
  bool isCoherent_;
  Lanes lanes_;
  std::vector<CrossingLine> lines_;
};

} // namespace mote
