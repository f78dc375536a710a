#pragma once

#include "vtkType.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

class vtkCell;

/// How a cell of higher order is cut into linear ones: through the points of an even lattice in its
/// parametric coordinates, most of which are its nodes.
struct CellLattice
{
  using Place = std::array<double, 3>; ///< in parametric coordinates
  using Order = std::array<int, 3>;    ///< how often a cell is cut along each of them

  /// A point of the lattice.
  struct Point
  {
    int node = -1; ///< of the cell; -1: one is to be made
    /// Of the one to be made: the cell's interpolation there.
    std::vector<double> weights;
    /// The four corners of the face that it is in the middle of; -1 within the cell.
    std::array<int, 4> corners = {-1, -1, -1, -1};
  };

  /// A linear cell between points of the lattice.
  struct Cell
  {
    int type = 0;
    std::vector<int> points;
  };

  std::vector<Point> points;
  std::vector<Cell> cells;

  /// Whether cells of this type are cut.
  static bool cuts(int type);

  /// The order of a cell with so many nodes; `told` is what the file says of its order. None where
  /// the nodes do not fit, and for types that are not cut.
  static std::optional<Order> orderOf(
    int type, vtkIdType nodes, const std::optional<Order>& told = {});
};

/// The lattices of cells, made once for each kind of cell.
class CellLattices
{
public:
  /// The lattice of a cell of CellLattice::orderOf().
  const CellLattice& of(vtkCell* cell, const CellLattice::Order& order);

private:
  /// Type and order.
  using Key = std::array<int, 4>;
  std::map<Key, std::unique_ptr<CellLattice>> lattices_;
};
