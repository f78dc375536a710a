#pragma once

#include "CellValues.h"
#include "Part.h"

#include <vtkSmartPointer.h>
#include <vtkTransform.h>

#include <array>
#include <optional>

namespace mote::app
{

/// A cell of a part where it is seen: parts turn, and have repetitions.
struct PlacedCell
{
  vtkSmartPointer<vtkTransform> placed; ///< from the data's coordinates to where it is seen
  std::array<double, 3> place{};        ///< that was asked for, in the data's coordinates
  std::optional<CellWeights> weights;   ///< there; none where the cell does not reach it
};

/// The cell in that repetition of the part in which a place in the world lies; in the first where
/// it lies in none.
PlacedCell placedCell(const Part& part, vtkIdType cell, const std::array<double, 3>& place);

} // namespace mote::app
