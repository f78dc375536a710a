#pragma once

#include <support/Triangles.h>

#include <kernels/scene/Surface.h>
#include <support/Particles.h>

namespace mote::testing
{

/// An object over triangles, each flat; they must outlive nothing.
inline SurfaceObject objectOf(const Triangles& triangles)
{
  const auto tree = std::make_shared<RlodTree>();
  tree->build(triangles.mesh());
  SurfaceObject object;
  object.surface = MeshSurface(tree);
  return object;
}

inline RlodTree treeOver(const Triangles& triangles)
{
  RlodTree tree;
  tree.build(triangles.mesh());
  return tree;
}

/// With R-LODs, all of which are taken.
inline RlodTree treeWithLods(const Triangles& triangles)
{
  RlodTree tree = treeOver(triangles);
  tree.makeLods();
  tree.setSparesMemory(true);
  return tree;
}

/// Adds two triangles for each cell of a grid, `side` cells each way, whose points are there row by
/// row.
inline void addGrid(Triangles& triangles, int side)
{
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i)
    {
      const int a = j * (side + 1) + i, above = a + side + 1;
      triangles.add(a, a + 1, above + 1);
      triangles.add(a, above + 1, above);
    }
}

/// Adds the triangles of another mesh.
inline void append(Triangles& to, const Triangles& more)
{
  const auto first = static_cast<std::int32_t>(to.pointCount());
  to.points.insert(to.points.end(), more.points.begin(), more.points.end());
  for (const std::int32_t corner : more.corners)
    to.corners.push_back(first + corner);
}

/// Rays that suit a mesh in [-1, 1]^3: bundles of both kinds from all sides and from within,
/// squares and rays anywhere.
inline std::vector<RayBundle> meshQuestions(int count, std::uint64_t seed)
{
  std::vector<RayBundle> bundles;
  Random random(seed);
  for (int k = 0; k < count; ++k)
  {
    const Vec3d eye = (k % 3 == 0 ? random(0.0, 0.9) : random(1.0, 4.0)) * random.direction();
    Camera camera = lookAt(eye, random.inBox(Vec3d(-0.3), Vec3d(0.3)), k % 7 == 0 ? 140.0 : 50.0);
    if (k % 5 == 4)
      camera.projection = Camera::Projection::Orthographic;
    const CameraRays rays(camera, 32, 32);
    bundles.emplace_back();
    rays.fillBundle(bundles.back(), 2 << (k % 4), 16 * (k / 4 % 2), 8, 0.0, 0.0);
    if (k % 3 == 1) // rays anywhere
    {
      bundles.back().count = std::min(bundles.back().count, 1 + 2 * k);
      bundles.back().side = 0;
    }
    if (k % 4 == 1) // that begin and end somewhere
    {
      bundles.back().tMin = random(0.0, 2.0);
      for (int i = 0; i < bundles.back().count; ++i)
        bundles.back().t[i] = random(0.0, 6.0);
    }
  }
  return bundles;
}

/// Casts a bundle, the same rays in packets, and both for anything in their way; judges all.
template <typename Tree>
CastReport checkMesh(const Tree& tree, const TriangleOracle& oracle, const RayBundle& question)
{
  CastReport report = checkBundle(tree, oracle, question);
  RayBundle dark = question;
  tree.occlude(dark, 3);
  RayPacket packet = emptyPacket(), darkPacket;
  const auto ask = [&]
  {
    report.add(checkPacket(tree, oracle, packet));
    darkPacket = packet;
    tree.occlude(darkPacket, 3);
  };
  for (int i = 0; i < question.count; ++i)
  {
    const reference::Ray ray = rayOf(question, i);
    addRay(packet, ray.origin, ray.direction, ray.tMin, ray.tMax);
    const bool last = i + 1 == question.count || packet.count == RayPacket::capacity;
    if (!last)
      continue;
    const int first = i + 1 - packet.count;
    ask();
    for (int k = 0; k < packet.count; ++k)
    {
      const reference::Ray asked = rayOf(question, first + k);
      const bool sure = oracle.nearestSure(asked) < std::numeric_limits<double>::infinity();
      const bool may = sure || oracle.mayHit(asked);
      for (const double t : {dark.t[first + k], darkPacket.t[k]})
      {
        const bool met = t < 0.0;
        ++report.rays;
        if (met ? may : !sure)
          continue;
        ++report.wrong;
        if (report.complaint.empty())
          report.complaint = met ? "something is in the way of nothing" : "nothing is in the way";
      }
    }
    packet = emptyPacket();
  }
  return report;
}

template <typename Tree>
CastReport checkMesh(
  const Tree& tree, const TriangleOracle& oracle, const std::vector<RayBundle>& questions)
{
  CastReport report;
  for (const RayBundle& question : questions)
    report.add(checkMesh(tree, oracle, question));
  return report;
}

} // namespace mote::testing
