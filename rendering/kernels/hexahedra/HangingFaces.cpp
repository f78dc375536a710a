#include "HangingFaces.h"

#include "detail/CellFaces.h"

#include <tbb/blocked_range.h>
#include <tbb/concurrent_vector.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstddef>
#include <utility>

namespace mote
{

namespace
{

using Range = tbb::blocked_range<std::size_t>;
constexpr std::size_t grain = 1 << 12;

/// A direction as one of 26: the middles of a cube's faces and edges, and its corners. That of the
/// opposite one is 26 less it.
unsigned directionOf(const Vec3d& v)
{
  const double tangent = 0.41421356 * std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  const auto sign = [&](double x) { return std::abs(x) <= tangent ? 1U : x < 0.0 ? 0U : 2U; };
  return 9 * sign(v.x) + 3 * sign(v.y) + sign(v.z);
}

/// For each direction those, a bit each, that are at most about 60 degrees from its opposite.
std::array<std::uint32_t, 27> opposites()
{
  const auto vectorOf = [](unsigned i)
  { return Vec3d(double(i / 9) - 1.0, double(i / 3 % 3) - 1.0, double(i % 3) - 1.0); };
  std::array<std::uint32_t, 27> found{};
  for (unsigned i = 0; i < 27; ++i)
    for (unsigned k = 0; k < 27; ++k)
    {
      const Vec3d a = vectorOf(i), b = vectorOf(k);
      if (glm::dot(a, b) < -0.5 * glm::length(a) * glm::length(b))
        found[i] |= 1U << k;
    }
  return found;
}

/// The faces of a surface, and which of them meet at a point.
class HangingFaceFinder
{
public:
  explicit HangingFaceFinder(const FacesInTriangles& input)
    : input_(input)
  {
  }

  std::vector<CoveredFace> find()
  {
    if (!this->lookForOpposedFaces())
      return {};
    this->findFaces();
    this->findFacesAtPoints();
    tbb::concurrent_vector<CoveredFace> found;
    tbb::parallel_for(Range(0, faces_.size(), grain),
      [&](const Range& range)
      {
        std::vector<std::size_t> smaller;
        for (std::size_t f = range.begin(); f < range.end(); ++f)
        {
          if (!this->mayHaveFiner(faces_[f]) ||
              (!this->hasFiner(f, flat, smaller) && !this->hasFiner(f, curved, smaller)))
            continue;
          CoveredFace covered = {faces_[f].triangles, 0.5 * glm::length(faces_[f].normal), {}};
          for (const std::size_t other : smaller)
            covered.smaller.push_back(faces_[other].triangles);
          found.push_back(std::move(covered));
        }
      });
    std::vector<CoveredFace> sorted(found.begin(), found.end());
    std::sort(sorted.begin(), sorted.end(),
      [](const CoveredFace& a, const CoveredFace& b)
      { return std::pair(-a.area, a.larger.first) < std::pair(-b.area, b.larger.first); });
    return sorted;
  }

private:
  struct Face
  {
    FaceRange triangles;
    Vec3d normal{0.0}; ///< twice as long as the face is large
    Vec3d middle{0.0}; ///< of its triangles' middles
  };

  /// How finer faces lie on one: the least cosine of the angle to it, and the farthest that their
  /// middles are from it, in sides of a square as large.
  struct Likeness
  {
    double cosine, distance;
  };
  static constexpr Likeness flat = {0.999, 0.01};
  static constexpr Likeness curved = {0.85, 0.15}; ///< may take in sides of slanting thin cells

  // Arrays are read by their type here. Within every loop these two took GCC over a minute.
  [[gnu::noinline]] std::size_t place(std::size_t triangle, int corner) const
  {
    const auto id = static_cast<std::size_t>(input_.triangles.value(triangle, corner));
    return input_.welds.empty() ? id : static_cast<std::size_t>(input_.welds[id]);
  }
  [[gnu::noinline]] Vec3d at(std::size_t triangle, int corner) const
  {
    const auto id = static_cast<std::size_t>(input_.triangles.value(triangle, corner));
    const ArrayView& points = input_.points;
    return {points.value(id, 0), points.value(id, 1), points.value(id, 2)};
  }
  Vec3d normal(std::size_t triangle) const
  {
    const Vec3d from = at(triangle, 0);
    return glm::cross(at(triangle, 1) - from, at(triangle, 2) - from);
  }

