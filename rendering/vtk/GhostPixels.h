#pragma once

#include "MoteProp.h"
#include "SilhouetteTracer.h"

#include <cstddef>
#include <vector>

namespace mote
{

class Film;

/// The pixels of a film that are left to another rank: what is nearest there is a ghost, a copy of
/// a particle that the other rank has.
///
/// Rays of all kinds meet ghosts, so that what is near the border of two ranks is lit, shaded and
/// outlined as on one rank. A ghost itself may lack its neighbours, and its own rank draws it.
class GhostPixels
{
public:
  /// What a film must have, besides colour and depth, for its ghosts to be found.
  static unsigned channels(const MoteProps& props);

  /// Finds them anew, in the film of these props and the lines over it. `seen` is a film of the
  /// same view whose rays have met the ghosts: the film itself, if its rays have.
  void find(
    const Film& seen, const Film& film, const SilhouetteLayer& lines, const MoteProps& props);

  /// The distances at which rays end, which may be null for none, with rays of ghosts that end at
  /// once, but for those within `border` pixels of what is drawn. `seen` as for find().
  std::vector<float> spared(const Film& seen, const float* limits, int border) const;

  /// Whether there are none.
  bool empty() const { return marks_.empty(); }
  /// Whether a pixel is one.
  bool operator[](std::size_t pixel) const { return !marks_.empty() && marks_[pixel] != 0; }

private:
  std::vector<unsigned char> marks_; ///< a pixel each; empty: all are drawn
};

} // namespace mote
