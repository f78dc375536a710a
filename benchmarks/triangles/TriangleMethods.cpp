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

const std::vector<TriangleMethodEntry>& triangleMethods()
{
  static const std::vector<TriangleMethodEntry> all = {
    {"rlod", "Mote's hierarchy of clusters, with R-LODs where --poe allows errors", makeRlodMethod},
    {"embree", "Embree, built in its high quality", makeEmbreeTriangles},
    {"embree-medium", "Embree, built in its medium quality", makeEmbreeMediumTriangles}};
  return all;
}

} // namespace mote::bench
