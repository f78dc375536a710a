#include "AmbientMethods.h"

#include "../Report.h"

namespace mote::bench
{

namespace
{

AmbientMethod live(int rays)
{
  AmbientMethod method;
  method.name = format("live-%d", rays);
  method.summary = format("%d rays a hit in every picture", rays);
  method.rays = rays;
  return method;
}

AmbientMethod baked(int side, bool dilate)
{
  AmbientMethod method;
  method.name = format("baked-%dx%d%s", side, side, dilate ? "" : "-undilated");
  method.summary = format("maps of %dx%d texels%s", side, side,
    dilate ? "" : ", those inside of other particles left dark");
  method.side = side;
  method.dilate = dilate;
  return method;
}

AmbientMethod named(AmbientMethod method, const char* name, const char* summary)
{
  method.name = name;
  method.summary = summary;
  return method;
}

std::vector<AmbientMethod> allMethods()
{
  std::vector<AmbientMethod> all;
  for (const int rays : {1, 4, 16, 64, 256})
    all.push_back(live(rays));
  for (const int side : {1, 4, 8, 16, 32})
    for (const bool dilate : {true, false})
      all.push_back(baked(side, dilate));
  AmbientMethod adaptive = baked(16, true), embree = baked(16, true);
  adaptive.adaptive = true;
  embree.embree = true;
  all.push_back(named(adaptive, "baked-adaptive", "as few texels as the tolerance allows"));
  all.push_back(named(embree, "baked-embree", "baked-16x16, its rays answered by Embree"));
  embree.adaptive = true;
  all.push_back(
    named(embree, "baked-adaptive-embree", "baked-adaptive, its rays answered by Embree"));
  return all;
}

AmbientTable toleranceTable()
{
  AmbientTable table{"tolerance", "Adaptive maps: bytes and error by the tolerance", {}};
  table.methods.push_back(baked(16, true));
  for (const double tolerance : {0.0, 0.0025, 0.005, 0.01, 0.02, 0.04})
  {
    AmbientMethod method = baked(16, true);
    method.name = format("tolerance %g", tolerance);
    method.adaptive = true;
    method.tolerance = tolerance;
    table.methods.push_back(method);
  }
  return table;
}

AmbientTable sampleTable()
{
  AmbientTable table{"samples", "Rays a texel", {}};
  for (const bool adaptive : {false, true})
    for (const int samples : {16, 25, 49, 100, 196})
    {
      AmbientMethod method = baked(16, true);
      method.name = format("%s, %d rays", adaptive ? "adaptive" : "16x16", samples);
      method.adaptive = adaptive;
      method.samples = samples;
      table.methods.push_back(method);
    }
  return table;
}

} // namespace

OcclusionBakeOptions AmbientMethod::baking(OcclusionBakeOptions like) const
{
  like.side = side;
  like.adaptive = adaptive;
  like.dilate = dilate;
  if (samples > 0)
    like.samples = samples;
  if (tolerance >= 0.0)
    like.tolerance = tolerance;
  return like;
}

const std::vector<AmbientMethod>& ambientMethods()
{
  static const std::vector<AmbientMethod> all = allMethods();
  return all;
}

const std::vector<AmbientTable>& ambientTables()
{
  static const std::vector<AmbientTable> all = {toleranceTable(), sampleTable()};
  return all;
}

} // namespace mote::bench
