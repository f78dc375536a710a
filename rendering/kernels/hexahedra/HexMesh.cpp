#include "HexMesh.h"

#include "../core/Error.h"
#include "TrilinearCell.h"
#include "detail/CellIntake.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace mote
{

namespace
{

void checkArrays(const HexMeshInput& input)
{
  const std::size_t n = input.types.count();
  if (input.points.count() > 0 && input.points.components() != 3)
    throw Error("Points of cells need three components.");
  if (n > 0 && input.offsets.count() != n + 1)
    throw Error("There are " + std::to_string(input.offsets.count()) + " offsets for " +
                std::to_string(n) + " cells; one more than cells is needed.");
  if (!input.faceLocations.empty() && input.faceLocations.count() != n)
    throw Error("There are " + std::to_string(input.faceLocations.count()) +
                " places of faces for " + std::to_string(n) + " cells.");
  if (n >= HexMesh::noCell || input.points.count() >= HexMesh::noCell)
    throw Error("A mesh of hexahedra takes up to 4294967294 points and cells.");
}

/// Whether VTK's type is of points, lines or surfaces.
bool isFlat(int type)
{
  static constexpr int flat[] = {
    1, 2, 3, 4, 5, 6, 7, 8, 9, 21, 22, 23, 28, 30, 34, 35, 36, 68, 69, 70, 75, 76, 77};
  return std::binary_search(std::begin(flat), std::end(flat), type);
}

void count(HexMeshReport& report, Fate fate, double type)
{
  report.inverted +=
    fate == Fate::Inverted || fate == Fate::SelfCrossingInverted || fate == Fate::InPartsInverted;
  report.selfCrossing += fate == Fate::SelfCrossing || fate == Fate::SelfCrossingInverted;
  report.otherTypes += fate == Fate::OtherType;
  report.flat += fate == Fate::OtherType && isFlat(static_cast<int>(type));
  report.nonFinite += fate == Fate::NonFinite;
  report.tooFar += fate == Fate::TooFar;
  report.zeroVolume += fate == Fate::ZeroVolume;
  report.unfit += fate == Fate::Unfit;
  if (!isKept(fate))
    return;
  ++report.kept;
  report.inParts += isInParts(fate);
  const auto is = [type](HexCellType t) { return type == static_cast<double>(t); };
  report.hexahedra += is(HexCellType::Hexahedron) || is(HexCellType::Voxel);
  report.wedges += is(HexCellType::Wedge);
  report.pyramids += is(HexCellType::Pyramid);
  report.tetrahedra += is(HexCellType::Tetrahedron);
  report.polyhedra += is(HexCellType::Polyhedron);
}

void copyPoints(RawVector<Vec3d>& to, const ArrayView& from)
{
  to.resize(from.count());
  const auto everyPoint = [&](const tbb::blocked_range<std::size_t>& range)
  {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      to[i] = {from.value(i, 0), from.value(i, 1), from.value(i, 2)};
  };
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, to.size(), 1 << 14), everyPoint);
}

void addCounts(HexMeshReport& to, const HexMeshReport& more)
{
  using R = HexMeshReport;
  for (const auto member : {&R::kept, &R::hexahedra, &R::wedges, &R::pyramids, &R::tetrahedra,
         &R::polyhedra, &R::inParts, &R::otherTypes, &R::flat, &R::unfit, &R::nonFinite, &R::tooFar,
         &R::zeroVolume, &R::inverted, &R::selfCrossing})
    to.*member += more.*member;
  to.volume += more.volume;
}

} // namespace

/// The cells of a block that are in parts.
struct HexMesh::Parts
{
  struct Cut
  {
    std::uint32_t cell = 0; ///< the input's
    Vec3d middle{0.0};
    std::size_t partsEnd = 0, aroundEnd = 0;
  };

  void add(std::size_t cell, const FacedCell& from, Box& box)
  {
    const auto idOf = [&from](std::uint32_t place) {
      return place == from.middlePlace() ? noCell : static_cast<std::uint32_t>(from.ids()[place]);
    };
    for (const FacedCell::Part& part : from.parts())
    {
      cells.emplace_back();
      std::transform(part.begin(), part.end(), cells.back().begin(), idOf);
    }
    around.insert(around.end(), from.ids().begin(), from.ids().end());
    cuts.push_back({static_cast<std::uint32_t>(cell), from.middle(), cells.size(), around.size()});
    for (const Vec3d& p : from.places)
      box.add(p);
  }

