#include "FacedCell.h"

#include "../core/Error.h"
#include "TrilinearCell.h"
#include "detail/CellFaces.h"

#include <algorithm>
#include <cmath>

namespace mote
{

namespace
{

/// By how much of its volume a part's Jacobian may be negative at a corner. Files hold points in
/// float, and those in the middle of an edge are beside it by as much.
constexpr double roundedCorner = 1e-5;

/// The part of a face's volume that a part with the wrong sign may have.
constexpr double roundedPart = 1e-6;

/// A quadrilateral's least corner area by its largest, below which it is cut into triangles.
constexpr double leastCorner = 1e-3;

} // namespace

void refusePoint(double id, std::size_t points, std::size_t cell)
{
  throw Error("Cell " + std::to_string(cell) + " names the point " +
              std::to_string(static_cast<long long>(id)) + ", and there are " +
              std::to_string(points) + " points.");
}

void FacedCell::clear()
{
  faces_.clear();
  ids_.clear();
  polygons_.clear();
  all_.clear();
}

void FacedCell::addFace(const std::int64_t* ids, std::size_t count)
{
  faces_.push_back(static_cast<std::int64_t>(count));
  faces_.insert(faces_.end(), ids, ids + count);
}

void FacedCell::read(
  const ArrayView& faces, std::size_t location, std::size_t cell, std::size_t points)
{
  const auto next = [&]
  {
    if (location >= faces.count())
      throw Error("The faces of cell " + std::to_string(cell) + " reach beyond the list of faces.");
    return faces.value(location++);
  };
  clear();
  for (double count = next(); count > 0.0; --count)
  {
    face_.clear();
    for (double n = next(); n > 0.0; --n)
      face_.push_back(checkedPoint(next(), points, cell));
    addFace(face_.data(), face_.size());
  }
}

void FacedCell::setCell(const std::array<std::int64_t, 8>& corners)
{
  clear();
  for (const auto& face : faceCorners)
  {
    const std::int64_t ids[4] = {
      corners[face[0]], corners[face[1]], corners[face[2]], corners[face[3]]};
    addFace(ids, 4);
  }
}

void FacedCell::complete()
{
  ids_.clear();
  const auto forFaces = [this](const auto& visit)
  {
    for (std::size_t at = 0; at < faces_.size(); at += 1 + static_cast<std::size_t>(faces_[at]))
      visit(faces_.data() + at + 1, static_cast<std::size_t>(faces_[at]));
  };
  forFaces(
    [this](const std::int64_t* ids, std::size_t n) { ids_.insert(ids_.end(), ids, ids + n); });
  std::sort(ids_.begin(), ids_.end());
  ids_.erase(std::unique(ids_.begin(), ids_.end()), ids_.end());
  polygons_.clear();
  all_.clear();
  forFaces(
    [this](const std::int64_t* ids, std::size_t n)
    {
      scratch_.clear();
      for (std::size_t i = 0; i < n; ++i)
        scratch_.push_back(static_cast<std::uint32_t>(
          std::lower_bound(ids_.begin(), ids_.end(), ids[i]) - ids_.begin()));
      addPolygon(scratch_.data(), n);
    });
}

void FacedCell::addPolygon(const std::uint32_t* places, std::size_t count)
{
  Polygon polygon{polygons_.size(), 0, false};
  for (std::size_t i = 0; i < count; ++i)
    if (places[i] != places[(i + 1) % count]) // corners that coincide
      polygons_.push_back(places[i]);
  polygon.count = polygons_.size() - polygon.first;
  const auto begin = polygons_.begin() + static_cast<std::ptrdiff_t>(polygon.first);
  if (polygon.count < 3)
  {
    polygons_.erase(begin, polygons_.end());
    return;
  }
  std::rotate(begin, std::min_element(begin, polygons_.end()), polygons_.end());
  polygon.isTurned = polygons_.back() < begin[1];
  if (polygon.isTurned)
    std::reverse(begin + 1, polygons_.end());
  all_.push_back(polygon);
}

std::optional<FacedCell::Part> FacedCell::whole() const
{
  const auto isTriangle = [](const Polygon& p) { return p.count == 3; };
  const auto triangles = std::count_if(all_.begin(), all_.end(), isTriangle);
  if (all_.size() < 4 || all_.size() > 6 || ids_.size() > 8 ||
      std::any_of(all_.begin(), all_.end(), [](const Polygon& p) { return p.count > 4; }))
    return {};
  // The base is what a pyramid has one of, and a wedge two.
  const bool onTriangle = triangles == 2 || all_.size() == 4;
  const auto base = std::find_if(
    all_.begin(), all_.end(), [&](const Polygon& p) { return isTriangle(p) == onTriangle; });
  if (base == all_.end())
    return {};
  const std::uint32_t* const p = polygons_.data() + base->first;
  const auto isOfBase = [&](std::uint32_t q)
  { return std::find(p, p + base->count, q) != p + base->count; };
  Part corners;
  for (std::size_t i = 0; i < 4; ++i)
  {
    corners[i] = p[std::min(i, base->count - 1)];
    corners[i + 4] = middlePlace();
    for (const Polygon& face : all_)
      for (std::size_t k = 0; k < face.count; ++k)
      {
        const std::uint32_t a = polygons_[face.first + k];
        const std::uint32_t b = polygons_[face.first + (k + 1) % face.count];
        if ((a == corners[i] || b == corners[i]) && !isOfBase(a == corners[i] ? b : a))
          corners[i + 4] = a == corners[i] ? b : a;
      }
    if (corners[i + 4] == middlePlace())
      return {};
  }
  // It is this cell if it has the same faces.
  FacedCell other;
  other.ids_ = ids_;
  for (const auto& face : faceCorners)
  {
    const Patch patch = {corners[face[0]], corners[face[1]], corners[face[2]], corners[face[3]]};
    other.addPolygon(patch.data(), 4);
  }
  const auto sorted = [](const FacedCell& cell)
  {
    std::vector<Patch> faces;
    for (const Polygon& face : cell.all_)
    {
      const std::uint32_t* const q = cell.polygons_.data() + face.first;
      faces.push_back({q[0], q[1], q[2], q[face.count - 1]});
    }
    std::sort(faces.begin(), faces.end());
    return faces;
  };
  return sorted(*this) == sorted(other) ? std::optional(corners) : std::nullopt;
}

/// The least area of the triangles of a fan, by how much they look the polygon's own way.
double FacedCell::fanQuality(const std::uint32_t* p, std::size_t n, std::size_t start) const
{
  const auto at = [&](std::size_t i) { return places[p[i % n]] - places[p[0]]; };
  Vec3d normal(0.0);
  for (std::size_t i = 1; i + 1 < n; ++i)
    normal += glm::cross(at(i), at(i + 1));
  double least = HUGE_VAL;
  for (std::size_t i = 1; i + 1 < n; ++i)
    least = std::min(least,
      glm::dot(normal, glm::cross(at(start + i) - at(start), at(start + i + 1) - at(start))));
  return least;
}

bool FacedCell::isConvex(const Patch& patch) const
{
  const auto at = [&](std::size_t i) { return places[patch[i % 4]]; };
  const Vec3d normal = glm::cross(at(2) - at(0), at(3) - at(1));
  double least = HUGE_VAL, most = 0.0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const double area = glm::dot(normal, glm::cross(at(i + 1) - at(i), at(i + 3) - at(i)));
    least = std::min(least, area);
    most = std::max(most, area);
  }
  return least > leastCorner * most;
}

