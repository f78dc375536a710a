// What a change of what is shown leaves of occlusion maps.

#include "../core/Error.h"
#include "OcclusionBake.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace mote
{

namespace
{

/// A grid of cells over a box, each with a mark.
class MarkedCells
{
public:
  /// Cells of about `size`, and not more than 256 along a side.
  MarkedCells(const Box& bounds, double size)
    : lower_(bounds.lower)
  {
    const Vec3d extent = bounds.size();
    edge_ = std::max(size, std::max({extent.x, extent.y, extent.z}) / 256.0);
    for (int k = 0; k < 3; ++k)
      count_[k] = edge_ > 0.0 ? static_cast<int>(extent[k] / edge_) + 1 : 1;
    marks_.assign(static_cast<std::size_t>(count_.x) * static_cast<std::size_t>(count_.y) *
                    static_cast<std::size_t>(count_.z),
      0);
  }

  /// Marks the cells that a box about a point overlaps.
  void mark(const Vec3d& point, double half)
  {
    forCells(point, half,
      [this](std::size_t cell)
      {
        marks_[cell] = 1;
        return false;
      });
  }
  bool isMarked(const Vec3d& point, double half) const
  {
    return forCells(point, half, [this](std::size_t cell) { return marks_[cell] != 0; });
  }
  /// Marks all within `distance` of the marked ones, along each axis.
  void widen(double distance)
  {
    const auto x = static_cast<std::size_t>(count_.x), y = static_cast<std::size_t>(count_.y);
    const auto z = static_cast<std::size_t>(count_.z);
    widenAlong(distance, x, 1, y * z, [=](std::size_t line) { return line * x; });
    widenAlong(
      distance, y, x, x * z, [=](std::size_t line) { return line / x * x * y + line % x; });
    widenAlong(distance, z, x * y, x * y, [](std::size_t line) { return line; });
  }

private:
  /// Calls visit(cell) for the cells that a box overlaps until it answers true; whether it did.
  template <typename Visit>
  bool forCells(const Vec3d& point, double half, const Visit& visit) const
  {
    Vec3i first, last;
    for (int k = 0; k < 3; ++k)
    {
      const double most = count_[k] - 1.0;
      first[k] = static_cast<int>(std::clamp((point[k] - half - lower_[k]) / edge_, 0.0, most));
      last[k] = static_cast<int>(std::clamp((point[k] + half - lower_[k]) / edge_, 0.0, most));
    }
    for (int z = first.z; z <= last.z; ++z)
      for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x)
          if (visit((static_cast<std::size_t>(z) * static_cast<std::size_t>(count_.y) +
                      static_cast<std::size_t>(y)) *
                      static_cast<std::size_t>(count_.x) +
                    static_cast<std::size_t>(x)))
            return true;
    return false;
  }

  template <typename First>
  void widenAlong(
    double distance, std::size_t length, std::size_t step, std::size_t lines, const First& firstOf)
  {
    const auto by =
      static_cast<std::size_t>(std::min(std::ceil(distance / edge_), static_cast<double>(length)));
    tbb::parallel_for(std::size_t{0}, lines,
      [&](std::size_t line)
      {
        std::uint8_t* cells = marks_.data() + firstOf(line);
        std::vector<std::uint32_t> before(length + 1, 0); // marked cells before each
        for (std::size_t i = 0; i < length; ++i)
          before[i + 1] = before[i] + cells[i * step];
        for (std::size_t i = 0; i < length; ++i)
          cells[i * step] =
            before[std::min(i + by + 1, length)] > before[i > by ? i - by : 0] ? 1 : 0;
      });
  }

  Vec3d lower_;
  double edge_;
  Vec3i count_;
  std::vector<std::uint8_t> marks_;
};

} // namespace

std::vector<std::uint64_t> shownBits(const ParticleStructure& structure)
{
  return withStructure(structure,
    [](const auto& s)
    {
      std::vector<std::uint64_t> bits((s.size() + 63) / 64);
      tbb::parallel_for(std::size_t{0}, bits.size(),
        [&](std::size_t word)
        {
          const std::size_t first = 64 * word, end = std::min(s.size(), first + 64);
          for (std::size_t slot = first; slot < end; ++slot)
            bits[word] |= std::uint64_t{s.isShown(slot)} << (slot - first);
        });
      return bits;
    });
}

OcclusionMaps stillValid(const OcclusionMaps& maps, const ParticleStructure& structure,
  const std::vector<std::uint64_t>& shownBefore, double reach)
{
  const std::vector<std::uint64_t> shown = shownBits(structure);
  return withStructure(structure,
    [&](const auto& s)
    {
      if (maps.size() != s.size() || shownBefore.size() != shown.size())
        throw Error("These occlusion maps belong to another structure.");
      const Vec3d size = s.statistics().bounds.size();
      const double far = std::min(reach, size.x + size.y + size.z); // all of it
      MarkedCells cells(s.statistics().bounds, 0.25 * far);
      bool changed = false;
      for (std::size_t word = 0; word < shown.size(); ++word)
        for (std::uint64_t bits = shown[word] ^ shownBefore[word]; bits != 0; bits &= bits - 1)
        {
          const std::size_t slot = 64 * word + static_cast<unsigned>(std::countr_zero(bits));
          cells.mark(s.center(slot), s.radius(slot));
          changed = true;
        }
      if (!changed)
        return maps;
      cells.widen(far);
      return maps.without(
        [&](std::size_t slot) { return cells.isMarked(s.center(slot), s.radius(slot)); });
    });
}

} // namespace mote
