#include "FlowSeeds.h"

#include "kernels/hexahedra/TrilinearCell.h"

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

} // namespace

std::vector<Vec3d> seedsWithin(
  const std::vector<std::shared_ptr<const LocatorStructure>>& meshes, std::size_t count)
{
  double all = 0.0;
  for (const auto& mesh : meshes)
    for (std::size_t cell = 0; cell < mesh->mesh->cellCount(); ++cell)
      all += std::abs(cellVolume(mesh->mesh->corners(cell)));
  std::vector<Vec3d> seeds;
  if (!(all > 0.0))
    return seeds;
  const double each = all / static_cast<double>(count);
  double passed = 0.0;
  for (const auto& mesh : meshes)
    for (std::size_t cell = 0; cell < mesh->mesh->cellCount(); ++cell)
    {
      const HexCorners corners = mesh->mesh->corners(cell);
      passed += std::abs(cellVolume(corners));
      while (seeds.size() < count && (static_cast<double>(seeds.size()) + 0.5) * each < passed)
        seeds.push_back(TrilinearCell(corners).point(evenPlace(seeds.size())));
    }
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
