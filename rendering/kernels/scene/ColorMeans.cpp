#include "ColorMeans.h"

#include "Surface.h"

namespace mote
{

ColorMeans meansOf(const RlodTree& tree, const MeshLook& look, const SurfaceColoring& coloring)
{
  const bool isDirect = !coloring.direct.empty();
  const ArrayView& array = isDirect ? coloring.direct : coloring.values;
  ColorMeans means;
  means.components = isDirect ? array.components() : 1;
  const auto valueAt = [&](std::uint64_t index, int c)
  { return array.value(index, isDirect ? c : coloring.component); };
  const auto ofCells = [&](std::uint64_t triangle, double* values)
  {
    const std::uint64_t cell =
      look.cells.empty() ? triangle : static_cast<std::uint64_t>(look.cells.value(triangle));
    for (int c = 0; c < means.components; ++c)
      values[c] = valueAt(cell, c);
  };
  const auto ofPoints = [&](std::uint64_t triangle, double* values)
  {
    const TriangleMesh::Corners& points = look.mesh->triangles()[triangle];
    for (int c = 0; c < means.components; ++c)
      values[c] = (valueAt(points[0], c) + valueAt(points[1], c) + valueAt(points[2], c)) / 3.0;
  };
  if (look.mixesColors && look.mesh)
    means.numbers = tree.lodMeans(means.components, ofPoints);
  else
    means.numbers = tree.lodMeans(means.components, ofCells);
  return means;
}

} // namespace mote
