#include "FlowSeeds.h"

#include "kernels/hexahedra/TrilinearCell.h"

#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace mote
{

namespace
{

/// A place in [0, 1]^3 of a sequence that fills it evenly: the additive one of the plastic number's
/// like in three dimensions (Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences",
/// 2018).
Vec3d evenPlace(std::size_t i)
{
  constexpr double g = 1.22074408460575947536; // g^4 = g + 1
  const auto part = [i](double step)
  {
    const double at = 0.5 + step * static_cast<double>(i);
    return at - std::floor(at);
  };
  return {part(1.0 / g), part(1.0 / (g * g)), part(1.0 / (g * g * g))};
}

/// Calls visit(mesh, corners, volume) for the cells that are not hidden.
template <typename Visit>
void forCells(const std::vector<SeededMesh>& meshes, const Visit& visit)
{
  for (const SeededMesh& one : meshes)
  {
    const HexMesh& mesh = *one.structure->mesh;
    for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
      if (!isHiddenCell(one.ghosts, mesh.inputCell(cell)))
      {
        const HexCorners corners = mesh.corners(cell);
        visit(one, corners, std::abs(cellVolume(corners)));
      }
  }
}

} // namespace

bool isHiddenCell(vtkUnsignedCharArray* ghosts, std::size_t inputCell)
{
  return ghosts && (ghosts->GetValue(static_cast<vtkIdType>(inputCell)) &
                     vtkDataSetAttributes::HIDDENCELL) != 0;
}

std::vector<Vec3d> seedsWithin(const std::vector<SeededMesh>& meshes, std::size_t count)
{
  double all = 0.0;
  forCells(meshes, [&](const SeededMesh&, const HexCorners&, double volume) { all += volume; });
  std::vector<Vec3d> seeds;
  if (!(all > 0.0))
    return seeds;
  const double each = all / static_cast<double>(count);
  double passed = 0.0;
  forCells(meshes,
    [&](const SeededMesh& mesh, const HexCorners& corners, double volume)
    {
      passed += volume;
      while (seeds.size() < count && (static_cast<double>(seeds.size()) + 0.5) * each < passed)
        seeds.push_back(
          transformPoint(mesh.placement, TrilinearCell(corners).point(evenPlace(seeds.size()))));
    });
  return seeds;
}

std::vector<Vec3d> seedsAlong(const Vec3d& from, const Vec3d& to, std::size_t count)
{
  std::vector<Vec3d> seeds;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double share = count == 1 ? 0.5 : static_cast<double>(i) / static_cast<double>(count - 1);
    seeds.push_back(from + share * (to - from));
  }
  return seeds;
}

} // namespace mote
