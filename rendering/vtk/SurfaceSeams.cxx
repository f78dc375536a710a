#include "SurfaceSeams.h"

#include "RotatedCopies.h"
#include "SurfaceTriangles.h"

#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <utility>

namespace mote
{

/// The corners of a surface, each once, and its faces: polygons that were cut into triangles, which
/// follow one another.
class SeamSurface::Faces
{
public:
  struct Face
  {
    std::size_t first = 0, end = 0; ///< of its triangles
    Vec3d normal{0.0};
  };

  Faces(const SurfaceTriangles& surface, vtkPoints* points)
    : points_(vtkSmartPointer<vtkPoints>::New())
  {
    const ArrayView triangles = surface.view();
    std::vector<vtkIdType> ids; // ascending
    ids.reserve(3 * triangles.count());
    for (std::size_t t = 0; t < triangles.count(); ++t)
      for (int k = 0; k < 3; ++k)
        ids.push_back(static_cast<vtkIdType>(triangles.value(t, k)));
    corners_.resize(triangles.count());
    std::vector<vtkIdType> all = ids;
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    for (std::size_t i = 0; i < all.size(); ++i)
      corners_[i / 3][i % 3] =
        static_cast<std::size_t>(std::lower_bound(ids.begin(), ids.end(), all[i]) - ids.begin());
    points_->SetDataTypeToDouble();
    points_->SetNumberOfPoints(static_cast<vtkIdType>(ids.size()));
    for (std::size_t i = 0; i < ids.size(); ++i)
      points_->SetPoint(static_cast<vtkIdType>(i), points->GetPoint(ids[i]));
    points_->ComputeBounds();
    this->findFaces(surface.edges);
    this->makeIndex();
  }

  const std::vector<Face>& all() const { return all_; }
  std::size_t triangleCount() const { return corners_.size(); }
  std::size_t cornerCount() const { return static_cast<std::size_t>(points_->GetNumberOfPoints()); }
  Vec3d corner(std::size_t i) const
  {
    Vec3d p;
    points_->GetPoint(static_cast<vtkIdType>(i), &p.x);
    return p;
  }
  /// The corners of a face, ascending, as `numbers` has them; empty where one is below 0.
  void cornersOf(
    const Face& face, const std::vector<vtkIdType>& numbers, std::vector<vtkIdType>& found) const
  {
    found.clear();
    for (std::size_t t = face.first; t < face.end; ++t)
      for (const std::size_t corner : corners_[t])
        found.push_back(numbers[corner]);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    if (found.front() < 0)
      found.clear();
  }
  /// Calls visit(face) for those that have just these corners, which ascend.
  template <typename Visit>
  void find(const std::vector<vtkIdType>& corners, const Visit& visit) const
  {
    const std::uint64_t hash = hashOf(corners);
    std::vector<vtkIdType> own;
    for (auto it =
           std::lower_bound(byHash_.begin(), byHash_.end(), std::pair(hash, std::size_t(0)));
         it != byHash_.end() && it->first == hash; ++it)
    {
      this->cornersOf(all_[it->second], numbers_, own);
      if (own == corners)
        visit(all_[it->second]);
    }
  }
  /// The corner no farther than `radius` from a place, or -1.
  vtkIdType cornerAt(const Vec3d& place, double radius) const
  {
    double distance = 0.0;
    // Which is not const, but changes nothing once it is built.
    auto* locator = const_cast<vtkStaticPointLocator*>(locator_.Get());
    return locator->FindClosestPointWithinRadius(radius, &place.x, distance);
  }
  vtkPoints* points() const { return points_; }
  double extent() const
  {
    double b[6];
    points_->GetBounds(b);
    return glm::length(Vec3d(b[1] - b[0], b[3] - b[2], b[5] - b[4]));
  }

private:
  static std::uint64_t hashOf(const std::vector<vtkIdType>& corners)
  {
    std::uint64_t hash = corners.size();
    for (const vtkIdType corner : corners)
      hash = (hash ^ static_cast<std::uint64_t>(corner)) * 0x9E3779B97F4A7C15ULL;
    return hash;
  }

  void makeIndex()
  {
    vtkNew<vtkPolyData> cloud;
    cloud->SetPoints(points_);
    locator_->SetDataSet(cloud);
    locator_->BuildLocator();
    numbers_.resize(this->cornerCount());
    std::iota(numbers_.begin(), numbers_.end(), vtkIdType(0));
    std::vector<vtkIdType> corners;
    for (std::size_t f = 0; f < all_.size(); ++f)
    {
      this->cornersOf(all_[f], numbers_, corners);
      byHash_.emplace_back(hashOf(corners), f);
    }
    std::sort(byHash_.begin(), byHash_.end());
  }

