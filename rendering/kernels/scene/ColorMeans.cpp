#include "ColorMeans.h"

#include "Surface.h"

namespace mote
{

namespace
{

/// What a surface is coloured by.
struct ColoredBy
{
  const SurfaceColoring& coloring;
  const bool isDirect = !coloring.direct.empty();
  const ArrayView& array = isDirect ? coloring.direct : coloring.values;

  int components() const { return isDirect ? array.components() : 1; }
  template <typename Tree>
  ArrayView storedIn(const Tree& tree) const
  {
    return isDirect ? ArrayView() : tree.storedMeans(array, coloring.component);
  }
  double value(std::uint64_t index, int c) const
  {
    return array.value(index, isDirect ? c : coloring.component);
  }
};

} // namespace

ColorMeans meansOf(const PkdTree& tree, const SurfaceColoring& coloring)
{
  const ColoredBy by{coloring};
  ColorMeans means;
  means.components = by.components();
  means.stored = by.storedIn(tree);
  if (!means.stored.empty())
    return means;
  means.numbers = tree.lodMeans(means.components,
    [&](std::uint64_t particle, double* values)
    {
      for (int c = 0; c < means.components; ++c)
        values[c] = by.value(particle, c);
    });
  return means;
}

ColorMeans meansOf(const RlodTree& tree, const MeshLook& look, const SurfaceColoring& coloring)
{
  const ColoredBy by{coloring};
  ColorMeans means;
  means.components = by.components();
  means.stored = by.storedIn(tree);
  if (!means.stored.empty())
    return means;
  const auto ofCells = [&](std::uint64_t triangle, double* values)
  {
    const std::uint64_t cell =
      look.cells.empty() ? triangle : static_cast<std::uint64_t>(look.cells.value(triangle));
    for (int c = 0; c < means.components; ++c)
      values[c] = by.value(cell, c);
  };
  const auto ofPoints = [&](std::uint64_t triangle, double* values)
  {
    const MeshCorners::Corners points = (*look.corners)[triangle];
    for (int c = 0; c < means.components; ++c)
      values[c] = (by.value(points[0], c) + by.value(points[1], c) + by.value(points[2], c)) / 3.0;
  };
  if (look.mixesColors && look.corners)
    means.numbers = tree.lodMeans(means.components, ofPoints);
  else
    means.numbers = tree.lodMeans(means.components, ofCells);
  return means;
}

} // namespace mote
