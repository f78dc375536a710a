#pragma once

#include "../core/RawVector.h"
#include "ParticleRanges.h"
#include "ParticleSet.h"

#include <array>
#include <cstddef>
#include <vector>

namespace mote
{

/// Slots from `first` to before `last`.
struct SlotRun
{
  static constexpr std::size_t longest = 1 << 15;
  std::size_t first, last;
};

/// What every structure keeps beside arrays of its own. See IsParticleStructure for the functions.
class StoredParticles
{
public:
  std::size_t size() const { return count_; }
  const ParticleStatistics& statistics() const { return statistics_; }
  /// All slots, which is what structures answer that know no better.
  std::vector<SlotRun> slotsBetween(int k, double low, double high) const;
  const Vec3d& origin() const { return origin_; }
  double unit() const { return unit_; }

protected:
  /// Puts origin() in the middle of the centres, and makes unit() about the edge of a cell of those
  /// of which `cells` fill the bounds of the centres. So squares of coordinates stay within float's
  /// range, whatever the scene is measured in.
  void placeByCells(double cells);
  /// Throws Error where the attributes are more than four, have not one tuple for each of the
  /// `inputs` particles of the input (0: as many as the statistics count) or no such component, or
  /// where the way back from slots to the input is not known.
  void checkAttributes(const std::vector<ParticleAttribute>& attributes, bool hasIndices,
    std::size_t inputs = 0) const;
  /// Throws Error where a range is on an attribute and there are none.
  void keepRanges(const ParticleRanges& ranges);
  void clear() { *this = {}; }
  /// Adds slots to the runs, as one more or at the end of the last.
  static void addRun(std::vector<SlotRun>& runs, std::size_t first, std::size_t last);

  ParticleStatistics statistics_;
  Vec3d origin_{0.0};
  double unit_ = 1.0; ///< a power of two: scaling by it rounds nothing
  std::size_t count_ = 0;
  ParticleRanges ranges_;
  RawVector<std::array<float, 4>> values_; ///< attributes by slot, or empty
};

} // namespace mote
