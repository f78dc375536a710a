#include "CylinderAxis.h"

#include "CylindricalSpace.h"

#include <algorithm>
#include <cmath>

namespace mote
{

namespace
{

constexpr std::size_t sampleSize = 512;

/// An even sample of the cells, and its moments of volume.
struct Sample
{
  std::vector<HexCorners> cells;
  double size = 1.0; ///< of the mesh
  Vec3d middle{0.0};
  Mat3d moments{0.0};
};

Sample sampleOf(const HexMesh& mesh)
{
  Sample sample;
  sample.size = glm::length(mesh.bounds().size());
  const std::size_t n = mesh.cellCount();
  const std::size_t stride = n / sampleSize + 1;
  for (std::size_t c = stride / 2; c < n; c += stride)
    sample.cells.push_back(mesh.corners(c));
  // Moments are taken over more cells than bounds.
  const std::size_t step = n / (64 * sampleSize) + 1;
  for (const bool second : {false, true})
  {
    double volume = 0.0;
    Vec3d sum(0.0);
    for (std::size_t c = 0; c < n; c += step)
    {
      const HexCorners corners = mesh.corners(c);
      const double v = cellVolume(corners);
      const Vec3d d = cellCenter(corners) - (second ? sample.middle : mesh.bounds().lower);
      volume += v;
      sum += v * d;
      if (second)
        sample.moments += v * glm::outerProduct(d, d);
    }
    if (!second)
      sample.middle = mesh.bounds().lower + sum / volume;
  }
  return sample;
}

/// The sum of the volumes of the sampled cells' bounds about an axis.
double looseness(const Sample& sample, const CylinderAxis& axis)
{
  const CylindricalSpace space(axis, sample.size);
  double sum = 0.0;
  for (const HexCorners& corners : sample.cells)
  {
    const SpaceBounds b = space.boundsOf(corners);
    const Vec3d sides = CylindricalSpace::sides(b.from(), b.to());
    sum += sides.x * sides.y * sides.z;
  }
  return sum;
}

/// The eigenvectors of a symmetric matrix, as columns: Jacobi's method.
Mat3d eigenvectors(Mat3d m)
{
  Mat3d vectors(1.0);
  for (int sweep = 0; sweep < 30; ++sweep)
    for (int p = 0; p < 2; ++p)
      for (int q = p + 1; q < 3; ++q)
      {
        if (m[p][q] == 0.0)
          continue;
        const double angle = 0.5 * std::atan2(2.0 * m[p][q], m[q][q] - m[p][p]);
        Mat3d turn(1.0);
        turn[p][p] = turn[q][q] = std::cos(angle);
        turn[q][p] = std::sin(angle);
        turn[p][q] = -std::sin(angle);
        m = glm::transpose(turn) * m * turn;
        vectors = vectors * turn;
      }
  return vectors;
}

/// Moves and tilts an axis as long as that makes bounds tighter.
CylinderAxis refined(const Sample& sample, CylinderAxis axis, double& best)
{
  double step = 0.1;
  for (int round = 0; round < 200 && step > 1e-6; ++round)
  {
    bool better = false;
    const Vec3d h = glm::normalize(axis.direction), size = glm::abs(h);
    const Vec3d other = size.x < 0.6 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
    const Vec3d u = glm::normalize(glm::cross(h, other)), v = glm::cross(h, u);
    for (const Vec3d& d : {u, -u, v, -v})
      for (const bool tilt : {false, true})
      {
        CylinderAxis tried = axis;
        if (tilt)
          tried.direction = glm::normalize(h + step * d);
        else
          tried.origin += step * sample.size * d;
        const double value = looseness(sample, tried);
        if (value >= best)
          continue;
        best = value;
        axis = tried;
        better = true;
      }
    if (!better)
      step *= 0.5;
  }
  return axis;
}

} // namespace

CylinderAxis findAxis(const HexMesh& mesh)
{
  if (mesh.cellCount() == 0)
    return {};
  const Sample sample = sampleOf(mesh);
  const Mat3d principal = eigenvectors(sample.moments);
  CylinderAxis plain, free;
  double plainBest = std::numeric_limits<double>::infinity(), freeBest = plainBest;
  for (int k = 0; k < 3; ++k)
  {
    Vec3d along(0.0);
    along[k] = 1.0;
    for (const Vec3d& through : {Vec3d(0.0), sample.middle})
      if (const double value = looseness(sample, {through, along}); value < plainBest)
      {
        plainBest = value;
        plain = {through, along};
      }
    if (const double value = looseness(sample, {sample.middle, principal[k]}); value < freeBest)
    {
      freeBest = value;
      free = {sample.middle, principal[k]};
    }
  }
  if (plainBest <= freeBest)
  {
    free = plain;
    freeBest = plainBest;
  }
  free = refined(sample, free, freeBest);
  return plainBest <= 1.01 * freeBest ? plain : free;
}

} // namespace mote
