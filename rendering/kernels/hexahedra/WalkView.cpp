#include "detail/WalkView.h"

#include "detail/Blocks.h"
#include "detail/CellFaces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote
{

namespace
{

/// What places of points in float may be off by, in units of the mesh's size; with some room.
constexpr double rounding = 1e-6;

/// Where points of the mesh lie in the image, and which way faces look.
class Looker
{
public:
  Looker(const WalkCells& cells, const CameraRays& rays, int width, int height)
    : cells_(cells)
    , rays_(rays)
    , scaled_(rays)
    , isFan_(rays.ox == Vec3d(0.0) && rays.oy == Vec3d(0.0))
    , toImage_(
        glm::inverse(isFan_ ? Mat3d(rays.dx, rays.dy, rays.d0) : Mat3d(rays.ox, rays.oy, rays.d0)))
    , width_(width)
    , height_(height)
  {
    for (Vec3d* step : {&scaled_.d0, &scaled_.dx, &scaled_.dy})
      *step /= cells.size();
    for (int k = 0; k < 3; ++k)
      off_[k] = rounding *
                glm::length(cells.size() * Vec3d(toImage_[0][k], toImage_[1][k], toImage_[2][k]));
  }

  /// False where no ray enters by the face.
  bool look(const CellFace& of, WalkView::Face& face) const
  {
    Vec3d p[4];
    for (std::size_t i = 0; i < 4; ++i)
    {
      const auto& q = cells_.points()[cells_.mesh().cell(of.cell)[faceCorners[of.face][i]]];
      p[i] = {q.x, q.y, q.z};
    }
    face.face = of;
    this->place(p, face);
    constexpr float beyond = 64.0f; // pixels beside the image that may be asked for
    if (!(face.right > -beyond && face.left < static_cast<float>(width_) + beyond &&
          face.upper > -beyond && face.lower < static_cast<float>(height_) + beyond))
      return false;
    return this->faces(p, face);
  }

private:
  void place(const Vec3d (&p)[4], WalkView::Face& face) const
  {
    constexpr float far = std::numeric_limits<float>::max();
    double left = far, right = -far, lower = far, upper = -far;
    int before = 0, behind = 0;
    for (const Vec3d& q : p)
    {
      const Vec3d at = toImage_ * (cells_.toMesh(q) - rays_.o0);
      const double t = isFan_ ? at.z : 1.0, least = isFan_ ? 2.0 * off_.z : 0.0;
      before += t > least;
      behind += t < -least;
      const double per = 1.0 / t, x = at.x * per, y = at.y * per, part = isFan_ ? off_.z : 0.0;
      const double dx = (off_.x + std::abs(x) * part) * std::abs(per) * 2.0 + 1e-3;
      const double dy = (off_.y + std::abs(y) * part) * std::abs(per) * 2.0 + 1e-3;
      left = std::min(left, x - dx);
      right = std::max(right, x + dx);
      lower = std::min(lower, y - dy);
      upper = std::max(upper, y + dy);
    }
    if (before == 4 || behind == 4)
      face = {face.face, false, false, static_cast<float>(left), static_cast<float>(right),
        static_cast<float>(lower), static_cast<float>(upper)};
    else // it is beside the eye and may be seen anywhere
      face = {face.face, false, false, -far, far, -far, far};
  }

  /// False where rays only leave by the face; tells whether it may be folded.
  bool faces(const Vec3d (&p)[4], WalkView::Face& face) const
  {
    const auto inside = [](float x, double size)
    { return std::clamp(double(x), -64.0, size + 64.0); };
    const double x[2] = {inside(face.left, width_), inside(face.right, width_)};
    const double y[2] = {inside(face.lower, height_), inside(face.upper, height_)};
    Vec3d ways[4], normals[4];
    double longest = 0.0, edge = 0.0; // squares
    for (int i = 0; i < 4; ++i)
    {
      ways[i] = scaled_.directionAt(x[i & 1], y[i >> 1]);
      longest = std::max(longest, glm::dot(ways[i], ways[i]));
      const Vec3d along = p[(i + 1) % 4] - p[i];
      edge = std::max(edge, glm::dot(along, along));
    }
    const double margin = rounding * std::sqrt(longest * edge);
    bool enters = true, leaves = true;
    for (int i = 0; i < 4; ++i)
    {
      normals[i] = glm::cross(p[i] - p[(i + 3) % 4], p[(i + 1) % 4] - p[i]);
      if (p[i] == p[(i + 3) % 4] || p[i] == p[(i + 1) % 4])
        continue; // a triangle's, which has no fold
      for (const Vec3d& way : ways)
      {
        const double along = glm::dot(normals[i], way);
        enters = enters && along < -margin;
        leaves = leaves && along > margin;
      }
    }
    face.isUnclear = !enters && !leaves;
    for (int i = 0; face.isUnclear && i < 4; ++i)
      face.isFoldable = face.isFoldable || std::abs(glm::dot(normals[i], p[(i + 2) % 4] - p[i])) >
                                             rounding * glm::length(normals[i]);
    return !leaves;
  }

  const WalkCells& cells_;
  const CameraRays& rays_;
  CameraRays scaled_; ///< of which directions are as WalkCells has places
  bool isFan_;
  Mat3d toImage_; ///< from the eye, or along parallel rays: to x t, y t and t, or x, y and t
  Vec3d off_{0.0};
  int width_, height_;
};

} // namespace

WalkView::WalkView(const WalkCells& cells, const CameraRays& rays, int width, int height)
  : columns_((width + side - 1) / side + 2)
  , rows_((height + side - 1) / side + 2)
  , foldable_(cells.mesh().cellCount() / 32 + 1, 0)
{
  const Looker looker(cells, rays, width, height);
  const RawVector<CellFace>& boundary = cells.adjacency().boundary();
  RawVector<Face> all(boundary.size());
  RawVector<std::uint8_t> isKept(boundary.size());
  forBlocks(boundary.size(), [&](std::size_t i) { isKept[i] = looker.look(boundary[i], all[i]); });
  for (std::size_t i = 0; i < all.size(); ++i)
    if (isKept[i])
    {
      faces_.push_back(all[i]);
      const std::uint32_t cell = all[i].face.cell;
      foldable_[cell >> 5] |= std::uint32_t(all[i].isFoldable) << (cell & 31);
    }
  this->fillSquares();
}

int WalkView::columnOf(double x) const
{
  return static_cast<int>(std::clamp(std::floor(x / side) + 1.0, 0.0, columns_ - 1.0));
}

int WalkView::rowOf(double y) const
{
  return static_cast<int>(std::clamp(std::floor(y / side) + 1.0, 0.0, rows_ - 1.0));
}

void WalkView::fillSquares()
{
  const auto forSquares = [&](const auto& visit)
  {
    for (std::uint32_t i = 0; i < faces_.size(); ++i)
    {
      const Squares s = squaresOf(faces_[i]);
      for (int row = s.lower; row <= s.upper; ++row)
        for (int column = s.left; column <= s.right; ++column)
          visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column),
            i);
    }
  };
  begins_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  forSquares([&](std::size_t square, std::uint32_t) { ++begins_[square]; });
  std::uint32_t sum = 0;
  for (std::uint32_t& begin : begins_)
    begin = sum += begin;
  listed_.resize(sum);
  forSquares([&](std::size_t square, std::uint32_t i) { listed_[--begins_[square]] = i; });
}

void WalkView::gather(
  double left, double right, double lower, double upper, std::vector<std::uint32_t>& faces) const
{
  const Squares s{columnOf(left), columnOf(right), rowOf(lower), rowOf(upper)};
  const std::size_t first = faces.size();
  for (int row = s.lower; row <= s.upper; ++row)
    for (int column = s.left; column <= s.right; ++column)
    {
      const std::size_t square =
        static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
        static_cast<std::size_t>(column);
      faces.insert(
        faces.end(), listed_.begin() + begins_[square], listed_.begin() + begins_[square + 1]);
    }
  if (s.lower == s.upper && s.left == s.right)
    return;
  std::sort(faces.begin() + static_cast<std::ptrdiff_t>(first), faces.end());
  faces.erase(
    std::unique(faces.begin() + static_cast<std::ptrdiff_t>(first), faces.end()), faces.end());
}

} // namespace mote