  /// Finds points at which faces look at one another; whether any triangle has such corners alone.
  bool lookForOpposedFaces()
  {
    const std::size_t points = input_.points.count();
    seen_.assign(points, 0);
    tbb::parallel_for(Range(0, input_.triangles.count(), grain),
      [&](const Range& range)
      {
        for (std::size_t t = range.begin(); t < range.end(); ++t)
        {
          const std::uint32_t direction = 1U << directionOf(normal(t));
          for (int k = 0; k < 3; ++k)
            std::atomic_ref(seen_[place(t, k)]).fetch_or(direction, std::memory_order_relaxed);
        }
      });
    const std::array<std::uint32_t, 27> opposite = opposites();
    tbb::parallel_for(Range(0, points, grain),
      [&](const Range& range)
      {
        for (std::size_t p = range.begin(); p < range.end(); ++p)
        {
          bool isOpposed = false;
          for (std::uint32_t left = seen_[p]; left != 0 && !isOpposed; left &= left - 1)
            isOpposed = (seen_[p] & opposite[std::size_t(std::countr_zero(left))]) != 0;
          seen_[p] = isOpposed;
        }
      });
    std::atomic<bool> isAny{false};
    tbb::parallel_for(Range(0, input_.triangles.count(), grain),
      [&](const Range& range)
      {
        for (std::size_t t = range.begin(); t < range.end() && !isAny; ++t)
          if (this->isOpposed(t))
            isAny = true;
      });
    return isAny;
  }
  bool isOpposed(std::size_t triangle) const
  {
    return seen_[place(triangle, 0)] && seen_[place(triangle, 1)] && seen_[place(triangle, 2)];
  }
  bool mayHaveFiner(const Face& face) const
  {
    for (std::size_t t = face.triangles.first; t < face.triangles.end; ++t)
      if (!this->isOpposed(t))
        return false;
    return true;
  }

  void findFaces()
  {
    for (const FaceRange& triangles : facesOf(input_.triangles.count(), input_.edges))
    {
      Face face = {triangles};
      for (std::size_t t = triangles.first; t < triangles.end; ++t)
      {
        face.normal += normal(t);
        face.middle += (at(t, 0) + at(t, 1) + at(t, 2)) / 3.0;
      }
      face.middle /= static_cast<double>(triangles.end - triangles.first);
      faces_.push_back(face);
    }
  }

  template <typename Visit>
  void forPlaces(const Face& face, const Visit& visit) const
  {
    for (std::size_t t = face.triangles.first; t < face.triangles.end; ++t)
      for (int k = 0; k < 3; ++k)
        visit(place(t, k));
  }

  void findFacesAtPoints()
  {
    begins_.assign(seen_.size() + 1, 0);
    for (const Face& face : faces_)
      forPlaces(face, [&](std::size_t p) { ++begins_[p]; });
    std::size_t sum = 0;
    for (std::size_t& begin : begins_)
      begin = sum += begin;
    atPoints_.resize(sum);
    for (std::size_t f = 0; f < faces_.size(); ++f)
      forPlaces(faces_[f], [&](std::size_t p) { atPoints_[--begins_[p]] = f; });
  }

  /// Whether the middle of a face, which looks at another, lies within this one.
  bool isWithin(const Face& face, const Face& larger, const Likeness& likeness) const
  {
    const double length = glm::length(larger.normal);
    if (!(glm::dot(face.normal, larger.normal) <
          -likeness.cosine * glm::length(face.normal) * length))
      return false;
    const Vec3d unit = larger.normal / length;
    if (std::abs(glm::dot(face.middle - larger.middle, unit)) >
        likeness.distance * std::sqrt(0.5 * length))
      return false;
    for (std::size_t t = larger.triangles.first; t < larger.triangles.end; ++t)
    {
      bool isIn = true;
      for (int k = 0; k < 3 && isIn; ++k)
      {
        const Vec3d from = at(t, k), side = at(t, (k + 1) % 3) - from;
        isIn = glm::dot(glm::cross(side, face.middle - from), unit) >= -1e-6 * length;
      }
      if (isIn)
        return true;
    }
    return false;
  }

