#pragma once

#include "HexMesh.h"
#include "SpaceBounds.h"

#include <array>
#include <vector>

namespace mote
{

/// Three slabs that hold a cell: across its mean faces along r, s and t. Cells that lie aslant in a
/// lattice miss most of the steps that their bounds overlap; the slabs tell which (a
/// separating-axis test by three axes, which passes more than it must and never less).
struct CellOutline
{
  struct Slab
  {
    Vec3d normal{0.0}; ///< of length 1, or 0 for a slab without end
    double lower = 0.0;
    double upper = 0.0;
  };
  std::array<Slab, 3> slabs;

  /// Of corners in the axes of a space; the slabs are wider by `margin` on each side.
  CellOutline(const HexCorners& p, double margin)
  {
    const Vec3d r = (p[1] - p[0]) + (p[2] - p[3]) + (p[5] - p[4]) + (p[6] - p[7]);
    const Vec3d s = (p[3] - p[0]) + (p[2] - p[1]) + (p[7] - p[4]) + (p[6] - p[5]);
    const Vec3d t = (p[4] - p[0]) + (p[5] - p[1]) + (p[6] - p[2]) + (p[7] - p[3]);
    const Vec3d normals[3] = {glm::cross(s, t), glm::cross(t, r), glm::cross(r, s)};
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double length = glm::length(normals[k]);
      Slab& slab = slabs[k];
      slab.normal = length > 0.0 ? normals[k] / length : Vec3d(0.0);
      slab.lower = std::numeric_limits<double>::infinity();
      slab.upper = -slab.lower;
      for (const Vec3d& q : p)
      {
        const double at = glm::dot(slab.normal, q);
        slab.lower = at - margin < slab.lower ? at - margin : slab.lower;
        slab.upper = at + margin > slab.upper ? at + margin : slab.upper;
      }
    }
  }
};

/// The steps of a lattice over (x, y, z), as shapes that slabs may meet.
class CartesianSteps
{
public:
  explicit CartesianSteps(const Lattice& lattice)
    : lattice_(lattice)
  {
  }
  bool meets(const CellOutline::Slab& slab, int i, int j, int k) const
  {
    const Vec3d half = 0.5 * lattice_.step;
    const Vec3d middle = lattice_.lower + Vec3d(i + 0.5, j + 0.5, k + 0.5) * lattice_.step;
    const double at = glm::dot(slab.normal, middle), by = glm::dot(glm::abs(slab.normal), half);
    return at + by >= slab.lower && at - by <= slab.upper;
  }

private:
  Lattice lattice_;
};

/// The steps of a lattice over (r, theta, h). A sector of a ring lies within the trapezium whose
/// outer side touches its outer arc in the middle; sectors too wide for that meet every slab.
class CylindricalSteps
{
public:
  explicit CylindricalSteps(const Lattice& lattice)
    : lattice_(lattice)
    , wide_(lattice.step.y > 1.5)
    , outwards_(1.0 / std::cos(0.5 * lattice.step.y))
  {
    if (wide_)
      return;
    for (int j = 0; j <= lattice.n[1]; ++j)
    {
      const double angle = lattice.lower.y + j * lattice.step.y;
      sides_.push_back({std::cos(angle), std::sin(angle)});
    }
  }
  bool meets(const CellOutline::Slab& slab, int i, int j, int k) const
  {
    if (wide_)
      return true;
    const auto along = [&](int side)
    {
      const auto& e = sides_[static_cast<std::size_t>(side)];
      return slab.normal.x * e[0] + slab.normal.y * e[1];
    };
    const double a = along(j), b = along(j + 1), least = a < b ? a : b, most = a < b ? b : a;
    const double inner = lattice_.lower.x + i * lattice_.step.x;
    const double outer = (inner + lattice_.step.x) * outwards_;
    const double bottom = slab.normal.z * (lattice_.lower.z + k * lattice_.step.z);
    const double top = bottom + slab.normal.z * lattice_.step.z;
    const double upper = (most > 0.0 ? outer : inner) * most + (top > bottom ? top : bottom);
    const double lower = (least < 0.0 ? outer : inner) * least + (top > bottom ? bottom : top);
    return upper >= slab.lower && lower <= slab.upper;
  }

private:
  Lattice lattice_;
  bool wide_;
  double outwards_;
  std::vector<std::array<double, 2>> sides_;
};

} // namespace mote
