#include "HexStructure.h"

#include "../core/Alternatives.h"
#include "../core/Error.h"

#include <algorithm>
#include <cmath>

namespace mote
{

namespace
{

/// What coordinates may be off by, as a share of the mesh's size.
constexpr double slack = 1e-9;

/// The seam belongs where no cells are: at the end of the widest gap between cells' middles.
double seamOf(const HexMesh& mesh, const CylindricalSpace& space)
{
  constexpr int bins = 720;
  constexpr double width = 6.283185307179586 / bins;
  std::vector<bool> taken(bins, false);
  for (std::size_t c = 0; c < mesh.cellCount(); ++c)
  {
    const SpaceBounds b = space.boundsOf(mesh.corners(c));
    const int last = static_cast<int>(b.upper[1] / width);
    for (int i = std::max(0, static_cast<int>(b.lower[1] / width)); i <= last; ++i)
      taken[static_cast<std::size_t>(i % bins)] = true;
  }
  int widest = 0, end = 0, run = 0;
  for (int i = 0; i < 2 * bins; ++i)
  {
    run = taken[static_cast<std::size_t>(i % bins)] ? 0 : run + 1;
    if (run > widest && run < bins)
    {
      widest = run;
      end = i;
    }
  }
  return widest > 0 ? (end % bins + 0.5) * width : 0.0;
}

/// The space of a mesh; the axis is found where it is not given.
CylindricalSpace spaceOf(std::type_identity<CylindricalSpace>, const HexMesh& mesh,
  const std::optional<CylinderAxis>& given)
{
  const CylinderAxis axis = given ? *given : findAxis(mesh);
  if (!(glm::length(axis.direction) > 0.0) || !std::isfinite(glm::length(axis.direction)))
    throw Error("The axis of a cylindrical structure needs a direction.");
  const double size = glm::length(mesh.bounds().size());
  return {axis, size, seamOf(mesh, CylindricalSpace(axis, size))};
}

CartesianSpace spaceOf(
  std::type_identity<CartesianSpace>, const HexMesh& mesh, const std::optional<CylinderAxis>&)
{
  return {mesh.bounds().center(), slack * glm::length(mesh.bounds().size())};
}

} // namespace

std::shared_ptr<HexStructure> makeHexStructure(
  std::shared_ptr<const HexMesh> mesh, const HexStructureOptions& options)
{
  return withAlternative<HexStructure>(static_cast<std::size_t>(options.kind),
    [&]<typename Structure>(std::type_identity<Structure>)
    {
      const std::type_identity<typename Structure::Coordinates> coordinates;
      return std::make_shared<HexStructure>(
        Structure(mesh, spaceOf(coordinates, *mesh, options.axis), options.of<Structure>()));
    });
}

const std::vector<std::string>& hexStructureNames()
{
  static const std::vector<std::string> names = alternativeNames<HexStructure>();
  return names;
}

bool isCylindrical(HexStructureKind kind)
{
  return withAlternative<HexStructure>(static_cast<std::size_t>(kind),
    []<typename Structure>(std::type_identity<Structure>)
    { return std::is_same_v<typename Structure::Coordinates, CylindricalSpace>; });
}

std::uint32_t cellAt(const HexStructure& structure, const Vec3d& p, std::uint32_t hint)
{
  return withStructure(structure, [&](const auto& s) { return s.cellAt(p, hint); });
}

std::vector<std::uint32_t> cellsWithin(const HexStructure& structure, const Box& box)
{
  return withStructure(structure,
    [&](const auto& s)
    {
      std::vector<std::uint32_t> cells;
      const Box& all = s.mesh().bounds();
      const Box part{glm::max(box.lower, all.lower), glm::min(box.upper, all.upper)};
      if (part.empty())
        return cells;
      s.gatherWithin(part, cells);
      std::sort(cells.begin(), cells.end());
      cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
      std::erase_if(cells,
        [&](std::uint32_t c)
        {
          const Box of = boundsOf(s.mesh().corners(c));
          return Box{glm::max(part.lower, of.lower), glm::min(part.upper, of.upper)}.empty();
        });
      return cells;
    });
}

void setRanges(HexStructure& structure, const HexField& field)
{
  std::visit([&](auto& s) { s.setRanges(cellRanges(s.mesh(), field)); }, structure);
}

} // namespace mote