  std::vector<Cut> cuts;
  std::vector<Cell> cells; ///< the middle's number is noCell
  std::vector<std::uint32_t> around;
};

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
  // Flat ones are no part of a volume, where there is one.
  add(otherTypes - (kept > 0 ? flat : 0), "of other types left out");
  add(unfit, "polyhedra left out, not closed or too concave to be cut about their middle");
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
  copyPoints(points_, input.points);
  RawVector<Fate> fates(n);
  cells_.resize(n);
  // Sums over fixed blocks, so that no rounding depends on the number of threads.
  constexpr std::size_t block = 4096;
  const std::size_t blocks = (n + block - 1) / block;
  std::vector<HexMeshReport> reports(blocks);
  std::vector<Box> boxes(blocks);
  std::vector<Parts> parts(blocks);
  tbb::parallel_for(std::size_t(0), blocks,
    [&](std::size_t b)
    {
      CellIntake intake(input, points_);
      for (std::size_t i = b * block; i < std::min(n, (b + 1) * block); ++i)
      {
        const CellIntake::Looked looked = intake.look(i);
        fates[i] = looked.fate;
        cells_[i] = looked.cell;
        count(reports[b], looked.fate, input.types.value(i));
        if (!isKept(looked.fate))
          continue;
        reports[b].volume += looked.volume;
        if (isInParts(looked.fate))
          parts[b].add(i, intake.inParts(), boxes[b]);
        else
          for (const std::uint32_t k : looked.cell)
            boxes[b].add(points_[k]);
      }
    });
  report_.cells = n;
  for (std::size_t b = 0; b < blocks; ++b)
  {
    addCounts(report_, reports[b]);
    bounds_.add(boxes[b]);
  }
  if (report_.kept == n && report_.inParts == 0)
    return;
  const std::size_t whole = report_.kept - report_.inParts;
  inputCells_.resize(whole);
  std::size_t to = 0;
  for (std::size_t i = 0; i < n; ++i)
    if (isKept(fates[i]) && !isInParts(fates[i]))
    {
      cells_[to] = cells_[i];
      inputCells_[to++] = static_cast<std::uint32_t>(i);
    }
  cells_.resize(to);
  cells_.shrink_to_fit();
  if (report_.inParts > 0)
    addParts(parts);
}

void HexMesh::addParts(const std::vector<Parts>& parts)
{
  std::size_t cells = cells_.size(), around = 0;
  for (const Parts& p : parts)
  {
    cells += p.cells.size();
    around += p.around.size();
  }
  if (cells >= noCell || points_.size() + report_.inParts >= noCell || around >= noCell)
    throw Error("A mesh takes up to 4294967294 points and cells, and the parts of its polyhedra "
                "and of cells that cross themselves are more.");
  RawVector<Cell> all(cells);
  RawVector<std::uint32_t> of(cells);
  points_.reserve(points_.size() + report_.inParts);
  middleEnds_.reserve(report_.inParts);
  aroundMiddles_.reserve(around);
  std::size_t from = 0, to = 0;
  const auto takeWhole = [&](std::size_t before)
  {
    for (; from < cells_.size() && inputCells_[from] < before; ++from, ++to)
    {
      all[to] = cells_[from];
      of[to] = inputCells_[from];
    }
  };
  for (const Parts& p : parts)
  {
    std::size_t part = 0, point = 0;
    for (const Parts::Cut& cut : p.cuts)
    {
      takeWhole(cut.cell);
      const auto middle = static_cast<std::uint32_t>(points_.size());
      points_.push_back(cut.middle);
      for (; part < cut.partsEnd; ++part, ++to)
      {
        all[to] = p.cells[part];
        std::replace(all[to].begin(), all[to].end(), noCell, middle);
        of[to] = cut.cell;
      }
      for (; point < cut.aroundEnd; ++point)
        aroundMiddles_.push_back(p.around[point]);
      middleEnds_.push_back(static_cast<std::uint32_t>(aroundMiddles_.size()));
    }
  }
  takeWhole(report_.cells);
  cells_ = std::move(all);
  inputCells_ = std::move(of);
}

std::size_t HexMesh::bytes() const
{
  return points_.capacity() * sizeof(Vec3d) + cells_.capacity() * sizeof(Cell) +
         (inputCells_.capacity() + middleEnds_.capacity() + aroundMiddles_.capacity()) *
           sizeof(std::uint32_t);
}

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
