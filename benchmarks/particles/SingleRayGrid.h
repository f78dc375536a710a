#pragma once

#include "CellGrid.h"
#include "HitImage.h"

#include <kernels/core/Camera.h>

namespace mote::bench
{

/// Casts the rays of a camera through the centres of the pixels of the 8x8 block at (x0, y0), one
/// after another, and writes what they hit; the particle's number is its place in the grid.
///
/// A ray steps from cell to cell (Amanatides and Woo, "A fast voxel traversal algorithm for ray
/// tracing", Eurographics 1987). Spheres reach out of the cells of their centres, up to n cells
/// far: wherever the ray is, it must have seen all cells up to n away. At the start it looks at all
/// of them, at every step at the (2n+1)^2 cells that come into reach, so that it tests no sphere
/// twice; and it may stop as soon as it leaves a cell behind its nearest hit.
void castSingleRays(const CellGrid& grid, const CameraRays& rays, int x0, int y0, HitImage& image);

} // namespace mote::bench
