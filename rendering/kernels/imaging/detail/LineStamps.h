#pragma once

#include "../Silhouettes.h"
#include "SilhouetteRows.h"

#include <vector>

namespace mote
{

/// What a silhouette pixel covers of a pixel at one place beside it.
struct StampPixel
{
  int x, y; ///< from the silhouette pixel
  /// For each direction, in [0, SilhouetteRow::opaque].
  std::uint8_t coverage[SilhouetteRow::directions];
  std::uint8_t round; ///< for a silhouette pixel without direction
};

/// What silhouette pixels cover around them, for each direction and level of thickness.
///
/// A line is made of short pieces, one for each silhouette pixel: a piece is as far from the
/// pixel's centre as the border is on average, runs across the direction in which the nearer pixels
/// lie, and is long enough to meet its neighbours. A pixel at a distance r from it is covered by
/// thickness / 2 + 1/2 - r, in [0, 1]; lines thinner than a pixel are fainter instead.
class LineStamps
{
public:
  explicit LineStamps(const SilhouetteOptions& options);

  /// No pixel farther than this along an axis is covered.
  int reach() const { return reach_; }
  /// For each level; there is one if all lines are equally thick.
  const std::vector<std::vector<StampPixel>>& levels() const { return levels_; }

private:
  std::vector<std::vector<StampPixel>> levels_;
  int reach_ = 0;
};

/// A row of the output.
struct CoverRow
{
  float* coverage = nullptr;       ///< of its first pixel
  std::uint8_t* covered = nullptr; ///< as SilhouetteFinder has it, or null
};

/// Adds what the silhouette pixels of rows y - reach .. y + reach cover of row `y`, as the larger
/// of both, to the pixels [begin, end), which `out` is. Rows outside [firstRow, lastRow] have
/// none. `opacities`: whether there are others than 1.
void coverRow(SilhouetteRows& found, const LineStamps& stamps, bool opacities, int y, int firstRow,
  int lastRow, int begin, int end, const CoverRow& out);

} // namespace mote
