#include "TriangleMethod.h"

#include <limits>

namespace mote::bench
{

std::pair<double, double> TriangleMethod::visits(
  std::size_t /*mode*/, const CameraRays& /*rays*/, int /*width*/, int /*height*/) const
{
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  return {unknown, unknown};
}

const std::vector<TriangleMethodEntry>& triangleMethods()
{
  static const std::vector<TriangleMethodEntry> all = {
    {"rlod", "Mote's hierarchy of clusters, exact", makeRlodMethod},
    {"embree", "Embree, built in its high quality", makeEmbreeTriangles},
    {"embree-medium", "Embree, built in its medium quality", makeEmbreeMediumTriangles}};
  return all;
}

} // namespace mote::bench
