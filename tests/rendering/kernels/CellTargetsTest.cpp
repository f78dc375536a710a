// Every SIMD instruction set of this machine finds the same crossings, to the last bit.

#include <kernels/hexahedra/HexStructure.h>

#include <support/HexMeshes.h>
#include <support/Targets.h>

#include <gtest/gtest.h>

#include <algorithm>

using namespace mote;
using namespace mote::testing;

namespace
{

/// Lines at random, through points, along edges and axes.
std::vector<HexRay> linesFor(const HexMesh& mesh)
{
  const Vec3d lower = mesh.bounds().lower, size = mesh.bounds().size();
  const auto ends = randomPoints(300, lower - 0.3 * size, mesh.bounds().upper + 0.3 * size, 8);
  std::vector<HexRay> lines;
  const double all = 1e9;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
  {
    lines.push_back({ends[i], ends[i + 1] - ends[i], -all, all});
    lines.push_back({ends[i], ends[i + 1] - ends[i], 0.1, 0.8});
    const Vec3d& p = mesh.point(i % mesh.pointCount());
    lines.push_back({ends[i], p - ends[i], -all, all});
    lines.push_back({p, mesh.point((i + 1) % mesh.pointCount()) - p, -all, all});
    Vec3d axis(0.0);
    axis[static_cast<int>(i / 2 % 3)] = i % 4 == 0 ? 1.0 : -1.0;
    lines.push_back({i % 8 < 4 ? p : ends[i], axis, -all, all});
  }
  std::erase_if(lines, [](const HexRay& l) { return glm::length(l.direction) == 0.0; });
  return lines;
}

/// All that is found on the lines: cell by cell, and through a structure.
std::vector<CellSpan> answers(const std::shared_ptr<const HexMesh>& mesh)
{
  std::vector<CellSpan> all;
  HexStructureOptions options;
  options.kind = HexStructureKind::CartesianBvh;
  options.bvh.leafSize = 40;
  const auto structure = makeHexStructure(mesh, options);
  for (const HexRay& line : linesFor(*mesh))
  {
    const CrossingLine crossing(line.origin, line.direction);
    CellIntervals intervals;
    for (std::uint32_t c = 0; c < mesh->cellCount(); ++c)
      if (crossing.intersect(*mesh, c, intervals))
        for (const CellInterval& i : intervals)
          all.push_back(i.within(c, -1e300, 1e300));
    withStructure(*structure,
      [&](const auto& s)
      {
        s.forCellsAlong(line,
          [&](const CellSpan& span)
          {
            all.push_back(span);
            return true;
          });
      });
  }
  return all;
}

} // namespace

TEST(CellTargets, EveryInstructionSetFindsTheSameCrossings)
{
  const std::vector<std::int64_t> targets = everyTarget();
  ASSERT_FALSE(targets.empty());
  for (const HexCells& cells : unevenMeshes())
  {
    const auto mesh = cells.mesh();
    std::vector<CellSpan> first;
    for (const std::int64_t target : targets)
    {
      SCOPED_TRACE(hwy::TargetName(target));
      const OnlyTargets only(target);
      const std::vector<CellSpan> found = answers(mesh);
      EXPECT_GT(found.size(), 1000U);
      if (first.empty())
        first = found;
      EXPECT_TRUE(found == first);
    }
  }
  RecordProperty("targets", static_cast<int>(targets.size()));
}
