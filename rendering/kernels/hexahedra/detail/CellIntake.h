#pragma once

// How a HexMesh takes cells as users give them. Only for sources of this folder.

#include "../FacedCell.h"

namespace mote
{

/// What becomes of a cell.
enum class Fate : std::uint8_t
{
  Kept,
  Inverted,
  SelfCrossing,
  SelfCrossingInverted,
  InParts,
  InPartsInverted,
  OtherType, ///< the first that is left out
  NonFinite,
  TooFar,
  ZeroVolume,
  Unfit
};

constexpr bool isKept(Fate fate)
{
  return fate < Fate::OtherType;
}

constexpr bool isInParts(Fate fate)
{
  return fate == Fate::InParts || fate == Fate::InPartsInverted;
}

/// Looks at cells one by one; one for every thread.
class CellIntake
{
public:
  struct Looked
  {
    Fate fate = Fate::OtherType;
    HexMesh::Cell cell{};
    double volume = 0.0;
  };

  CellIntake(const HexMeshInput& input, const RawVector<Vec3d>& points)
    : input_(input)
    , points_(points)
  {
  }

  /// Throws Error where the cell does not fit its type, or names what is not there.
  Looked look(std::size_t i);

  /// The parts of the cell that was looked at last, where it is in parts.
  const FacedCell& inParts() const { return faced_; }

private:
  void placePoints();
  Looked lookAtFaces(std::size_t i);
  /// Judges the shape of `looked.cell`. Cells of free order are not told of when inside out.
  void judge(Looked& looked, bool isOrderFree);

  const HexMeshInput& input_;
  const RawVector<Vec3d>& points_;
  FacedCell faced_;
};

} // namespace mote
