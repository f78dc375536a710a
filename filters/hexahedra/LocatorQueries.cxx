#include "LocatorQueries.h"

#include "kernels/hexahedra/TrilinearCell.h"

#include "vtkCellArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>

namespace mote
{

namespace
{

/// Calls visit(CellSpan) along the line from `from` to `to`, its end included.
template <class Visit>
void forSpans(
  const LocatorStructure& structure, const Vec3d& from, const Vec3d& to, const Visit& visit)
{
  const HexRay ray{from, to - from, 0.0, std::nextafter(1.0, 2.0)};
  withStructure(*structure.structure, [&](const auto& s) { s.forCellsAlong(ray, visit); });
}

bool isLine(const Vec3d& from, const Vec3d& to)
{
  const double length = glm::length(to - from);
  return length > 0.0 && std::isfinite(length);
}

/// Takes a cell where it is closer than what was found.
void tryCell(
  ClosestCell& best, vtkDataSet* data, vtkIdType id, const Vec3d& p, vtkGenericCell* cell)
{
  data->GetCell(id, cell);
  double pcoords[3], distance2 = 0.0;
  std::vector<double> weights(static_cast<std::size_t>(cell->GetNumberOfPoints()));
  Vec3d point;
  int subId = 0;
  int answer = cell->EvaluatePosition(&p.x, &point.x, subId, pcoords, distance2, weights.data());
  if (answer < 0) // VTK's cell did not find out: its corners are no further than it is
  {
    distance2 = std::numeric_limits<double>::infinity();
    for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
    {
      Vec3d corner;
      cell->GetPoints()->GetPoint(i, &corner.x);
      const Vec3d d = corner - p;
      if (glm::dot(d, d) < distance2)
      {
        distance2 = glm::dot(d, d);
        point = corner;
      }
    }
  }
  else if (answer > 0)
    point = p;
  if (best.cell < 0 || distance2 < best.distance2)
    best = {id, point, answer > 0 ? 0.0 : distance2, subId, answer > 0};
}

double distanceTo(const Box& box, const Vec3d& p)
{
  return glm::length(glm::max(glm::max(box.lower - p, p - box.upper), Vec3d(0.0)));
}

class Lines
{
public:
  explicit Lines(vtkPolyData* into)
  {
    into->SetPoints(points_);
    into->SetLines(lines_);
  }
  void add(const std::vector<Vec3d>& points)
  {
    lines_->InsertNextCell(static_cast<int>(points.size()));
    for (const Vec3d& p : points)
      lines_->InsertCellPoint(points_->InsertNextPoint(&p.x));
  }

private:
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> lines_;
};

/// Of a polyhedron: weights by the part that holds the point, whose middle is the mean of all of
/// the cell's points; coordinates as VTK has them, by the bounds.
void evaluatePart(const HexMesh& mesh, std::uint32_t part, vtkGenericCell* cell, const Vec3d& p,
  double pcoords[3], double* weights)
{
  const double* const b = cell->GetBounds();
  for (int k = 0; k < 3; ++k)
    pcoords[k] = (p[k] - b[2 * k]) / (b[2 * k + 1] - b[2 * k]);
  if (!weights)
    return;
  Vec3d rst(0.5);
  TrilinearCell(mesh, part).coordinates(p, rst);
  const CornerValues own = TrilinearCell::weights(rst);
  std::fill_n(weights, cell->GetNumberOfPoints(), 0.0);
  const auto add = [&](std::uint32_t point, double weight)
  { weights[std::max<vtkIdType>(0, cell->GetPointIds()->IsId(point))] += weight; };
  for (std::size_t i = 0; i < 8; ++i)
    if (const std::uint32_t point = mesh.cell(part)[i]; point < mesh.pointCount())
      add(point, own[i]);
    else
      for (const auto around = mesh.aroundMiddle(point - mesh.pointCount());
           const std::uint32_t one : around)
        add(one, own[i] / static_cast<double>(around.size()));
}

void addCylinder(Lines& lines, const HexMesh& mesh, const CylinderAxis& axis)
{
  const Vec3d h = glm::normalize(axis.direction);
  double low = std::numeric_limits<double>::infinity(), high = -low, radius = 0.0;
  for (std::size_t c = 0; c < mesh.cellCount(); ++c)
    for (const Vec3d& p : mesh.corners(c))
    {
      const Vec3d v = p - axis.origin;
      const double along = glm::dot(v, h);
      low = std::min(low, along);
      high = std::max(high, along);
      radius = std::max(radius, glm::length(v - along * h));
    }
  const Vec3d x = glm::normalize(
    glm::cross(h, std::abs(h.x) < 0.5 ? Vec3d(1.0, 0.0, 0.0) : Vec3d(0.0, 1.0, 0.0)));
  const Vec3d y = glm::cross(h, x);
  constexpr int sides = 64;
  const auto at = [&](int i, double along)
  {
    const double angle = 6.283185307179586 * i / sides;
    return axis.origin + along * h + radius * (std::cos(angle) * x + std::sin(angle) * y);
  };
  for (const double along : {low, high})
  {
    std::vector<Vec3d> rim;
    for (int i = 0; i <= sides; ++i)
      rim.push_back(at(i, along));
    lines.add(rim);
  }
  for (int i = 0; i < sides; i += sides / 4)
    lines.add({at(i, low), at(i, high)});
  lines.add({axis.origin + low * h, axis.origin + high * h});
}

} // namespace

void evaluate(const HexMesh& mesh, std::uint32_t part, vtkGenericCell* cell, const Vec3d& p,
  double pcoords[3], double* weights)
{
  const int type = cell->GetCellType();
  if (type == static_cast<int>(HexCellType::Polyhedron))
  {
    evaluatePart(mesh, part, cell, p, pcoords, weights);
    return;
  }
  const CollapsedCorners collapsed = collapsedCorners(type);
  HexCorners corners;
  for (std::size_t i = 0; i < 8; ++i)
    cell->GetPoints()->GetPoint(collapsed.of[i], &corners[i].x);
  Vec3d rst(0.5);
  TrilinearCell(corners).coordinates(p, rst);
  const CornerValues trilinear = TrilinearCell::weights(rst);
  double own[8] = {};
  for (std::size_t i = 0; i < 8; ++i)
    own[collapsed.of[i]] += trilinear[i];
  if (weights)
    std::copy_n(own, collapsed.points, weights);
  // Of a triangle VTK's coordinates are the weights of its last two points.
  switch (static_cast<HexCellType>(type))
  {
  case HexCellType::Tetrahedron:
    std::copy_n(own + 1, 3, pcoords);
    break;
  case HexCellType::Wedge:
    pcoords[0] = own[1] + own[4];
    pcoords[1] = own[2] + own[5];
    pcoords[2] = rst.z;
    break;
  default:
    std::copy_n(&rst.x, 3, pcoords);
  }
}

std::vector<vtkIdType> cellsAlong(
  const LocatorStructure& structure, const Vec3d& from, const Vec3d& to)
{
  const HexMesh& mesh = *structure.mesh;
  std::vector<vtkIdType> cells;
  if (!isLine(from, to))
  {
    if (const std::uint32_t c = structure.cellAt(from); c != HexMesh::noCell)
      cells.push_back(static_cast<vtkIdType>(mesh.inputCell(c)));
    return cells;
  }
  std::unordered_set<vtkIdType> told; // a cell may be entered more than once
  forSpans(structure, from, to,
    [&](const CellSpan& span)
    {
      const auto id = static_cast<vtkIdType>(mesh.inputCell(span.cell));
      if (told.insert(id).second)
        cells.push_back(id);
      return true;
    });
  return cells;
}

FaceHit firstFace(const LocatorStructure& structure, const Vec3d& from, const Vec3d& to)
{
  FaceHit hit;
  const HexMesh& mesh = *structure.mesh;
  if (!isLine(from, to))
    return hit;
  // Where the line begins in a cell, that cell's exit is a face, and the next cell's entry the
  // same.
  bool isExit = false;
  forSpans(structure, from, to,
    [&](const CellSpan& span)
    {
      if (isExit && span.tIn > hit.t)
        return false;
      const bool isInside =
        isExit && mesh.inputCell(span.cell) == mesh.inputCell(hit.cell); // from part to part
      if (span.inFace != noFace && !isInside)
      {
        hit = {span.cell, span.tIn};
        isExit = false;
        return false;
      }
      if (!isExit || isInside || span.tOut < hit.t)
        hit = {span.cell, isInside ? std::max(hit.t, span.tOut) : span.tOut};
      isExit = true;
      return true;
    });
  if (hit.t > 1.0) // the line ends in the cell
    hit.cell = HexMesh::noCell;
  return hit;
}

ClosestCell closestCell(const LocatorStructure& structure, vtkDataSet* data, const Vec3d& p,
  double radius, vtkGenericCell* scratch)
{
  ClosestCell best;
  const HexMesh& mesh = *structure.mesh;
  if (mesh.cellCount() == 0 || !std::isfinite(p.x + p.y + p.z) || !(radius >= 0.0))
    return best;
  if (const std::uint32_t c = structure.cellAt(p); c != HexMesh::noCell)
  {
    best = {static_cast<vtkIdType>(mesh.inputCell(c)), p, 0.0, 0, true};
    return best;
  }
  const double size = glm::length(mesh.bounds().size());
  const double away = distanceTo(mesh.bounds(), p);
  // Boxes that grow until they reach as far as the closest cell that they met.
  double reach =
    away +
    std::min(size, 2.0 * std::cbrt(mesh.report().volume / static_cast<double>(mesh.cellCount())));
  while (true)
  {
    reach = std::min(reach, radius);
    const Box box{p - Vec3d(reach), p + Vec3d(reach)};
    for (const std::uint32_t c : cellsWithin(*structure.structure, box))
    {
      const double nearest = distanceTo(boundsOf(mesh.corners(c)), p);
      if (best.cell < 0 || nearest * nearest < best.distance2)
        tryCell(best, data, static_cast<vtkIdType>(mesh.inputCell(c)), p, scratch);
    }
    const double found = best.cell < 0 ? reach + size : std::sqrt(best.distance2);
    if (found <= reach || reach >= radius || reach > away + size)
      break;
    reach = std::min(2.0 * reach, std::nextafter(found, 2.0 * found));
  }
  if (best.cell >= 0 && best.distance2 > radius * radius)
    best.cell = -1;
  return best;
}

void outline(const LocatorStructure& structure, vtkPolyData* into)
{
  const HexMesh& mesh = *structure.mesh;
  if (mesh.cellCount() == 0)
    return;
  Lines lines(into);
  if (structure.axis)
  {
    addCylinder(lines, mesh, *structure.axis);
    return;
  }
  const HexCorners c = cornersOf(mesh.bounds());
  lines.add({c[0], c[1], c[2], c[3], c[0]});
  lines.add({c[4], c[5], c[6], c[7], c[4]});
  for (std::size_t i = 0; i < 4; ++i)
    lines.add({c[i], c[i + 4]});
}

} // namespace mote
