#pragma once

#include "Reference.h"

namespace mote::reference
{

/// A plain binary tree of boxes around spheres, all in double, for sets too large for brute force.
/// Median splits to a depth that is the same everywhere: node n has the children 2n and 2n + 1.
/// About 45 bytes a particle.
class SphereTree
{
public:
  explicit SphereTree(std::vector<Sphere> spheres);
  explicit SphereTree(const ParticleSet& particles)
    : SphereTree(validSpheres(particles))
  {
  }

  /// The same answer as bruteForce().
  Hit cast(const Ray& ray) const;

  std::size_t size() const { return spheres_.size(); }

private:
  struct Bounds
  {
    Vec3d lower, upper;
  };
  struct Range
  {
    std::size_t first, last;
    std::size_t middle() const { return first + (last - first) / 2; }
  };

  void build(std::size_t node, int level, Range range);
  void visit(const Ray& ray, std::size_t node, int level, Range range, Hit& hit) const;
  bool mayMeet(const Ray& ray, const Bounds& bounds, double tMax, double& tIn) const;

  std::vector<Sphere> spheres_;
  std::vector<Bounds> bounds_; ///< node n at n; 0 is not used
  int depth_ = 0;
};

} // namespace mote::reference