  /// A face ends where each side within it is that of two of its triangles.
  void findFaces(const std::vector<std::uint8_t>& edges)
  {
    using Side = std::pair<std::size_t, std::size_t>;
    std::set<Side> open;
    Face face;
    for (std::size_t t = 0; t < corners_.size(); ++t)
    {
      const std::array<std::size_t, 3>& at = corners_[t];
      const Vec3d from = this->corner(at[0]);
      face.normal += glm::cross(this->corner(at[1]) - from, this->corner(at[2]) - from);
      for (std::size_t k = 0; k < 3 && !edges.empty(); ++k)
        if ((edges[t] >> k & 1) == 0)
          if (const Side side(at[k], at[(k + 1) % 3]); open.erase({side.second, side.first}) == 0)
            open.insert(side);
      if (!open.empty() && t + 1 < corners_.size())
        continue;
      face.end = t + 1;
      all_.push_back(face);
      face = {t + 1};
      open.clear();
    }
  }

  vtkSmartPointer<vtkPoints> points_;
  std::vector<std::array<std::size_t, 3>> corners_; ///< of each triangle
  std::vector<Face> all_;
  vtkNew<vtkStaticPointLocator> locator_;
  std::vector<vtkIdType> numbers_;                            ///< of the corners
  std::vector<std::pair<std::uint64_t, std::size_t>> byHash_; ///< faces, of their corners
};

SeamSurface::SeamSurface(const SurfaceTriangles& surface, vtkPoints* points)
  : faces_(std::make_unique<const Faces>(surface, points))
{
}

SeamSurface::~SeamSurface() = default;

namespace
{

using Faces = SeamSurface::Faces;

constexpr double agreement = 1e-6; // of the surface's extent

/// For each corner of a surface, where it is turned to, the corner of another, or -1.
std::vector<vtkIdType> pairs(const Faces& from, const Faces& to, const Mat4d& turn)
{
  std::vector<vtkIdType> met(from.cornerCount(), -1);
  const double radius = agreement * std::max(from.extent(), to.extent());
  double bounds[6];
  to.points()->GetBounds(bounds);
  for (std::size_t i = 0; i < met.size(); ++i)
  {
    const Vec3d q = transformPoint(turn, from.corner(i));
    bool isNear = true; // which is soon told, and most of other blocks is not
    for (int axis = 0; axis < 3; ++axis)
      isNear =
        isNear && q[axis] >= bounds[2 * axis] - radius && q[axis] <= bounds[2 * axis + 1] + radius;
    if (isNear)
      met[i] = to.cornerAt(q, radius);
  }
  return met;
}

void mark(const Faces::Face& face, std::vector<std::uint8_t>& marks)
{
  std::fill(marks.begin() + static_cast<std::ptrdiff_t>(face.first),
    marks.begin() + static_cast<std::ptrdiff_t>(face.end), std::uint8_t(1));
}

/// Marks the triangles of faces of `from`, turned, that faces of `to` look at, and calls
/// visit(face) for these.
template <typename Visit>
void markFacing(const Faces& from, const Faces& to, const Mat4d& turn,
  std::vector<std::uint8_t>& marks, const Visit& visit)
{
  const std::vector<vtkIdType> after = pairs(from, to, turn);
  const Mat3d linear(turn);
  std::vector<vtkIdType> corners;
  for (const Faces::Face& face : from.all())
  {
    from.cornersOf(face, after, corners);
    if (!corners.empty())
      to.find(corners,
        [&](const Faces::Face& other)
        {
          // What of a whole wheel covers itself looks the same way.
          if (!(glm::dot(linear * face.normal, other.normal) < 0.0))
            return;
          mark(face, marks);
          visit(other);
        });
  }
}

} // namespace

std::vector<std::uint8_t> coveredByCopies(
  const SurfaceTriangles& surface, vtkPoints* points, const SectorCopies& copies)
{
  const std::vector<Mat4d> turns = rotatedCopies(copies.count, &copies.center.x, &copies.axis.x);
  if (turns.size() < 2 || surface.view().empty())
    return {};
  const Faces own(surface, points);
  std::vector<std::uint8_t> marks(own.triangleCount(), 0);
  markFacing(own, own, turns[1], marks, [&](const Faces::Face& other) { mark(other, marks); });
  return marks;
}

std::vector<std::uint8_t> coveredByOther(const SeamSurface& surface, const SeamSurface& other)
{
  std::vector<std::uint8_t> marks(surface.faces().triangleCount(), 0);
  markFacing(surface.faces(), other.faces(), Mat4d(1.0), marks, [](const Faces::Face&) {});
  return marks;
}

} // namespace mote
