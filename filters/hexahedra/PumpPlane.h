#ifndef MotePumpPlane_h
#define MotePumpPlane_h

#include "PumpCounts.h"

#include <array>
#include <vector>

namespace mote::pump
{

/// Which function of PumpShape.h places a vertex.
enum class Region
{
  Pipe,   ///< along and across: x and y in pipe radii
  Rotor,  ///< along: station from eye to outlet; across: from blade to blade
  Ring,   ///< along: radius; across: from vane to vane
  Volute, ///< along: outwards; across: the angle
  Outlet, ///< along: outwards; across: length of straight pipe
};

struct PlaneVertex
{
  Region region;
  int passage;
  double along, across;
};

/// A part of the pump is a sheet of quadrilaterals, layer upon layer: vertex v of layer k has the
/// number k * vertices.size() + v. Quadrilaterals go round such that those of one layer and then
/// those of the next make a hexahedron of VTK with positive volume.
struct Plane
{
  std::vector<PlaneVertex> vertices;
  std::vector<std::array<int, 4>> quads;
  std::vector<double> layers; ///< z of the inlet, else the span from 0 to 1
};

Plane inletPlane(const InletCounts& counts);
Plane rotorPlane(const RotorCounts& counts);
Plane diffuserPlane(const DiffuserCounts& counts);

} // namespace mote::pump

#endif
