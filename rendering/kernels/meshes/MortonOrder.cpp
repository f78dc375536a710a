#include "detail/MortonOrder.h"

#include <glm/common.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace mote
{

namespace
{

constexpr std::size_t chunk = 1 << 16; ///< triangles that one task handles
constexpr int digitBits = 10;
constexpr std::size_t digits = std::size_t{1} << digitBits;

/// Ten bits, two zeros between each.
std::uint32_t spread(std::uint32_t v)
{
  v = (v | v << 16) & 0x030000FFU;
  v = (v | v << 8) & 0x0300F00FU;
  v = (v | v << 4) & 0x030C30C3U;
  return (v | v << 2) & 0x09249249U;
}

/// The code of twice the middle of a triangle's box; coordinates lie in [-1, 1].
std::uint32_t codeOf(const Vec3f& a, const Vec3f& b, const Vec3f& c)
{
  const Vec3f sum = glm::min(glm::min(a, b), c) + glm::max(glm::max(a, b), c);
  const Vec3f place = glm::clamp((sum + 2.0f) * 256.0f, 0.0f, 1023.0f);
  return spread(static_cast<std::uint32_t>(place.x)) << 2 |
         spread(static_cast<std::uint32_t>(place.y)) << 1 |
         spread(static_cast<std::uint32_t>(place.z));
}

/// Calls visit(chunk, begin, end) for all chunks of `count` things in parallel.
template <typename Visit>
void forChunks(std::size_t count, const Visit& visit)
{
  tbb::parallel_for(std::size_t{0}, (count + chunk - 1) / chunk,
    [&](std::size_t k) { visit(k, k * chunk, std::min(count, (k + 1) * chunk)); });
}

RawVector<std::uint64_t> codesOfValid(const TriangleMesh& mesh)
{
  std::vector<std::size_t> first((mesh.size() + chunk - 1) / chunk + 1, 0);
  const bool allValid = mesh.validCount() == mesh.size();
  forChunks(mesh.size(),
    [&](std::size_t k, std::size_t begin, std::size_t end)
    {
      for (std::size_t t = begin; t != end; ++t)
        first[k + 1] += allValid || mesh.isValid(t);
    });
  for (std::size_t k = 1; k < first.size(); ++k)
    first[k] += first[k - 1];
  RawVector<std::uint64_t> codes(first.back());
  forChunks(mesh.size(),
    [&](std::size_t k, std::size_t begin, std::size_t end)
    {
      std::uint64_t* to = codes.data() + first[k];
      const Vec3f* points = mesh.points();
      for (std::size_t t = begin; t != end; ++t)
        if (allValid || mesh.isValid(t))
        {
          const TriangleMesh::Corners& c = mesh.triangles()[t];
          *to++ = std::uint64_t{codeOf(points[c[0]], points[c[1]], points[c[2]])} << 32 | t;
        }
    });
  return codes;
}

} // namespace

RawVector<std::uint64_t> mortonOrder(const TriangleMesh& mesh)
{
  RawVector<std::uint64_t> codes = codesOfValid(mesh), sorted(codes.size());
  // By digits from the lowest: each pass keeps the order of equal digits.
  std::vector<std::array<std::uint32_t, digits>> places((codes.size() + chunk - 1) / chunk);
  for (int shift = 32; shift < 32 + mortonBits; shift += digitBits)
  {
    const auto digitOf = [shift](std::uint64_t code) { return code >> shift & (digits - 1); };
    forChunks(codes.size(),
      [&](std::size_t k, std::size_t begin, std::size_t end)
      {
        places[k].fill(0);
        for (std::size_t i = begin; i != end; ++i)
          ++places[k][digitOf(codes[i])];
      });
    std::uint32_t place = 0;
    for (std::size_t digit = 0; digit < digits; ++digit)
      for (auto& counts : places)
        place += std::exchange(counts[digit], place);
    forChunks(codes.size(),
      [&](std::size_t k, std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i != end; ++i)
          sorted[places[k][digitOf(codes[i])]++] = codes[i];
      });
    codes.swap(sorted);
  }
  return codes;
}

} // namespace mote
