#pragma once

#include "HexMesh.h"

namespace mote
{

/// A straight line that a mesh turns about.
struct CylinderAxis
{
  Vec3d origin{0.0};
  Vec3d direction{0.0, 0.0, 1.0}; ///< of any length but 0
};

/// The axis about which the cells' bounds in (r, theta, h) are tightest: the sum of the bounds'
/// volumes over a few hundred cells, evenly taken, is least.
///
/// Tried are the coordinate axes through the origin and through the mesh's middle (that of its
/// volume), and the principal axes of its volume's moments, of which a body that turns about an
/// axis has one along it. The best is then moved and tilted in ever smaller steps. A coordinate
/// axis is preferred where it is as good to within 1 %. The answer for no cells is the z axis.
CylinderAxis findAxis(const HexMesh& mesh);

} // namespace mote
