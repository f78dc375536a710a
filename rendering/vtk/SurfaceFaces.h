#pragma once

#include "kernels/core/Vec.h"

#include "vtkNew.h"
#include "vtkType.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

class vtkPoints;
class vtkStaticPointLocator;

namespace mote
{

struct SurfaceTriangles;

/// The corners of a surface, each once, and its faces: polygons that were cut into triangles, which
/// follow one another. Faces are found by their corners.
class SurfaceFaces
{
public:
  struct Face
  {
    std::size_t first = 0, end = 0; ///< of its triangles
    Vec3d normal{0.0};              ///< of any length
  };
  using Triangle = std::array<std::size_t, 3>; ///< its corners

  SurfaceFaces(const SurfaceTriangles& surface, vtkPoints* points);
  ~SurfaceFaces();

  const std::vector<Face>& all() const { return all_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  const std::vector<Vec3d>& corners() const { return corners_; }
  double extent() const { return glm::length(upper_ - lower_); }
  /// How far corners may lie from where they should, as their coordinates are float numbers.
  double rounding() const { return rounding_; }
  /// Whether a place is within the bounds of the corners, widened by `radius`.
  bool isNear(const Vec3d& place, double radius) const;

  /// The corners of a face, ascending, as `numbers` has them; empty where one is below 0.
  void cornersOf(
    const Face& face, const std::vector<vtkIdType>& numbers, std::vector<vtkIdType>& found) const;
  /// The corner no farther than `radius` from a place, or -1.
  vtkIdType cornerAt(const Vec3d& place, double radius) const;
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

private:
  static std::uint64_t hashOf(const std::vector<vtkIdType>& corners);
  void findFaces(const std::vector<std::uint8_t>& edges);
  void makeIndex();

  std::vector<Vec3d> corners_;
  std::vector<Triangle> triangles_;
  std::vector<Face> all_;
  Vec3d lower_{0.0}, upper_{0.0};
  double rounding_ = 0.0;
  vtkNew<vtkStaticPointLocator> locator_;
  std::vector<vtkIdType> numbers_;                            ///< of the corners
  std::vector<std::pair<std::uint64_t, std::size_t>> byHash_; ///< faces, of their corners
};

} // namespace mote