  /// Gives the faces that cover another one together, if they do: from its corners on, from point
  /// to point.
  bool hasFiner(std::size_t of, const Likeness& likeness, std::vector<std::size_t>& finer) const
  {
    constexpr std::size_t most = 4096; // 64 x 64
    const Face& larger = faces_[of];
    std::vector<std::size_t> places;
    const auto add = [](std::vector<std::size_t>& all, std::size_t one)
    {
      const bool isNew = std::find(all.begin(), all.end(), one) == all.end();
      if (isNew)
        all.push_back(one);
      return isNew;
    };
    forPlaces(larger, [&](std::size_t p) { add(places, p); });
    const std::size_t corners = places.size();
    finer.clear();
    Vec3d sum = larger.normal;
    std::uint64_t met = 0; // of the corners
    for (std::size_t i = 0; i < places.size() && finer.size() < most; ++i)
      for (std::size_t n = begins_[places[i]]; n < begins_[places[i] + 1]; ++n)
      {
        const std::size_t other = atPoints_[n];
        if (other == of || !this->isWithin(faces_[other], larger, likeness) || !add(finer, other))
          continue;
        sum += faces_[other].normal;
        forPlaces(faces_[other],
          [&](std::size_t p)
          {
            add(places, p);
            for (std::size_t k = 0; k < std::min<std::size_t>(corners, 64); ++k)
              met |= std::uint64_t(p == places[k]) << k;
          });
      }
    return finer.size() > 1 && std::size_t(std::popcount(met)) == corners &&
           glm::length(sum) <= 0.1 * glm::length(larger.normal);
  }

  const FacesInTriangles& input_;
  /// Of each point: directions of faces that have it, then whether two of them are opposite.
  std::vector<std::uint32_t> seen_;
  std::vector<Face> faces_;
  std::vector<std::size_t> begins_, atPoints_; ///< of the faces that have a point
};

} // namespace

std::vector<FaceRange> facesOf(std::size_t triangles, std::span<const std::uint8_t> edges)
{
  std::vector<FaceRange> faces;
  std::size_t within = 0; // sides between its triangles, each of two of them
  for (std::size_t t = 0, first = 0; t < triangles; ++t)
  {
    if (!edges.empty())
      within += 3 - static_cast<std::size_t>(std::popcount(edges[t] & 7U));
    // A polygon of n triangles has n - 1 of them.
    if (within != 2 * (t - first) && t + 1 < triangles)
      continue;
    faces.push_back({first, t + 1});
    first = t + 1;
    within = 0;
  }
  return faces;
}

std::vector<CoveredFace> coveredFaces(const FacesInTriangles& faces)
{
  return faces.triangles.empty() ? std::vector<CoveredFace>() : HangingFaceFinder(faces).find();
}

std::vector<std::uint8_t> hangingFaces(const FacesInTriangles& faces)
{
  const std::vector<CoveredFace> covered = coveredFaces(faces);
  if (covered.empty())
    return {};
  std::vector<std::uint8_t> marks(faces.triangles.count(), 0);
  const auto mark = [&](const FaceRange& face)
  { std::fill(marks.begin() + face.first, marks.begin() + face.end, 1); };
  for (const CoveredFace& face : covered)
  {
    mark(face.larger);
    std::for_each(face.smaller.begin(), face.smaller.end(), mark);
  }
  return marks;
}

FaceTriangles::FaceTriangles(const HexMesh& mesh, const RawVector<CellFace>& faces)
{
  for (const CellFace& face : faces)
  {
    std::array<std::uint32_t, 4> p;
    std::size_t n = 0;
    for (const std::uint8_t corner : faceCorners[face.face])
      if (const std::uint32_t id = mesh.cell(face.cell)[corner];
          std::find(p.begin(), p.begin() + n, id) == p.begin() + n)
        p[n++] = id;
    first.push_back(edges.size());
    corners.insert(corners.end(), {p[0], p[1], p[2]});
    edges.push_back(n == 4 ? 3 : 7);
    if (n < 4)
      continue;
    corners.insert(corners.end(), {p[0], p[2], p[3]});
    edges.push_back(6);
  }
  first.push_back(edges.size());
}

RawVector<CellFace> wallsOf(const HexMesh& mesh, const FaceAdjacency& adjacency)
{
  if (adjacency.boundary().empty())
    return {};
  const FaceTriangles faces(mesh, adjacency.boundary());
  const ArrayView corners(faces.corners.data(), ArrayView::Type::UInt32, faces.edges.size(), 3);
  const ArrayView points(&mesh.point(0).x, mesh.allPointCount(), 3);
  const auto marks = hangingFaces({corners, points, faces.edges, {}});
  RawVector<CellFace> walls;
  for (std::size_t f = 0; f < adjacency.boundary().size(); ++f)
    if (marks.empty() || marks[faces.first[f]] == 0)
      walls.push_back(adjacency.boundary()[f]);
  return walls;
}

} // namespace mote
