#include "SurfaceIntegral.h"

#include "HangingFaces.h"
#include "TrilinearCell.h"
#include "detail/CellFaces.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>

namespace mote
{

SurfaceIntegrals together(SurfaceIntegrals a, const SurfaceIntegrals& b)
{
  for (std::size_t i = 0; i < a.values.size(); ++i)
  {
    a.values[i] += b.values[i];
    a.errors[i] += b.errors[i];
  }
  a.cells += b.cells;
  return a;
}

namespace
{

/// Sums over a part of the mesh, and of absolute values.
struct Sums
{
  explicit Sums(int count)
    : values(static_cast<std::size_t>(count))
    , sizes(static_cast<std::size_t>(count))
  {
  }
  void add(double weight, const std::vector<double>& point)
  {
    area += weight;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      values[i] += weight * point[i];
      sizes[i] += weight * std::abs(point[i]);
    }
  }

  std::vector<double> values, sizes;
  double area = 0.0;
};

/// Adds what of(cell or face number, sum) finds for each of so many.
template <typename Of>
SurfaceIntegrals inParallel(std::size_t size, int count, const Of& of)
{
  SurfaceIntegrals none;
  none.values.assign(static_cast<std::size_t>(count), 0.0);
  none.errors = none.values;
  using Range = tbb::blocked_range<std::size_t>;
  // The same numbers whatever the threads.
  return tbb::parallel_deterministic_reduce(
    Range(0, size, 512), none,
    [&](const Range& range, SurfaceIntegrals sum)
    {
      for (std::size_t i = range.begin(); i != range.end(); ++i)
        of(i, sum);
      return sum;
    },
    together);
}

//------------------------------------------------------------------------------------------------
// Slices

/// How far a point is from a shape, with its sign, and the direction in which that grows.
class Distance
{
public:
  explicit Distance(const SliceShape& shape)
    : shape_(shape)
    , axis_(glm::normalize(shape.axis))
    , out_(glm::normalize(shape.out - glm::dot(shape.out, axis_) * axis_))
    , side_(glm::cross(axis_, out_))
  {
  }
  bool isRound() const
  {
    return shape_.kind == SliceShape::Kind::Cylinder || shape_.kind == SliceShape::Kind::Unrolled;
  }
  bool isHalf() const { return shape_.kind == SliceShape::Kind::HalfPlane; }
  double at(const Vec3d& p) const
  {
    const Vec3d from = p - shape_.point;
    if (isRound())
      return glm::length(from - glm::dot(from, axis_) * axis_) - shape_.radius;
    return glm::dot(from, isHalf() ? side_ : axis_);
  }
  Vec3d normal(const Vec3d& p) const
  {
    if (!isRound())
      return isHalf() ? side_ : axis_;
    const Vec3d from = p - shape_.point;
    return glm::normalize(from - glm::dot(from, axis_) * axis_);
  }
  /// Of a round shape: the place on it beside a point near to it, and how much larger a piece there
  /// is than the flat one that it lies beside, which is across `normal`.
  Vec3d onShape(const Vec3d& p) const { return p - this->at(p) * this->normal(p); }
  double stretch(const Vec3d& p, const Vec3d& normal) const
  {
    return std::abs(glm::dot(glm::normalize(normal), this->normal(p))) * shape_.radius /
           (this->at(p) + shape_.radius);
  }
  /// Above 0 on the side of the axis where a half plane is.
  double outwards(const Vec3d& p) const
  {
    return isHalf() ? glm::dot(p - shape_.point, out_) : 1.0;
  }

  /// Whether a cell may meet the shape.
  bool mayMeet(const HexCorners& corners) const
  {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec3d& corner : corners)
    {
      low = std::min(low, this->at(corner));
      high = std::max(high, this->at(corner));
    }
    if (isRound())
    {
      // Between corners as far apart as the bounds are wide the way is nearer to the axis.
      const double half = 0.5 * glm::length(boundsOf(corners).size());
      const double inner = (low + shape_.radius) * (low + shape_.radius) - half * half;
      low = std::sqrt(std::max(0.0, inner)) - shape_.radius;
    }
    return low <= 0.0 && high >= 0.0;
  }

private:
  const SliceShape& shape_;
  Vec3d axis_, out_, side_;
};

/// A corner of the triangles that a slice is in a cell.
struct Corner
{
  Vec3d rst, place;
};

