#pragma once

#include "../Suite.h"

#include <kernels/core/Box.h>
#include <kernels/core/RawVector.h>
#include <kernels/meshes/TriangleMesh.h>

#include <string>
#include <vector>

namespace mote::bench
{

/// Triangles as every method gets them: float points, relative to the middle of the model.
struct TriangleInput
{
  std::string name;
  RawVector<Vec3f> points; ///< and one more, which nobody has as a corner: Embree reads 16 bytes
  RawVector<TriangleMesh::Corners> triangles;
  Box bounds;

  std::size_t pointCount() const { return points.size() - 1; }
  TriangleMesh mesh() const
  {
    return {ArrayView(&points[0].x, pointCount(), 3),
      ArrayView(triangles.data(), ArrayView::Type::UInt32, triangles.size(), 3)};
  }
};

/// Makes or reads what the specification says. Throws Error.
TriangleInput makeTriangleInput(const std::string& specification);

/// What may be specified, for --help.
std::vector<Named> triangleInputs();

} // namespace mote::bench
