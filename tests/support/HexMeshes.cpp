#include "HexMeshes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <set>

namespace mote::testing
{

std::size_t HexCells::addPoint(const Vec3d& p)
{
  points.insert(points.end(), {p.x, p.y, p.z});
  return points.size() / 3 - 1;
}

void HexCells::addCell(HexCellType type, const std::vector<std::int64_t>& ids)
{
  types.push_back(static_cast<std::uint8_t>(type));
  connectivity.insert(connectivity.end(), ids.begin(), ids.end());
  offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  faceLocations.push_back(-1);
}

void HexCells::addPolyhedron(const std::vector<std::vector<std::int64_t>>& polygons)
{
  std::set<std::int64_t> ids;
  for (const auto& polygon : polygons)
    ids.insert(polygon.begin(), polygon.end());
  addCell(HexCellType::Polyhedron, std::vector<std::int64_t>(ids.begin(), ids.end()));
  faceLocations.back() = static_cast<std::int64_t>(faces.size());
  faces.push_back(static_cast<std::int64_t>(polygons.size()));
  for (const auto& polygon : polygons)
  {
    faces.push_back(static_cast<std::int64_t>(polygon.size()));
    faces.insert(faces.end(), polygon.begin(), polygon.end());
  }
}

void HexCells::addCell(HexCellType type, const std::vector<Vec3d>& corners)
{
  std::vector<std::int64_t> ids;
  for (const Vec3d& p : corners)
    ids.push_back(static_cast<std::int64_t>(addPoint(p)));
  addCell(type, ids);
}

void HexCells::move(const std::function<Vec3d(const Vec3d&)>& to)
{
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    const Vec3d p = to({points[i], points[i + 1], points[i + 2]});
    points[i] = p.x, points[i + 1] = p.y, points[i + 2] = p.z;
  }
}

HexMeshInput HexCells::input() const
{
  return {{points.data(), points.size() / 3, 3},
    {types.data(), ArrayView::Type::UInt8, types.size(), 1},
    {offsets.data(), ArrayView::Type::Int64, offsets.size(), 1},
    {connectivity.data(), ArrayView::Type::Int64, connectivity.size(), 1},
    {faces.data(), ArrayView::Type::Int64, faces.size(), 1},
    {faceLocations.data(), ArrayView::Type::Int64, faces.empty() ? 0 : faceLocations.size(), 1}};
}

namespace
{

/// The hexahedra of a lattice of points; `around` closes the second direction.
void addLattice(HexCells& cells, int nx, int ny, int nz, bool around = false)
{
  const int py = around ? ny : ny + 1;
  const auto id = [&](int i, int j, int k)
  { return static_cast<std::int64_t>((k * py + j % py) * (nx + 1) + i); };
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        cells.addCell(HexCellType::Hexahedron,
          {id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k), id(i, j + 1, k), id(i, j, k + 1),
            id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1)});
}

} // namespace

HexCells merged(const HexCells& cells, const std::vector<std::vector<std::size_t>>& groups)
{
  constexpr int corners[6][4] = {
    {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 4, 7, 3}, {1, 2, 6, 5}};
  HexCells all;
  all.points = cells.points;
  const auto pointsOf = [&](std::size_t c)
  {
    return std::vector(cells.connectivity.begin() + cells.offsets[c],
      cells.connectivity.begin() + cells.offsets[c + 1]);
  };
  for (std::size_t c = 0; c < cells.types.size(); ++c)
  {
    const auto group = std::find_if(groups.begin(), groups.end(),
      [c](const auto& g) { return std::find(g.begin(), g.end(), c) != g.end(); });
    if (group == groups.end())
      all.addCell(static_cast<HexCellType>(cells.types[c]), pointsOf(c));
    else if (group->front() == c)
    {
      std::map<std::set<std::int64_t>, std::vector<std::int64_t>> faces;
      for (const std::size_t one : *group)
        for (const auto& face : corners)
        {
          const auto ids = pointsOf(one);
          const std::vector<std::int64_t> polygon = {
            ids[face[0]], ids[face[1]], ids[face[2]], ids[face[3]]};
          const std::set<std::int64_t> key(polygon.begin(), polygon.end());
          if (!faces.insert({key, polygon}).second)
            faces.erase(key);
        }
      std::vector<std::vector<std::int64_t>> polygons;
      for (const auto& [key, polygon] : faces)
        polygons.push_back(polygon);
      all.addPolyhedron(polygons);
    }
  }
  return all;
}

std::vector<Vec3d> foamMiddles(int n)
{
  std::vector<Vec3d> middles;
  for (int i = 0; i < 2 * n * n * n; ++i)
    middles.push_back(2.0 * Vec3d(i / 2 % n, i / 2 / n % n, i / 2 / n / n) + Vec3d(i % 2));
  return middles;
}