/// One cell with a slice in it.
class SlicedCell
{
public:
  SlicedCell(const HexMesh& mesh, std::uint32_t cell, const Distance& distance,
    const Integrand& integrand, int count)
    : shape_(mesh, cell)
    , distance_(distance)
    , integrand_(integrand)
    , at_(static_cast<std::size_t>(count))
  {
    point_.cell = cell;
  }

  /// The sums with the cell cut into n^3 cubes.
  Sums cut(int n)
  {
    Sums sums(static_cast<int>(at_.size()));
    const auto side = static_cast<std::size_t>(n + 1);
    nodes_.resize(side * side * side);
    for (std::size_t k = 0; k < side; ++k)
      for (std::size_t j = 0; j < side; ++j)
        for (std::size_t i = 0; i < side; ++i)
        {
          Node& node = nodes_[(k * side + j) * side + i];
          node.rst = Vec3d(double(i), double(j), double(k)) / double(n);
          node.distance = distance_.at(shape_.point(node.rst));
        }
    for (std::size_t k = 0; k + 1 < side; ++k)
      for (std::size_t j = 0; j + 1 < side; ++j)
        for (std::size_t i = 0; i + 1 < side; ++i)
          cutCube((k * side + j) * side + i, side, sums);
    return sums;
  }

private:
  struct Node
  {
    Vec3d rst;
    double distance;
  };

  /// Into six tetrahedra about the diagonal, so that cubes side by side cut their face alike.
  void cutCube(std::size_t first, std::size_t side, Sums& sums)
  {
    const std::size_t step[3] = {1, side, side * side};
    bool isAbove = false, isBelow = false;
    for (int corner = 0; corner < 8; ++corner)
    {
      const double d = nodes_[first + (corner & 1) * step[0] + (corner >> 1 & 1) * step[1] +
                              (corner >> 2) * step[2]]
                         .distance;
      isAbove = isAbove || d >= 0.0;
      isBelow = isBelow || d < 0.0;
    }
    if (!isAbove || !isBelow)
      return;
    constexpr int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    for (const auto& order : orders)
    {
      std::array<const Node*, 4> corners{};
      std::size_t at = first;
      corners[0] = &nodes_[at];
      for (std::size_t k = 0; k < 3; ++k)
        corners[k + 1] = &nodes_[at += step[order[k]]];
      cutTetrahedron(corners, sums);
    }
  }

  void cutTetrahedron(const std::array<const Node*, 4>& corners, Sums& sums)
  {
    std::array<const Node*, 4> above{}, below{};
    std::size_t up = 0, down = 0;
    for (const Node* corner : corners)
      (corner->distance >= 0.0 ? above[up++] : below[down++]) = corner;
    if (up == 0 || down == 0)
      return;
    if (up == 2)
    {
      // A quadrilateral, whose corners lie on edges that share an end one after another.
      const Corner a = meet(*above[0], *below[0]), b = meet(*above[0], *below[1]);
      const Corner c = meet(*above[1], *below[1]), d = meet(*above[1], *below[0]);
      clip({a, b, c}, sums);
      clip({a, c, d}, sums);
      return;
    }
    const auto& one = up == 1 ? above : below;
    const auto& three = up == 1 ? below : above;
    clip({meet(*one[0], *three[0]), meet(*one[0], *three[1]), meet(*one[0], *three[2])}, sums);
  }

  /// Where the shape passes an edge; its ends lie on either side. The distance may bend on the way.
  Corner meet(const Node& a, const Node& b) const
  {
    double from = 0.0, to = 1.0, atFrom = a.distance, atTo = b.distance;
    Corner corner{a.rst, {}};
    for (int i = 0; i < 8; ++i)
    {
      const double t = from + (to - from) * (atFrom / (atFrom - atTo));
      corner.rst = a.rst + t * (b.rst - a.rst);
      corner.place = shape_.point(corner.rst);
      const double d = distance_.at(corner.place);
      if (std::abs(d) <= 1e-15 * std::max(std::abs(a.distance), std::abs(b.distance)))
        break;
      // The Illinois rule: an end that stays counts half.
      if ((d < 0.0) == (atFrom < 0.0))
      {
        from = t;
        atFrom = d;
        atTo *= 0.5;
      }
      else
      {
        to = t;
        atTo = d;
        atFrom *= 0.5;
      }
    }
    return corner;
  }

