#include "OcclusionMaps.h"

#include "../core/Error.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace mote
{

namespace
{

/// Texels of the two particles whose levels a byte holds.
constexpr std::array<std::uint16_t, 256> texelsOfPair = []
{
  std::array<std::uint16_t, 256> texels{};
  const auto one = [](unsigned level)
  {
    return level >= OcclusionMaps::Side1 && level <= OcclusionMaps::Side32 ? 1u << (2 * (level - 1))
                                                                           : 0u;
  };
  for (unsigned pair = 0; pair < 256; ++pair)
    texels[pair] = static_cast<std::uint16_t>(one(pair & 15) + one(pair >> 4));
  return texels;
}();

constexpr std::uint8_t noMap[4] = {}; ///< 2 x 2 texels

std::size_t texelsOfLevels(std::uint64_t levels)
{
  std::size_t sum = 0;
  for (int k = 0; k < 64; k += 8)
    sum += texelsOfPair[levels >> k & 255];
  return sum;
}

} // namespace

OcclusionMaps::Level OcclusionMaps::levelOf(int side)
{
  for (int level = Side1; level <= Side32; ++level)
    if (side == OcclusionMaps::side(static_cast<Level>(level)))
      return static_cast<Level>(level);
  throw Error("Occlusion maps have 1, 2, 4, 8, 16 or 32 texels along a side, not " +
              std::to_string(side) + ".");
}

OcclusionMaps::OcclusionMaps(std::size_t count, const OcclusionSky& sky)
  : count_(count)
  , sky_(sky)
{
  if (!(sky.top >= 0.0f && sky.bottom >= 0.0f && sky.top + sky.bottom > 0.0f &&
        std::isfinite(sky.top + sky.bottom)))
    throw Error("The sky of occlusion maps must be bright at its top or its bottom, and not "
                "negative.");
  blocks_.resize((count + blockSize - 1) / blockSize);
  std::fill(blocks_.begin(), blocks_.end(), Block());
}

OcclusionMaps::OcclusionMaps(std::span<const Piece> pieces, const OcclusionSky& sky)
  : OcclusionMaps(
      [pieces]
      {
        std::size_t count = 0;
        for (const Piece& piece : pieces)
          count += piece.levels.size();
        return count;
      }(),
      sky)
{
  std::size_t particle = 0;
  for (const Piece& piece : pieces)
  {
    std::size_t texels = 0;
    for (const std::uint8_t level : piece.levels)
    {
      if (!isLevel(level))
        throw Error("Occlusion maps have no level " + std::to_string(level) + ".");
      texels += texelsOf(static_cast<Level>(level));
      setLevel(particle++, static_cast<Level>(level));
    }
    if (texels != piece.texels.size())
      throw Error("Occlusion maps should have " + std::to_string(texels) + " texels, not " +
                  std::to_string(piece.texels.size()) + ".");
  }
  makeTexels();
  auto to = texels_.begin();
  for (const Piece& piece : pieces)
    to = std::copy(piece.texels.begin(), piece.texels.end(), to);
}

void OcclusionMaps::setLevel(std::size_t particle, Level level)
{
  std::uint64_t& levels = blocks_[particle / blockSize].levels;
  const auto shift = 4 * (particle % blockSize);
  levels = (levels & ~(std::uint64_t{15} << shift)) | std::uint64_t{level} << shift;
}

std::size_t OcclusionMaps::placeBlocks()
{
  std::size_t texels = 0;
  for (Block& block : blocks_)
  {
    block.first = texels;
    texels += texelsOfLevels(block.levels);
  }
  return texels;
}

void OcclusionMaps::makeTexels()
{
  texels_.resize(placeBlocks());
}

std::size_t OcclusionMaps::firstTexel(std::size_t particle) const
{
  const Block& block = blocks_[particle / blockSize];
  const std::uint64_t before = (std::uint64_t{1} << (4 * (particle % blockSize))) - 1;
  return block.first + texelsOfLevels(block.levels & before);
}

std::span<const std::uint8_t> OcclusionMaps::texels(std::size_t particle) const
{
  return {texels_.data() + firstTexel(particle), texelsOf(level(particle))};
}

std::uint8_t OcclusionMaps::encoded(float value) const
{
  const float share = std::clamp(value / maximum(), 0.0f, 1.0f);
  // The nearest byte in value, not in its root: half-way between q and q + 1 lies q^2 + q + 1/2.
  const int q = static_cast<int>(255.0f * std::sqrt(share));
  const float half = (static_cast<float>(q) * static_cast<float>(q + 1) + 0.5f) / (255.0f * 255.0f);
  return static_cast<std::uint8_t>(std::min(q + (share > half), 255));
}

float OcclusionMaps::decoded(float byte) const
{
  return maximum() * (byte * byte / (255.0f * 255.0f));
}

float OcclusionMaps::at(std::size_t particle, const Vec3f& normal) const
{
  float value;
  const std::uint64_t one = particle;
  lookUp(&one, &normal.x, &normal.y, &normal.z, 1, &value);
  return value;
}

void OcclusionMaps::lookUp(const std::uint64_t* particles, const float* nx, const float* ny,
  const float* nz, int count, float* values) const
{
  OcclusionLookUp found;
  for (int first = 0; first < count; first += OcclusionLookUp::capacity)
  {
    const int some = std::min(count - first, OcclusionLookUp::capacity);
    find(particles + first, some, found);
    lookUp(found, particles + first, nx + first, ny + first, nz + first, values + first);
  }
}

void OcclusionMaps::fetch(const std::uint64_t* particles, int count) const
{
  for (int i = 0; i < count; ++i)
    __builtin_prefetch(&blocks_[particles[i] / blockSize]);
}

void OcclusionMaps::find(const std::uint64_t* particles, int count, OcclusionLookUp& found) const
{
  // A bundle sees a few particles again and again, though not always in a row.
  struct Seen
  {
    const std::uint8_t* map;
    std::int32_t shift;
  };
  constexpr int places = 64;
  std::uint64_t keys[places];
  Seen seen[places];
  std::fill_n(keys, places, std::numeric_limits<std::uint64_t>::max());
  found.count = count;
  found.plains = 0;
  for (int i = 0; i < count; ++i)
  {
    const std::uint64_t particle = particles[i];
    const std::uint64_t place = particle * 0x9e3779b97f4a7c15U >> 58;
    Seen& entry = seen[place];
    if (keys[place] != particle)
    {
      keys[place] = particle;
      const Level level = this->level(particle);
      const bool isMap = level >= Side2 && level <= Side32;
      entry = {isMap ? texels_.data() + firstTexel(particle) : noMap, isMap ? level - Side1 : 1};
      for (int line = 0; line < 1 << (2 * entry.shift); line += 64)
        __builtin_prefetch(entry.map + line);
    }
    found.map[i] = entry.map;
    found.shift[i] = entry.shift;
    found.plain[found.plains] = static_cast<std::uint16_t>(i);
    found.plains += entry.map == noMap;
  }
  // Lanes beyond the last are worked out, too, and not used.
  for (int i = count; i < (count + 15) / 16 * 16; ++i)
    found.shift[i] = 1;
}

void OcclusionMaps::lookUp(const OcclusionLookUp& found, const std::uint64_t* particles,
  const float* nx, const float* ny, const float* nz, float* values) const
{
  if (found.plains < found.count)
    found.blend(nx, ny, nz, maximum(), values);
  for (int k = 0; k < found.plains; ++k)
  {
    const int i = found.plain[k];
    values[i] = plainValue(particles[i], {nx[i], ny[i], nz[i]});
  }
}

float OcclusionMaps::plainValue(std::size_t particle, const Vec3f& normal) const
{
  switch (level(particle))
  {
  case Side1:
    return decoded(texels_[firstTexel(particle)]);
  case Open:
    return sky_.onOpen(normal);
  case Dark:
    return 0.0f;
  default:
    return std::numeric_limits<float>::quiet_NaN();
  }
}

template <typename Source>
OcclusionMaps OcclusionMaps::gathered(std::size_t count, const Source& source) const
{
  OcclusionMaps maps(count, sky_);
  tbb::parallel_for(std::size_t{0}, maps.blocks_.size(),
    [&](std::size_t block)
    {
      const std::size_t end = std::min(count, (block + 1) * blockSize);
      for (std::size_t k = block * blockSize; k < end; ++k)
        if (const std::size_t from = source(k); from < count_)
          maps.setLevel(k, level(from));
    });
  maps.makeTexels();
  tbb::parallel_for(std::size_t{0}, maps.blocks_.size(),
    [&](std::size_t block)
    {
      auto to = maps.texels_.begin() + static_cast<std::ptrdiff_t>(maps.blocks_[block].first);
      const std::size_t end = std::min(count, (block + 1) * blockSize);
      for (std::size_t k = block * blockSize; k < end; ++k)
        if (const std::size_t from = source(k); from < count_)
        {
          const auto map = texels(from);
          to = std::copy(map.begin(), map.end(), to);
        }
    });
  return maps;
}

OcclusionMaps OcclusionMaps::updated(const OcclusionMaps& newer) const
{
  if (newer.size() != size() || newer.sky() != sky())
    throw Error("Occlusion maps of other particles or of another sky do not go together.");
  OcclusionMaps maps(count_, sky_);
  const auto source = [&](std::size_t k) -> const OcclusionMaps&
  { return newer.isBaked(k) ? newer : *this; };
  for (std::size_t k = 0; k < count_; ++k)
    maps.setLevel(k, source(k).level(k));
  maps.makeTexels();
  auto to = maps.texels_.begin();
  for (std::size_t k = 0; k < count_; ++k)
  {
    const auto map = source(k).texels(k);
    to = std::copy(map.begin(), map.end(), to);
  }
  return maps;
}

OcclusionMaps OcclusionMaps::without(const std::function<bool(std::size_t particle)>& forgets) const
{
  return gathered(count_, [&](std::size_t k) { return isBaked(k) && forgets(k) ? count_ : k; });
}

OcclusionMaps OcclusionMaps::inInputOrder(
  const ParticleStructure& structure, std::size_t inputs) const
{
  return withStructure(structure,
    [&](const auto& s)
    {
      if (s.size() != count_)
        throw Error("These occlusion maps belong to another structure.");
      std::vector<std::uint64_t> slots(inputs, std::numeric_limits<std::uint64_t>::max());
      for (std::size_t slot = 0; slot < count_; ++slot)
      {
        const std::uint64_t input = s.inputIndex(slot);
        if (input >= inputs)
          throw Error("The structure holds particles beyond the input.");
        slots[input] = slot;
      }
      return gathered(inputs, [&](std::size_t k) { return slots[k]; });
    });
}

OcclusionMaps OcclusionMaps::inSlotOrder(const ParticleStructure& structure) const
{
  return withStructure(structure,
    [&](const auto& s)
    {
      return gathered(s.size(),
        [&](std::size_t slot)
        {
          const std::uint64_t input = s.inputIndex(slot);
          if (input >= count_)
            throw Error("The structure holds particles beyond the occlusion maps.");
          return input;
        });
    });
}

} // namespace mote
