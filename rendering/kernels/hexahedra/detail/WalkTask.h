#pragma once

// What the parts of a CellWalk share. Only for CellWalk*.cpp and Walk*.cpp.

#include "../HiddenCells.h"
#include "../RayColor.h"
#include "CellFaces.h"
#include "WalkTransfer.h"
#include "WalkView.h"

#include <array>
#include <cstdint>
#include <vector>

namespace mote
{

/// Up to 256 rays that run along the same coordinate most of all, number by number. They are lines
/// in the coordinates of WalkCells, taken in the order (k + 1, k + 2, k) of which k is that
/// coordinate: the first is x + dx times the third, the second y + dy times the third. Depth z is
/// the third, with the sign that makes it grow along the rays.
struct WalkRays
{
  static constexpr int capacity = 256;
  int count = 0;
  alignas(64) std::array<float, capacity> placeX, placeY; ///< in the image, in pixels
  alignas(64) std::array<float, capacity> x, y, dx, dy;
  alignas(64) std::array<float, capacity> from, to; ///< depths that a ray begins and ends at
  alignas(64) std::array<float, capacity> length;   ///< in the world, for one of depth
  alignas(64) std::array<std::array<float, 4>, capacity> color; ///< the answer, and transmittance
  std::array<int, capacity> index;                              ///< whatever the caller wants
};

/// Where rays enter the mesh, each ray's by depth.
struct WalkEntries
{
  static constexpr std::uint32_t none = 0xffffffffU;
  struct Entry
  {
    float z, value;
    std::uint32_t cell, next;
  };
  std::vector<Entry> all;
  std::array<std::uint32_t, WalkRays::capacity> first;

  void clear()
  {
    all.clear();
    first.fill(none);
  }
  void add(std::size_t ray, float z, float value, std::uint32_t cell)
  {
    const auto added = static_cast<std::uint32_t>(all.size());
    all.push_back({z, value, cell, none});
    std::uint32_t* at = &first[ray];
    while (*at != none && (all[*at].z < z || (all[*at].z == z && all[*at].cell < cell)))
      at = &all[*at].next;
    all[added].next = *at;
    *at = added;
  }
};

/// A part of a ray in one cell, between places where the scalar is known.
struct WalkPart
{
  int ray = 0;
  std::uint32_t cell = 0;
  float z[2], value[2];
  bool isCut[2]; ///< at its ends, which then are within the cell
  float bend;    ///< see WalkCells::bends()
};

/// Does what is seldom: parts of rays that are not as good as lines, or look like something that
/// WalkTransfer does not tell.
class SeldomParts
{
public:
  virtual ~SeldomParts() = default;
  /// Adds a part to what the ray has gathered: red, green, blue and transmittance.
  virtual void add(const WalkPart& part, float* color) = 0;
};

/// All that rays need on their way.
struct WalkTask
{
  const WalkCells* cells = nullptr;
  const WalkView* view = nullptr;
  const WalkTransfer* transfer = nullptr;
  const HiddenCells* hidden = nullptr; ///< null: none
  int axis = 2;                        ///< k, see WalkRays
  bool isBackwards = false;            ///< depth is the third coordinate's opposite
  WalkRays rays;
  WalkEntries entries;
  SeldomParts* seldom = nullptr;
  std::vector<RayRun>* runs = nullptr; ///< one for each ray; or null: nobody asks for runs
  bool isAllSeldom = false;            ///< every part is
  float leastTransmittance = 0.0f;
  /// A part is a line where bend times rate times transmittance is below `allowed`.
  float rate = 0.0f, allowed = 0.0f;
  float allowedShare = 0.0f; ///< the same where the bend is that of the ray's own way
  float allowedOff = 0.0f;   ///< the same for what is estimated and no bound
  float share = 0.0f;        ///< of errors that changing colours make, each of a part's opacity
  // Counts; the caller sets them to 0.
  std::uint64_t steps = 0, fallbacks = 0, seldomParts = 0;

  /// Depth of a coordinate along the axis.
  float depth(float z) const { return isBackwards ? -z : z; }
};

/// The faces by which a ray enters a cell, at about depth z, and leaves it; or noFace. Decided by
/// all its crossings with the cell where winding numbers do not tell.
struct WalkFaces
{
  std::uint8_t in, out;
};
WalkFaces seldomFaces(WalkTask& task, std::size_t ray, std::uint32_t cell, float z);

/// Adds the entries that a ray has by a face of the boundary.
void addSeldomEntries(WalkTask& task, std::size_t ray, const WalkView::Face& face);

/// Finds the entries of all rays by some faces of the view.
void testEntries(WalkTask& task, const std::vector<std::uint32_t>& faces);

/// Walks, from the entries on. Only where canWalk() says so: it needs four lanes.
void walkRays(WalkTask& task);
bool canWalk();

} // namespace mote
