#include "TriangleMethod.h"

namespace mote::bench
{

TriangleVisits TriangleMethod::visits(
  std::size_t /*mode*/, const CameraRays& /*rays*/, int /*width*/, int /*height*/) const
{
  return {};
}

LodErrors TriangleMethod::lodErrors(const CameraRays& /*rays*/, int /*width*/, int /*height*/) const
{
  return {};
}

void TriangleMethod::castRays(
  std::size_t /*mode*/, const SecondaryRays& /*rays*/, std::vector<PacketHits>& /*hits*/) const
{
}

const std::vector<TriangleMethodEntry>& triangleMethods()
{
  static const std::vector<TriangleMethodEntry> all = {
    {"rlod", "Mote's hierarchy of clusters, with R-LODs where --poe allows errors", makeRlodMethod},
    {"rlod-plain", "the same that never has R-LODs: what it costs to carry them",
      makePlainRlodMethod},
    {"rlod-sparing",
      "the same that takes R-LODs of clusters too: less memory is read, no less time",
      makeSparingRlodMethod},
    {"rlod-paper", "the kd-tree of the R-LODs' authors, and their rule of what meets an R-LOD",
      makeRlodPaperMethod},
    {"rlod-paper-clamped", "their kd-tree, with the rule of rlod", makeRlodPaperClampedMethod},
    {"embree", "Embree, built in its high quality", makeEmbreeTriangles},
    {"embree-medium", "Embree, built in its medium quality", makeEmbreeMediumTriangles},
    {"vtk-opengl", "vtkPolyDataMapper, as the machine's OpenGL driver draws it; with a display",
      makeOpenGLTriangles, true}};
  return all;
}

} // namespace mote::bench
