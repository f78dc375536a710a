#include "FaceAdjacency.h"

#include "../core/Error.h"
#include "detail/Blocks.h"
#include "detail/CellFaces.h"

#include <algorithm>
#include <atomic>
#include <tuple>
#include <vector>

namespace mote
{

namespace
{

/// Marks collapsed faces until the boundary is known; no cell has this number.
constexpr std::uint32_t collapsed = HexMesh::noCell - 1;

/// The points of a face, from the least one on.
struct FacePoints
{
  std::uint32_t least = 0;
  std::array<std::uint32_t, 3> others{}; ///< lesser neighbour of the least, across, other neighbour
  bool isTurned = false;                 ///< the other neighbour comes first
  bool isCollapsed = true;

  FacePoints(const HexMesh::Cell& cell, std::size_t face)
  {
    std::array<std::uint32_t, 4> p;
    std::size_t n = 0;
    for (const std::uint8_t corner : faceCorners[face])
      if (n == 0 || p[n - 1] != cell[corner])
        p[n++] = cell[corner];
    n -= n > 1 && p[n - 1] == p[0] ? 1 : 0;
    if (n < 3 || (n == 4 && (p[0] == p[2] || p[1] == p[3])))
      return;
    isCollapsed = false;
    const auto end = p.begin() + static_cast<std::ptrdiff_t>(n);
    std::rotate(p.begin(), std::min_element(p.begin(), end), end);
    isTurned = p[n - 1] < p[1];
    least = p[0];
    others = {std::min(p[1], p[n - 1]), n == 4 ? p[2] : HexMesh::noCell, std::max(p[1], p[n - 1])};
  }
};

/// One of the faces that have the same least point.
struct Candidate
{
  std::array<std::uint32_t, 3> others;
  std::uint32_t face; ///< 6 cell + face
  bool isTurned;
};

using Next = RawVector<std::array<std::uint32_t, 6>>;

/// Pairs faces of one least point: in each group of the same points, those of one direction with
/// those of the other in the order of their numbers.
void pair(std::vector<Candidate>& faces, Next& next)
{
  std::sort(faces.begin(), faces.end(),
    [](const Candidate& a, const Candidate& b)
    { return std::tie(a.others, a.isTurned, a.face) < std::tie(b.others, b.isTurned, b.face); });
  for (auto first = faces.begin(); first != faces.end();)
  {
    const auto end = std::find_if(
      first, faces.end(), [&](const Candidate& c) { return c.others != first->others; });
    auto turned = std::find_if(first, end, [](const Candidate& c) { return c.isTurned; });
    for (auto one = first, last = turned; one != last && turned != end; ++one, ++turned)
    {
      const std::uint32_t a = one->face, b = turned->face;
      if (a / 6 == b / 6)
        continue;
      next[a / 6][a % 6] = b / 6;
      next[b / 6][b % 6] = a / 6;
    }
    first = end;
  }
}

} // namespace

FaceAdjacency::FaceAdjacency(const HexMesh& mesh)
  : next_(mesh.cellCount())
{
  const std::size_t cells = mesh.cellCount();
  if (cells >= collapsed / 6)
    throw Error("Rays can go from cell to cell through up to 715,827,881 cells.");
  // The faces of each least point, one range of an array after another.
  RawVector<std::uint32_t> begins(mesh.allPointCount() + 1);
  forBlocks(begins.size(), [&](std::size_t p) { begins[p] = 0; });
  forBlocks(cells,
    [&](std::size_t c)
    {
      for (std::size_t f = 0; f < 6; ++f)
      {
        const FacePoints face(mesh.cell(c), f);
        next_[c][f] = face.isCollapsed ? collapsed : HexMesh::noCell;
        if (!face.isCollapsed)
          std::atomic_ref(begins[face.least]).fetch_add(1, std::memory_order_relaxed);
      }
    });
  std::uint32_t sum = 0;
  for (std::uint32_t& begin : begins)
    begin = sum += begin;
  RawVector<std::uint32_t> faces(sum);
  forBlocks(cells,
    [&](std::size_t c)
    {
      for (std::size_t f = 0; f < 6; ++f)
        if (const FacePoints face(mesh.cell(c), f); !face.isCollapsed)
          faces[std::atomic_ref(begins[face.least]).fetch_sub(1, std::memory_order_relaxed) - 1] =
            static_cast<std::uint32_t>(6 * c + f);
    });
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.allPointCount(), 1 << 13),
    [&](const tbb::blocked_range<std::size_t>& block)
    {
      std::vector<Candidate> group;
      for (std::size_t p = block.begin(); p < block.end(); ++p)
      {
        group.clear();
        for (std::uint32_t i = begins[p]; i < begins[p + 1]; ++i)
        {
          const FacePoints face(mesh.cell(faces[i] / 6), faces[i] % 6);
          group.push_back({face.others, faces[i], face.isTurned});
        }
        pair(group, next_);
      }
    });
  for (std::uint32_t c = 0; c < cells; ++c)
    for (std::uint8_t f = 0; f < 6; ++f)
      if (next_[c][f] == HexMesh::noCell)
        boundary_.push_back({c, f});
      else if (next_[c][f] == collapsed)
        next_[c][f] = HexMesh::noCell;
  boundary_.shrink_to_fit();
}

std::size_t FaceAdjacency::bytes() const
{
  return next_.capacity() * sizeof(next_[0]) + boundary_.capacity() * sizeof(boundary_[0]);
}

} // namespace mote
