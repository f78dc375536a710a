#include "PlacedCell.h"

#include <vtkDataSet.h>

namespace mote::app
{

PlacedCell placedCell(const Part& part, vtkIdType cell, const std::array<double, 3>& place)
{
  std::optional<PlacedCell> first;
  for (const auto& placed : part.placements())
  {
    PlacedCell found{placed, {}, {}};
    placed->GetInverse()->TransformPoint(place.data(), found.place.data());
    found.weights = weightsAt(part.data(), cell, found.place);
    if (found.weights)
      return found;
    if (!first)
      first = found;
  }
  return *first;
}

} // namespace mote::app
