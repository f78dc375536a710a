#include "CoherentGrid.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace mote
{

std::size_t CoherentGrid::bytes() const
{
  return records_.capacity() * sizeof(Record) + cellStart_.capacity() * sizeof(std::uint32_t) +
         rowStart_.capacity() * sizeof(std::uint64_t) + macrocellShown_.capacity() +
         index32_.capacity() * sizeof(std::uint32_t) + index64_.capacity() * sizeof(std::uint64_t) +
         shown_.capacity() * sizeof(std::uint64_t);
}

int CoherentGrid::bundleSide(const CameraRays&, int, int, int) const
{
  return 8;
}

void CoherentGrid::clear()
{
  statistics_ = {};
  origin_ = Vec3d(0.0);
  unit_ = 1.0;
  resolution_ = macroResolution_ = Vec3i(0);
  largestRadius_ = 0.0f;
  count_ = 0;
  records_.clear();
  cellStart_.clear();
  rowStart_.clear();
  macrocellShown_.clear();
  index32_.clear();
  index64_.clear();
  shown_.clear();
}

void CoherentGrid::setVisibility(const std::function<bool(std::size_t)>& shown)
{
  shown_.clear();
  if (shown && count_ > 0)
  {
    shown_.resize((count_ + 63) / 64);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, shown_.size(), 256),
      [&](const tbb::blocked_range<std::size_t>& words)
      {
        for (std::size_t w = words.begin(); w != words.end(); ++w)
        {
          std::uint64_t bits = 0;
          const std::size_t first = 64 * w, last = std::min(count_, first + 64);
          for (std::size_t slot = first; slot < last; ++slot)
            bits |= static_cast<std::uint64_t>(shown(slot)) << (slot - first);
          shown_[w] = bits;
        }
      });
  }
  markMacrocells();
}

void CoherentGrid::markMacrocells()
{
  const auto isShown = [&](std::size_t first, std::size_t last)
  {
    if (shown_.empty())
      return first < last;
    for (std::size_t slot = first; slot < last; ++slot)
      if ((shown_[slot / 64] >> (slot % 64)) & 1)
        return true;
    return false;
  };
  const Vec3i macro = macroResolution_;
  macrocellShown_.resize(static_cast<std::size_t>(macro.x) * macro.y * macro.z);
  const auto markRow = [&](int y, int z, std::uint8_t* marks)
  {
    const std::size_t row = static_cast<std::size_t>(z) * resolution_.y + y;
    const std::uint32_t* start = &cellStart_[row * (resolution_.x + 1)];
    for (int x = 0; x < macro.x; ++x)
    {
      const int last = std::min(resolution_.x, (x + 1) * macrocellSize);
      if (!marks[x])
        marks[x] = isShown(rowStart_[row] + start[x * macrocellSize], rowStart_[row] + start[last]);
    }
  };
  tbb::parallel_for(tbb::blocked_range<int>(0, macro.y * macro.z),
    [&](const tbb::blocked_range<int>& range)
    {
      for (int i = range.begin(); i != range.end(); ++i)
      {
        std::uint8_t* marks = &macrocellShown_[static_cast<std::size_t>(i) * macro.x];
        std::fill(marks, marks + macro.x, std::uint8_t{0});
        const int y0 = (i % macro.y) * macrocellSize, z0 = (i / macro.y) * macrocellSize;
        for (int z = z0; z < std::min(resolution_.z, z0 + macrocellSize); ++z)
          for (int y = y0; y < std::min(resolution_.y, y0 + macrocellSize); ++y)
            markRow(y, z, marks);
      }
    });
}

} // namespace mote
