#pragma once

#include "../../core/Box.h"

#include <cstddef>
#include <vector>

namespace mote
{

/// Particles of similar radius, in a grid's own coordinates.
struct RadiusGroup
{
  std::size_t count = 0;
  Box centers;
  float largestRadius = 0.0f;
  int octave = 0; ///< exponent of the least radius as a float; see octaveOf()

  void add(const RadiusGroup& other);
};

/// Edge of the cubic cells in which `cells` of them fill a box of this size. Directions thinner
/// than a cell count as one cell, so flat and linear sets get as many cells as others; cells are
/// never so small that float could not tell them apart, nor less than a thousandth of
/// `largestRadius`.
double particleGridEdge(const Vec3d& size, double cells, double largestRadius);

/// Joins neighbouring groups where one grid for both costs a traversal less than two.
///
/// A large sphere in a fine grid widens every frustum that is cast through it, and so brings many
/// small spheres to be looked at; a grid more has its own cells to walk through. The joints are
/// those with the least sum, by a model of the work per length of a bundle's path. `groups` are
/// ordered by radius, largest first.
std::vector<RadiusGroup> mergedGroups(
  const std::vector<RadiusGroup>& groups, double cellsPerParticle);

} // namespace mote
