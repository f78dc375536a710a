#pragma once

#include "MeshParts.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace mote::testing
{

/// Triangles that casts and R-LODs find hard, in [-1, 1]^3; `many` times as many as a few.

/// Slivers, dust and walls that reach far beyond.
inline Triangles sliversHugeAndTiny(int many = 1)
{
  Random random(4);
  Triangles all = randomTriangles(static_cast<std::size_t>(100 * many), 5, 0.2);
  for (int i = 0; i < 100 * many; ++i) // slivers
  {
    const Vec3d a = random.inBox(Vec3d(-1.0), Vec3d(1.0)), way = random.direction();
    all.add(a, a + way, a + 0.5 * way + std::pow(10.0, random(-9.0, -2.0)) * random.direction());
  }
  for (int i = 0; i < 100 * many; ++i) // dust
  {
    const Vec3d a = random.inBox(Vec3d(-1.0), Vec3d(1.0));
    all.add(a, a + 1e-4 * random.direction(), a + 1e-4 * random.direction());
  }
  for (int i = 0; i < 4; ++i) // walls
    all.add(40.0 * random.direction(), 40.0 * random.direction(), 40.0 * random.direction());
  return all;
}

/// Adds triangles that are lines, and 40 that are a point.
inline void addDegenerate(Triangles& all, int lines)
{
  Random random(6);
  for (int i = 0; i < lines; ++i)
  {
    const Vec3d a = random.inBox(Vec3d(-1.0), Vec3d(1.0)),
                b = random.inBox(Vec3d(-1.0), Vec3d(1.0));
    all.add(a, b, i % 2 == 0 ? b : a);
  }
  for (int i = 0; i < 40; ++i)
    all.add(0, 0, 0);
}

/// One triangle again and again, many in one plane over one another, and a fan about one edge.
inline Triangles duplicatesStacksAndFans(int many = 1)
{
  Triangles all;
  Random random(7);
  for (int i = 0; i < 60 * many; ++i) // more than a cluster holds
    all.add({-0.9, -0.9, 0.1}, {0.1, -0.8, 0.2}, {-0.3, 0.1, -0.2});
  for (int i = 0; i < 50 * many; ++i)
  {
    const auto at = [&] { return Vec3d(random(-1.0, 1.0), random(-1.0, 1.0), 0.5); };
    const Vec3d a = at(), b = at();
    all.add(a, b, at());
  }
  for (int i = 0; i < 50 * many; ++i)
    all.add(
      {0.5, 0.5, -1.0}, {0.5, 0.5, 1.0}, {random(-1.0, 1.0), random(-1.0, 1.0), random(-1.0, 1.0)});
  return all;
}

/// Adds triangles with a point that is nowhere.
inline void addNotFinite(Triangles& all)
{
  const std::int32_t bad = all.addPoint(Vec3d(std::numeric_limits<double>::quiet_NaN()));
  for (int i = 0; i < 20; ++i)
    all.add(i, bad, i + 1);
}

/// A bowl: the lower part of a sphere, with holes in it.
inline Triangles bowlWithHoles(int rings)
{
  const Triangles sphere = bumpySphere(rings);
  Triangles bowl = sphere;
  bowl.corners.clear();
  for (std::size_t i = 0; i < sphere.size(); ++i)
    if (sphere.of(i)[0].z < 0.3 && i % 17 != 0)
      for (std::size_t k = 0; k < 3; ++k)
        bowl.corners.push_back(sphere.corners[3 * i + k]);
  return bowl;
}

/// Sheets of the same points, one on another.
inline Triangles stackOfSheets(int sheets, int side)
{
  Triangles all;
  for (int sheet = 0; sheet < sheets; ++sheet)
  {
    Triangles one;
    for (int j = 0; j <= side; ++j)
      for (int i = 0; i <= side; ++i)
        one.addPoint({2.0 * i / side - 1.0, 2.0 * j / side - 1.0, 0.2});
    addGrid(one, side);
    append(all, one);
  }
  return all;
}

struct HardMesh
{
  std::string name;
  Triangles triangles;
};

/// All of them, with triangles enough that R-LODs stand for some.
inline std::vector<HardMesh> hardMeshes()
{
  std::vector<HardMesh> all = {{"sphere", bumpySphere(24)},
    {"slivers, huge and tiny", sliversHugeAndTiny(8)}, {"bowl with holes", bowlWithHoles(30)},
    {"stack of sheets", stackOfSheets(4, 20)},
    {"duplicates, stacks and fans", duplicatesStacksAndFans(15)}, {"nothing", {}},
    {"not finite", bumpySphere(20)}, {"degenerate", bumpySphere(20)}, {"lines and points", {}}};
  all.push_back({"one triangle", {}});
  all.back().triangles.add({-1, -1, 0.3}, {1, -1, 0.1}, {0, 1, -0.2});
  addNotFinite(all[6].triangles);
  addDegenerate(all[7].triangles, 1500);
  all[8].triangles.addPoint(Vec3d(0.1));
  addDegenerate(all[8].triangles, 1500);
  return all;
}

/// Triangles or rays in [-1, 1]^3, in other units and elsewhere.
struct Elsewhere
{
  double unit = 1.0;
  Vec3d middle{0.0};

  Triangles operator()(Triangles triangles) const
  {
    triangles.move([&](const Vec3d& p) { return middle + unit * p; });
    return triangles;
  }
  RayBundle operator()(const RayBundle& question) const
  {
    RayBundle bundle = question;
    bundle.origin = middle + unit * bundle.origin;
    bundle.footprint *= unit;
    if (bundle.kind == RayBundle::Kind::CommonDirection) // t counts in lengths of the direction
    {
      bundle.dx *= unit;
      bundle.dy *= unit;
      bundle.direction *= unit;
      bundle.footprintPerT *= unit;
      return bundle;
    }
    bundle.tMin *= unit;
    for (int i = 0; i < bundle.count; ++i)
      bundle.t[i] *= unit;
    return bundle;
  }
};

} // namespace mote::testing
