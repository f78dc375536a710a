#pragma once

#include "../core/ArrayView.h"

#include <vector>

namespace mote
{

struct MeshLook;
struct SurfaceColoring;
class PkdTree;
class RlodTree;

/// Colours of levels of detail: means of what their triangles or particles are coloured by.
struct ColorMeans
{
  std::vector<float> numbers;
  int components = 1;
  ArrayView stored; ///< in place of numbers, where a file holds them

  /// As SurfaceColoring::means has them.
  ArrayView view() const
  {
    if (!stored.empty())
      return stored;
    const auto each = static_cast<std::size_t>(components);
    return {numbers.data(), numbers.size() / each, components};
  }
};

/// Means of the values, or the direct colours, that a mesh with R-LODs is coloured by: those of
/// cells, or where the look mixes colours those of points, of which a triangle has the mean of its
/// corners. Reads each triangle once, but nothing where the tree's file holds the means.
ColorMeans meansOf(const RlodTree& tree, const MeshLook& look, const SurfaceColoring& coloring);
/// The same of particles with levels of detail.
ColorMeans meansOf(const PkdTree& tree, const SurfaceColoring& coloring);

} // namespace mote