  /// The part of a triangle that is on the right side of the axis.
  void clip(const std::array<Corner, 3>& triangle, Sums& sums)
  {
    std::array<Corner, 4> kept;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Corner &a = triangle[i], &b = triangle[(i + 1) % 3];
      const double from = distance_.outwards(a.place), to = distance_.outwards(b.place);
      if (from >= 0.0)
        kept[count++] = a;
      if ((from >= 0.0) != (to >= 0.0))
      {
        const double t = from / (from - to);
        kept[count++] = {a.rst + t * (b.rst - a.rst), a.place + t * (b.place - a.place)};
      }
    }
    for (std::size_t i = 2; i < count; ++i)
      add(kept[0], kept[i - 1], kept[i], sums);
  }

  /// A rule of six points that is exact to the fourth degree (Dunavant, "High degree efficient
  /// symmetrical Gaussian quadrature rules for the triangle", 1985).
  void add(const Corner& a, const Corner& b, const Corner& c, Sums& sums)
  {
    const Vec3d across = glm::cross(b.place - a.place, c.place - a.place);
    const double area = 0.5 * glm::length(across);
    if (!(area > 0.0))
      return;
    constexpr double rule[2][2] = {
      {0.445948490915965, 0.223381589678011}, {0.091576213509771, 0.109951743655322}};
    for (const auto& [share, weight] : rule)
      for (int corner = 0; corner < 3; ++corner)
      {
        double shares[3] = {share, share, share};
        shares[corner] = 1.0 - 2.0 * share;
        Vec3d rst = shares[0] * a.rst + shares[1] * b.rst + shares[2] * c.rst;
        double stretch = 1.0;
        if (distance_.isRound())
        {
          const Vec3d flat = shares[0] * a.place + shares[1] * b.place + shares[2] * c.place;
          stretch = distance_.stretch(flat, across);
          shape_.converges(distance_.onShape(flat), rst);
        }
        point_.weights = TrilinearCell::weights(rst);
        point_.place = shape_.point(rst);
        point_.normal = distance_.normal(point_.place);
        integrand_(point_, at_.data());
        sums.add(stretch * area * weight, at_);
      }
  }

  TrilinearCell shape_;
  const Distance& distance_;
  const Integrand& integrand_;
  std::vector<double> at_;
  SurfacePoint point_;
  std::vector<Node> nodes_;
};

/// A cell is cut into no more than this many cubes along each edge.
constexpr int mostCuts = 16;

/// `enough`, for each function: what may change; none: 0.
void addCell(
  SlicedCell& cell, double tolerance, const std::vector<double>& enough, SurfaceIntegrals& sum)
{
  Sums coarse = cell.cut(1), fine = cell.cut(2);
  if (std::all_of(fine.sizes.begin(), fine.sizes.end(), [](double size) { return size == 0.0; }) &&
      coarse.sizes == fine.sizes)
    return;
  ++sum.cells;
  const auto isGood = [&]
  {
    for (std::size_t i = 0; i < fine.values.size(); ++i)
      if (std::abs(fine.values[i] - coarse.values[i]) >
          std::max(tolerance * fine.sizes[i], enough.empty() ? 0.0 : enough[i]))
        return false;
    return true;
  };
  for (int n = 4; n <= mostCuts && !isGood(); n *= 2)
  {
    coarse = std::move(fine);
    fine = cell.cut(n);
  }
  for (std::size_t i = 0; i < fine.values.size(); ++i)
  {
    // Errors fall with the square of the cubes' edge.
    const double change = (fine.values[i] - coarse.values[i]) / 3.0;
    sum.values[i] += fine.values[i] + change;
    sum.errors[i] += std::abs(change);
  }
}

/// Calls visit(cell, sum) for the cells that a shape may meet.
template <typename Visit>
SurfaceIntegrals inSlicedCells(const HexMesh& mesh, const Distance& distance, int count,
  const Integrand& integrand, const HiddenCells* hidden, const Visit& visit)
{
  return inParallel(mesh.cellCount(), count,
    [&](std::size_t i, SurfaceIntegrals& sum)
    {
      const auto number = static_cast<std::uint32_t>(i);
      if ((hidden && (*hidden)[number]) || !distance.mayMeet(mesh.corners(i)))
        return;
      SlicedCell cell(mesh, number, distance, integrand, count);
      visit(cell, sum);
    });
}

