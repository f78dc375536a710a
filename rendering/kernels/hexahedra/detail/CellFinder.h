#pragma once

#include "../CellCrossings.h"
#include "../HexStructure.h"
#include "../TrilinearCell.h"

#include <functional>
#include <vector>

namespace mote
{

/// Finds the cells of many points that lie near to one another, which is faster than to ask the
/// structure for each: cells are taken from it for a box of points at a time, and those met last
/// are asked first. Only for sources of this folder.
class CellFinder
{
public:
  using Choice = std::function<bool(std::uint32_t cell)>;

  /// Cells that are not shown are found nowhere; what lies in them is in none.
  CellFinder(const HexStructure& structure, Choice isShown)
    : structure_(structure)
    , mesh_(meshOf(structure))
    , isShown_(std::move(isShown))
    , size_(glm::length(mesh_.bounds().size()))
  {
  }

  /// From now on points come from this box, and from cells that `mayHold` says of, by their
  /// corners. Where there are too many, the structure is asked for each point.
  void gather(const Box& box, const std::function<bool(const HexCorners&)>& mayHold);

  /// The cell at a point, or HexMesh::noCell.
  std::uint32_t at(const Vec3d& p);

private:
  /// A cell that may hold points.
  struct Candidate
  {
    std::uint32_t cell;
    TrilinearCell shape;
    Vec3d rst{0.5};
  };

  void clear(const Box& box);
  void add(std::uint32_t cell, const HexCorners& corners);
  bool holds(std::size_t candidate, const Vec3d& p);
  std::uint32_t inStructure(const Vec3d& p);

  const HexStructure& structure_;
  const HexMesh& mesh_;
  Choice isShown_;
  double size_;
  bool isGathered_ = false;
  std::vector<std::uint32_t> found_;
  std::vector<Candidate> candidates_;
  /// Bounds of the candidates, from middle_, rounded outwards.
  Vec3d middle_{0.0};
  std::vector<float> lower_[3], upper_[3];
  std::size_t last_ = 0; ///< that held a point
};

} // namespace mote
