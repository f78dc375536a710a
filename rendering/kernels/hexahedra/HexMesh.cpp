#include "HexMesh.h"

#include "../core/Error.h"
#include "TrilinearCell.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace mote
{

namespace
{

enum class Fate : std::uint8_t
{
  Kept,
  Inverted,
  SelfCrossing,
  SelfCrossingInverted,
  OtherType,
  NonFinite,
  TooFar,
  ZeroVolume
};

void checkArrays(const HexMeshInput& input)
{
  const std::size_t n = input.types.count();
  if (input.points.count() > 0 && input.points.components() != 3)
    throw Error("Points of cells need three components.");
  if (n > 0 && input.offsets.count() != n + 1)
    throw Error("There are " + std::to_string(input.offsets.count()) + " offsets for " +
                std::to_string(n) + " cells; one more than cells is needed.");
  if (n >= HexMesh::noCell || input.points.count() >= HexMesh::noCell)
    throw Error("A mesh of hexahedra takes up to 4294967294 points and cells.");
}

/// Where cell `i` begins in the connectivity. Throws where the cell does not fit its type.
std::size_t checkedOffset(const HexMeshInput& input, std::size_t i, int points)
{
  const double first = input.offsets.value(i), last = input.offsets.value(i + 1);
  if (!(first >= 0.0 && last <= static_cast<double>(input.connectivity.count())))
    throw Error("The offsets of cell " + std::to_string(i) + " point outside of the connectivity.");
  if (last - first != points)
    throw Error("Cell " + std::to_string(i) + " has " +
                std::to_string(static_cast<long long>(last - first)) +
                " points where its type has " + std::to_string(points) + ".");
  return static_cast<std::size_t>(first);
}

/// The size below which a cell's volume is nothing but rounding: of the product of its mean edges
/// along r, s and t, and of its points' own places.
double negligibleVolume(const HexCorners& p)
{
  double edges[3] = {}, place = 0.0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const std::size_t r[4] = {0, 3, 4, 7}, s[4] = {0, 1, 4, 5};
    edges[0] += 0.25 * glm::length(p[r[i] ^ 1] - p[r[i]]);
    edges[1] += 0.25 * glm::length(p[s[i] ^ 3] - p[s[i]]);
    edges[2] += 0.25 * glm::length(p[i + 4] - p[i]);
  }
  for (const Vec3d& q : p)
    place = std::max({place, std::abs(q.x), std::abs(q.y), std::abs(q.z)});
  const double area = std::max({edges[0] * edges[1], edges[1] * edges[2], edges[2] * edges[0]});
  return 1e-12 * edges[0] * edges[1] * edges[2] + 1e-15 * place * area;
}

struct Looked
{
  Fate fate = Fate::OtherType;
  HexMesh::Cell cell{};
  double volume = 0.0;
};

void mirror(HexMesh::Cell& cell)
{
  for (std::size_t i = 0; i < 8; i += 2)
    std::swap(cell[i], cell[i + 1]);
}

Looked lookAt(const HexMeshInput& input, const RawVector<Vec3d>& points, std::size_t i)
{
  Looked looked;
  const double type = input.types.value(i);
  const CollapsedCorners corners = collapsedCorners(static_cast<int>(type));
  if (corners.points == 0)
    return looked;
  const std::size_t first = checkedOffset(input, i, corners.points);
  HexCorners p;
  bool finite = true, near = true;
  for (std::size_t k = 0; k < 8; ++k)
  {
    const double id = input.connectivity.value(first + corners.of[k]);
    if (!(id >= 0.0 && id < static_cast<double>(points.size())))
      throw Error("Cell " + std::to_string(i) + " names the point " +
                  std::to_string(static_cast<long long>(id)) + ", and there are " +
                  std::to_string(points.size()) + " points.");
    looked.cell[k] = static_cast<std::uint32_t>(id);
    p[k] = points[looked.cell[k]];
    for (int a = 0; a < 3; ++a)
    {
      finite = finite && std::isfinite(p[k][a]);
      near = near && std::abs(p[k][a]) <= farthestPoint;
    }
  }
  looked.fate = finite ? Fate::TooFar : Fate::NonFinite;
  if (!near)
    return looked;
  const JacobianRange range = jacobianRange(p);
  looked.volume = std::abs(range.volume);
  looked.fate = Fate::ZeroVolume;
  if (looked.volume <= negligibleVolume(p))
    return looked;
  const bool insideOut = range.volume < 0.0;
  const double against = insideOut ? range.largest : -range.smallest;
  const bool crossing = against > 1e-9 * looked.volume;
  if (insideOut)
    mirror(looked.cell);
  if (type == static_cast<double>(HexCellType::Wedge) || !insideOut)
    looked.fate = crossing ? Fate::SelfCrossing : Fate::Kept;
  else
    looked.fate = crossing ? Fate::SelfCrossingInverted : Fate::Inverted;
  return looked;
}

bool isKept(Fate fate)
{
  return fate < Fate::OtherType;
}

void count(HexMeshReport& report, Fate fate, double type)
{
  report.inverted += fate == Fate::Inverted || fate == Fate::SelfCrossingInverted;
  report.selfCrossing += fate == Fate::SelfCrossing || fate == Fate::SelfCrossingInverted;
  report.otherTypes += fate == Fate::OtherType;
  report.nonFinite += fate == Fate::NonFinite;
  report.tooFar += fate == Fate::TooFar;
  report.zeroVolume += fate == Fate::ZeroVolume;
  if (!isKept(fate))
    return;
  ++report.kept;
  const auto is = [type](HexCellType t) { return type == static_cast<double>(t); };
  report.hexahedra += is(HexCellType::Hexahedron) || is(HexCellType::Voxel);
  report.wedges += is(HexCellType::Wedge);
  report.pyramids += is(HexCellType::Pyramid);
  report.tetrahedra += is(HexCellType::Tetrahedron);
}

} // namespace