/// What the integral of each function over a surface may err by in each cell, for one of 1 in all,
/// roughly: cut alike, cells side by side err the opposite way, and errors add up as random ones.
std::vector<double> roughShares(const HexMesh& mesh, const Distance& distance, int count,
  const Integrand& sizes, const HiddenCells* hidden)
{
  SurfaceIntegrals sums = inSlicedCells(mesh, distance, count, sizes, hidden,
    [](SlicedCell& cell, SurfaceIntegrals& sum)
    {
      const Sums found = cell.cut(1);
      sum.cells += found.area > 0.0;
      for (std::size_t i = 0; i < found.values.size(); ++i)
        sum.values[i] += found.values[i];
    });
  for (double& share : sums.values)
    share /= std::sqrt(static_cast<double>(std::max<std::size_t>(1, sums.cells)));
  return sums.values;
}

} // namespace

SurfaceIntegrals integrateSlice(const HexMesh& mesh, const SliceShape& shape, int count,
  const Integrand& integrand, const HiddenCells* hidden, double tolerance, const Integrand& sizes)
{
  const Distance distance(shape);
  std::vector<double> enough;
  if (sizes)
    enough = roughShares(mesh, distance, count, sizes, hidden);
  for (double& one : enough)
    one *= tolerance;
  return inSlicedCells(mesh, distance, count, integrand, hidden,
    [&](SlicedCell& cell, SurfaceIntegrals& sum) { addCell(cell, tolerance, enough, sum); });
}

//------------------------------------------------------------------------------------------------
// Boundaries

namespace
{

struct GaussPoint
{
  double at, weight; ///< in [0, 1]
};
constexpr GaussPoint three[] = {
  {0.1127016653792583, 5.0 / 18.0}, {0.5, 8.0 / 18.0}, {0.8872983346207417, 5.0 / 18.0}};
constexpr GaussPoint four[] = {{0.06943184420297371, 0.17392742256872693},
  {0.33000947820757187, 0.32607257743127307}, {0.66999052179242813, 0.32607257743127307},
  {0.93056815579702629, 0.17392742256872693}};

template <std::size_t Points>
Sums overFace(const HexMesh& mesh, const CellFace& face, const GaussPoint (&rule)[Points],
  const Integrand& integrand, int count)
{
  Sums sums(count);
  std::vector<double> at(static_cast<std::size_t>(count));
  const HexCorners corners = mesh.corners(face.cell);
  const std::uint8_t* of = faceCorners[face.face];
  const Vec3d p[4] = {corners[of[0]], corners[of[1]], corners[of[2]], corners[of[3]]};
  SurfacePoint point;
  point.cell = face.cell;
  for (const GaussPoint& u : rule)
    for (const GaussPoint& v : rule)
    {
      const double shares[4] = {
        (1.0 - u.at) * (1.0 - v.at), u.at * (1.0 - v.at), u.at * v.at, (1.0 - u.at) * v.at};
      const Vec3d alongU = (1.0 - v.at) * (p[1] - p[0]) + v.at * (p[2] - p[3]);
      const Vec3d alongV = (1.0 - u.at) * (p[3] - p[0]) + u.at * (p[2] - p[1]);
      const Vec3d across = glm::cross(alongU, alongV);
      const double area = glm::length(across);
      if (!(area > 0.0))
        continue;
      point.normal = across / area;
      point.place = Vec3d(0.0);
      point.weights = {};
      for (std::size_t k = 0; k < 4; ++k)
      {
        point.place += shares[k] * p[k];
        point.weights[of[k]] += shares[k];
      }
      integrand(point, at.data());
      sums.add(u.weight * v.weight * area, at);
    }
  return sums;
}

} // namespace

SurfaceIntegrals integrateBoundary(const HexMesh& mesh, const FaceAdjacency& adjacency, int count,
  const Integrand& integrand, const HiddenCells* hidden)
{
  const auto addFace = [&](const CellFace& face, SurfaceIntegrals& sum)
  {
    const Sums coarse = overFace(mesh, face, three, integrand, count);
    const Sums fine = overFace(mesh, face, four, integrand, count);
    for (std::size_t i = 0; i < fine.values.size(); ++i)
    {
      sum.values[i] += fine.values[i];
      sum.errors[i] += std::abs(fine.values[i] - coarse.values[i]);
    }
    ++sum.cells;
  };
  const RawVector<CellFace> boundary = wallsOf(mesh, adjacency);
  return inParallel(boundary.size(), count,
    [&](std::size_t i, SurfaceIntegrals& sum)
    {
      if (!hidden || !(*hidden)[boundary[i].cell])
        addFace(boundary[i], sum);
    });
}

} // namespace mote