void FacedCell::makePatches(const Polygon& polygon)
{
  patches_.clear();
  const std::uint32_t* const p = polygons_.data() + polygon.first;
  const std::size_t n = polygon.count;
  if (n <= 4)
  {
    patches_.push_back({p[0], p[1], p[2], p[n - 1]});
    return;
  }
  std::size_t start = 0;
  double best = -HUGE_VAL;
  for (std::size_t k = 0; k < n; ++k)
    if (const double quality = fanQuality(p, n, k); quality > best)
    {
      best = quality;
      start = k;
    }
  const auto at = [&](std::size_t i) { return p[(start + i) % n]; };
  for (std::size_t i = 1; i + 1 < n; ++i)
  {
    const Patch two = {at(0), at(i), at(i + 1), at(i + 2)};
    const bool isQuad = i + 2 < n && isConvex(two);
    patches_.push_back(isQuad ? two : Patch{at(0), at(i), at(i + 1), at(i + 1)});
    i += isQuad ? 1 : 0;
  }
}

HexCorners FacedCell::cornersOf(const Part& part) const
{
  HexCorners corners;
  for (std::size_t i = 0; i < 8; ++i)
    corners[i] = part[i] == middlePlace() ? middle_ : places[part[i]];
  return corners;
}

bool FacedCell::cutFace(const Polygon& polygon)
{
  makePatches(polygon);
  const std::uint32_t m = middlePlace();
  double sum = 0.0;
  bool isFlat = true;
  for (const Patch& p : patches_)
  {
    const HexCorners corners = cornersOf({p[0], p[1], p[2], p[3], m, m, m, m});
    const double volume = cellVolume(corners);
    sum += volume;
    isFlat = isFlat && std::abs(volume) <= negligibleVolume(corners);
  }
  // Bases are listed as the middle sees them; faces that it sees edge on, as they were, turned.
  const bool turn = isFlat ? !polygon.isTurned : sum < 0.0;
  const std::uint32_t* const p = polygons_.data() + polygon.first;
  for (std::size_t i = 0; i < polygon.count; ++i)
  {
    const std::uint32_t a = p[i], b = p[(i + 1) % polygon.count];
    edges_.push_back({turn ? b : a, turn ? a : b});
  }
  for (const Patch& q : patches_)
  {
    const bool isTriangle = q[2] == q[3];
    Part part = {q[0], q[1], q[2], q[3], m, m, m, m};
    if (turn)
      part = {q[0], q[isTriangle ? 2 : 3], q[isTriangle ? 1 : 2], q[1], m, m, m, m};
    const HexCorners corners = cornersOf(part);
    const JacobianRange range = jacobianRange(corners);
    if (std::abs(range.volume) <= negligibleVolume(corners))
      continue;
    if (range.volume < 0.0 && -range.volume < roundedPart * std::abs(sum))
      continue;
    if (range.volume < 0.0 || -range.smallest > roundedCorner * range.volume)
      return false;
    parts_.push_back(part);
    volume_ += range.volume;
  }
  return true;
}

bool FacedCell::isClosed()
{
  std::sort(edges_.begin(), edges_.end());
  return std::adjacent_find(edges_.begin(), edges_.end()) == edges_.end() &&
         std::all_of(edges_.begin(), edges_.end(),
           [this](const auto& e) {
             return std::binary_search(edges_.begin(), edges_.end(), std::array{e[1], e[0]});
           });
}

bool FacedCell::cut()
{
  parts_.clear();
  edges_.clear();
  volume_ = 0.0;
  middle_ = Vec3d(0.0);
  if (ids_.empty())
    return false;
  for (const Vec3d& p : places)
    middle_ += p - places[0];
  middle_ = places[0] + middle_ / static_cast<double>(places.size());
  for (const Polygon& polygon : all_)
    if (!cutFace(polygon))
      return false;
  return !parts_.empty() && isClosed();
}

} // namespace mote