std::vector<Vec3d> foamNormals()
{
  std::vector<Vec3d> normals = {
    {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (int k = 0; k < 8; ++k)
    normals.emplace_back(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
  return normals;
}

HexCells refinedBlock()
{
  HexCells cells;
  SharedPoints points{cells, {}};
  const std::function<void(Vec3d, double, int)> add = [&](Vec3d low, double size, int level)
  {
    const int n = level == 1 ? 4 : 2;
    for (int i = 0; i < n * n * n; ++i)
    {
      const double h = size / n;
      const Vec3d at = low + h * Vec3d(i % n, i / n % n, i / (n * n));
      if ((level == 0 && i == 7) || (level == 1 && i == 21))
      {
        add(at, h, level + 1);
        continue;
      }
      std::vector<std::int64_t> corners;
      for (const Vec3d& c : cornersOf(Box{at, at + h}))
        corners.push_back(points.at(c));
      cells.addCell(HexCellType::Hexahedron, corners);
    }
  };
  add(Vec3d(0.0), 2.0, 0);
  return cells;
}

HexCells foam(int n)
{
  std::vector<Vec3d> corners; // all places of 0, +-1/2 and +-1
  for (int k = 0; k < 6; ++k)
    for (int s = 0; s < 4; ++s)
    {
      Vec3d p(0.0);
      p[k % 3] = s & 1 ? 0.5 : -0.5;
      p[(k % 3 + 1 + k / 3) % 3] = s & 2 ? 1.0 : -1.0;
      corners.push_back(p);
    }
  HexCells cells;
  SharedPoints points{cells, {}};
  for (const Vec3d& at : foamMiddles(n))
  {
    std::vector<std::vector<std::int64_t>> faces;
    for (const Vec3d& normal : foamNormals())
    {
      const Vec3d x = glm::normalize(glm::cross(normal, Vec3d(0.3, 0.5, -0.7)));
      const Vec3d y = glm::normalize(glm::cross(normal, x));
      std::map<double, Vec3d> around;
      for (const Vec3d& p : corners)
        if (std::abs(glm::dot(normal, p) - foamReach(normal)) < 1e-9)
          around[std::atan2(glm::dot(p, y), glm::dot(p, x))] = p;
      faces.emplace_back();
      for (const auto& [angle, p] : around)
        faces.back().push_back(points.at(at + p));
    }
    cells.addPolyhedron(faces);
  }
  return cells;
}

HexCells hexBlock(int nx, int ny, int nz, double jitter, unsigned seed)
{
  HexCells cells;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-jitter, jitter);
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i)
      {
        const Vec3d by(shift(random), shift(random), shift(random));
        const bool inside = i > 0 && i < nx && j > 0 && j < ny && k > 0 && k < nz;
        cells.addPoint(Vec3d(i, j, k) + (inside ? by : Vec3d(0.0)));
      }
  addLattice(cells, nx, ny, nz);
  return cells;
}

HexCells hexRing(const RingShape& s)
{
  HexCells cells;
  const bool closed = s.turn > 2.0 * std::numbers::pi - 1e-9;
  const int around = closed ? s.around : s.around + 1;
  for (int k = 0; k <= s.axial; ++k)
    for (int j = 0; j < around; ++j)
      for (int i = 0; i <= s.radial; ++i)
      {
        const double u = static_cast<double>(i) / s.radial, w = static_cast<double>(k) / s.axial;
        double v = static_cast<double>(j) / s.around;
        if (s.blades > 0)
          v -= 0.9 * std::sin(2.0 * std::numbers::pi * s.blades * v) /
               (2.0 * std::numbers::pi * s.blades);
        const double angle = s.turn * v + s.twist * (w + u);
        const double r = (s.inner + u * (s.outer - s.inner)) * (1.0 + s.bulge * w * w);
        cells.addPoint({r * std::cos(angle), r * std::sin(angle), s.height * w});
      }
  addLattice(cells, s.radial, s.around, s.axial, closed);
  return cells;
}

std::vector<HexCells> unevenMeshes()
{
  HexCells folded = hexBlock(4, 4, 4, 0.9, 5);
  HexCells far = hexBlock(4, 4, 4, 0.3, 6);
  far.move([](const Vec3d& p) { return p + Vec3d(1e6, -1e5, 3e5); });
  HexCells extruded = hexBlock(5, 5, 3, 0.3, 7);
  extruded.move([](const Vec3d& p) { return Vec3d(p.x, p.y, std::round(p.z)); });
  return {hexBlock(4, 4, 4), hexBlock(5, 4, 3, 0.3, 4), folded, far, extruded,
    hexRing({4, 16, 4, 1.0, 2.0, 1.0, 0.4, 0.2, 3}), hexRing({3, 9, 3, 0.0, 1.0, 1.0})};
}

std::vector<Vec3d> randomPoints(
  std::size_t count, const Vec3d& lower, const Vec3d& upper, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Vec3d> points(count);
  for (Vec3d& p : points)
    for (int k = 0; k < 3; ++k)
      p[k] = lower[k] + unit(random) * (upper[k] - lower[k]);
  return points;
}

} // namespace mote::testing
