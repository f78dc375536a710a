#pragma once

#include "HexTableRun.h"

namespace mote::bench
{

// The cylindrical structures against their Cartesian twins, by rays that go through all of them one
// at a time (RayQueries). Each is made for every input of the run.

/// What grids take and what rays look at in them, after Table 2 of Wang, Elshehaly and Cao.
Section gridTable(HexTableRun& run);
/// The same of hierarchies, after their Table 3.
Section hierarchyTable(HexTableRun& run);
/// Against the size of the mesh; of pumps.
Section sizeTable(HexTableRun& run);
/// Against the direction of the view, from along the axis to across it.
Section directionTable(HexTableRun& run);

} // namespace mote::bench