CollapsedCorners collapsedCorners(int type)
{
  switch (type)
  {
  case static_cast<int>(HexCellType::Tetrahedron):
    return {4, {0, 1, 2, 2, 3, 3, 3, 3}};
  case static_cast<int>(HexCellType::Voxel):
    return {8, {0, 1, 3, 2, 4, 5, 7, 6}};
  case static_cast<int>(HexCellType::Hexahedron):
    return {8, {0, 1, 2, 3, 4, 5, 6, 7}};
  case static_cast<int>(HexCellType::Wedge):
    // The order that vtkWedge's own coordinates have. Files have both orders.
    return {6, {0, 2, 1, 1, 3, 5, 4, 4}};
  case static_cast<int>(HexCellType::Pyramid):
    return {5, {0, 1, 2, 3, 4, 4, 4, 4}};
  default:
    return {};
  }
}

std::string HexMeshReport::sentence() const
{
  std::string text;
  const auto add = [&text](std::size_t number, const char* what)
  {
    if (number > 0)
      text += (text.empty() ? "" : ", ") + std::to_string(number) + " " + what;
  };
  add(otherTypes, "of other types left out");
  add(nonFinite, "with points that are not finite left out");
  add(tooFar, "with points beyond 1e30 left out");
  add(zeroVolume, "of no volume left out");
  add(inverted, "listed inside out and mirrored");
  add(selfCrossing, "crossing themselves");
  return text.empty() ? text : "Of " + std::to_string(cells) + " cells: " + text + ".";
}

HexMesh::HexMesh(const HexMeshInput& input)
{
  checkArrays(input);
  const std::size_t n = input.types.count();
  points_.resize(input.points.count());
  const auto everyPoint = [&](const tbb::blocked_range<std::size_t>& range)
  {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      points_[i] = {input.points.value(i, 0), input.points.value(i, 1), input.points.value(i, 2)};
  };
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points_.size(), 1 << 14), everyPoint);

  RawVector<Fate> fates(n);
  cells_.resize(n);
  // Sums over fixed blocks, so that no rounding depends on the number of threads.
  constexpr std::size_t block = 4096;
  const std::size_t blocks = (n + block - 1) / block;
  std::vector<HexMeshReport> reports(blocks);
  std::vector<Box> boxes(blocks);
  tbb::parallel_for(std::size_t(0), blocks,
    [&](std::size_t b)
    {
      for (std::size_t i = b * block; i < std::min(n, (b + 1) * block); ++i)
      {
        const Looked looked = lookAt(input, points_, i);
        fates[i] = looked.fate;
        cells_[i] = looked.cell;
        count(reports[b], looked.fate, input.types.value(i));
        if (!isKept(looked.fate))
          continue;
        reports[b].volume += looked.volume;
        for (const std::uint32_t k : looked.cell)
          boxes[b].add(points_[k]);
      }
    });
  report_.cells = n;
  for (std::size_t b = 0; b < blocks; ++b)
  {
    const HexMeshReport& r = reports[b];
    for (const auto member : {&HexMeshReport::kept, &HexMeshReport::hexahedra,
           &HexMeshReport::wedges, &HexMeshReport::pyramids, &HexMeshReport::tetrahedra,
           &HexMeshReport::otherTypes, &HexMeshReport::nonFinite, &HexMeshReport::tooFar,
           &HexMeshReport::zeroVolume, &HexMeshReport::inverted, &HexMeshReport::selfCrossing})
      report_.*member += r.*member;
    report_.volume += r.volume;
    bounds_.add(boxes[b]);
  }
  if (report_.kept == n)
    return;
  inputCells_.resize(report_.kept);
  std::size_t to = 0;
  for (std::size_t i = 0; i < n; ++i)
    if (isKept(fates[i]))
    {
      cells_[to] = cells_[i];
      inputCells_[to++] = static_cast<std::uint32_t>(i);
    }
  cells_.resize(to);
  cells_.shrink_to_fit();
}

std::size_t HexMesh::bytes() const
{
  return points_.capacity() * sizeof(Vec3d) + cells_.capacity() * sizeof(Cell) +
         inputCells_.capacity() * sizeof(std::uint32_t);
}

double cellVolume(const HexCorners& corners)
{
  return jacobianRange(corners).volume;
}

Vec3d cellCenter(const HexCorners& corners)
{
  Vec3d sum(0.0);
  for (std::size_t i = 1; i < 8; ++i)
    sum += corners[i] - corners[0];
  return corners[0] + 0.125 * sum;
}

Box boundsOf(const HexCorners& corners)
{
  Box box;
  for (const Vec3d& p : corners)
    box.add(p);
  return box;
}

HexCorners cornersOf(const Box& box)
{
  const Vec3d &a = box.lower, &b = box.upper;
  return {a, {b.x, a.y, a.z}, {b.x, b.y, a.z}, {a.x, b.y, a.z}, {a.x, a.y, b.z}, {b.x, a.y, b.z}, b,
    {a.x, b.y, b.z}};
}

} // namespace mote
