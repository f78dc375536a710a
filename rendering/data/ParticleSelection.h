#pragma once

#include "DataArrayView.h"
#include "ParticleInput.h"

#include "kernels/particles/ParticleStructure.h"

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace mote
{

/// The parts of a range that has gaps: from and to, both included, in ascending order. None: the
/// range has no gap.
using RangeParts = std::vector<std::array<double, 2>>;

/// A range of the values of one array; both ends belong to it, NaN does not.
struct ValueRange
{
  vtkDataArray* array = nullptr;
  int component = 0; ///< or ArrayView::magnitude
  double low = 0.0, high = 0.0;
  RangeParts parts = {};
};

/// Ranges of what every particle has: x, y, z of its centre and its radius, as drawn.
struct PlaceRanges
{
  static constexpr double infinity = ParticleRanges::infinity;
  std::array<double, 4> low{-infinity, -infinity, -infinity, -infinity};
  std::array<double, 4> high{infinity, infinity, infinity, infinity};

  bool isLimited(int k) const { return low[k] > -infinity || high[k] < infinity; }
  bool anyLimited() const { return isLimited(0) || isLimited(1) || isLimited(2) || isLimited(3); }
};

/// Has a structure show the particles that lie in all of some ranges, and no others.
///
/// The structure compares stored floats. Rounding keeps order, so that float limits can mostly be
/// found which part the stored values as the ranges part the exact ones; the answer is then exact
/// whatever type the values have. Finding them costs nothing for values that are float themselves,
/// and a look at the values for others. Where values on both sides of a limit are stored alike, for
/// ranges with gaps and for arrays beyond the fourth, every particle is asked and the structure
/// given a bit for each.
class MOTERENDERINGDATA_EXPORT ParticleSelection
{
public:
  /// Makes a structure show what the ranges leave, with as little work as the changes since the
  /// last call ask for. `particles` gives the input and is asked only where it is needed. Returns
  /// whether anything changed.
  bool apply(ParticleStructure& structure, std::vector<ValueRange> values,
    const PlaceRanges& places, const std::function<ParticleInput()>& particles);

  /// The structure is another one, or built anew, which made it forget all ranges.
  void forget() { *this = {}; }

  /// How many particles of the structure are shown. Looks at all of them after a change, as does
  /// the next.
  std::size_t shownCount(const ParticleStructure& structure) const;
  /// The bounds of their spheres.
  const Box& shownBounds(const ParticleStructure& structure) const;
  /// Sets the marks of the particles that are shown to 1, by their places in the input.
  void markShown(const ParticleStructure& structure, unsigned char* marks) const;

private:
  struct KeptRange
  {
    DataArrayView values;
    int component;
    double low = 0.0, high = 0.0;
    RangeParts parts = {};
    bool contains(double value) const;
  };
  void setAttributes(ParticleStructure& structure);
  void setLimits(ParticleStructure& structure);
  bool findLimits(const ParticleStructure& structure, ParticleRanges& limits) const;
  bool shows(std::uint64_t input) const;
  bool showsValues(std::uint64_t input) const;
  template <typename Structure, typename Visit>
  void forShown(const Structure& s, std::size_t begin, std::size_t end, const Visit& visit) const;
  template <typename Structure, typename Sum, typename Add>
  Sum sumOfShown(const Structure& s, const Add& add) const;

  InputKey key_;           ///< of all that the structure was told
  InputKey attributesKey_; ///< of the arrays whose values it keeps
  std::vector<KeptRange> values_;
  PlaceRanges places_;
  ParticleInput particles_;  ///< where places are limited
  PlaceRanges storedPlaces_; ///< the places as the structure compares them
  bool masked_ = false;      ///< the structure has a bit for each particle
  mutable std::optional<std::size_t> count_;
  mutable std::optional<Box> bounds_;
};

} // namespace mote
