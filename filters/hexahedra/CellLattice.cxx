#include "CellLattice.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkHexahedron.h"
#include "vtkPyramid.h"
#include "vtkWedge.h"

#include <algorithm>
#include <cmath>

namespace
{

using Place = CellLattice::Place;

enum class Shape
{
  None,
  Tetrahedron,
  Hexahedron,
  Wedge,
  Pyramid
};

Shape shapeOf(int type)
{
  switch (type)
  {
  case VTK_QUADRATIC_TETRA:
  case VTK_LAGRANGE_TETRAHEDRON:
    return Shape::Tetrahedron;
  case VTK_QUADRATIC_HEXAHEDRON:
  case VTK_TRIQUADRATIC_HEXAHEDRON:
  case VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON:
  case VTK_LAGRANGE_HEXAHEDRON:
    return Shape::Hexahedron;
  case VTK_QUADRATIC_WEDGE:
  case VTK_QUADRATIC_LINEAR_WEDGE:
  case VTK_BIQUADRATIC_QUADRATIC_WEDGE:
  case VTK_LAGRANGE_WEDGE:
    return Shape::Wedge;
  case VTK_QUADRATIC_PYRAMID:
    return Shape::Pyramid;
  default:
    return Shape::None;
  }
}

/// Six times the volume in parametric coordinates.
double volumeOf(const Place& a, const Place& b, const Place& c, const Place& d)
{
  const auto from = [&](const Place& p) { return Place{p[0] - a[0], p[1] - a[1], p[2] - a[2]}; };
  const Place u = from(b), v = from(c), w = from(d);
  return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
         u[2] * (v[0] * w[1] - v[1] * w[0]);
}

/// Makes the lattice of one cell.
class Builder
{
public:
  Builder(vtkCell* cell, const CellLattice::Order& order, CellLattice& lattice)
    : cell_(cell)
    , order_(order)
    , lattice_(lattice)
    , shape_(shapeOf(cell->GetCellType()))
  {
  }

  void build()
  {
    switch (shape_)
    {
    case Shape::Tetrahedron:
      return this->cutTetrahedron();
    case Shape::Hexahedron:
      return this->cutHexahedron();
    case Shape::Wedge:
      return this->cutWedge();
    case Shape::Pyramid:
      return this->cutPyramid();
    case Shape::None:
      return;
    }
  }

private:
  /// The point of the lattice at so many steps along the axes.
  int at(int i, int j, int k)
  {
    const Place place = {double(i) / order_[0], double(j) / order_[1], double(k) / order_[2]};
    const auto known = std::find(places_.begin(), places_.end(), place);
    if (known != places_.end())
      return static_cast<int>(known - places_.begin());
    places_.push_back(place);
    lattice_.points.push_back(this->pointAt(place));
    return static_cast<int>(places_.size()) - 1;
  }

  CellLattice::Point pointAt(const Place& place) const
  {
    CellLattice::Point point;
    const double* of = cell_->GetParametricCoords();
    const vtkIdType nodes = cell_->GetNumberOfPoints();
    for (vtkIdType node = 0; node < nodes; ++node)
      if (std::abs(of[3 * node] - place[0]) + std::abs(of[3 * node + 1] - place[1]) +
            std::abs(of[3 * node + 2] - place[2]) <
          1e-6)
      {
        point.node = static_cast<int>(node);
        return point;
      }
    point.weights.resize(static_cast<std::size_t>(nodes));
    cell_->InterpolateFunctions(place.data(), point.weights.data());
    this->findFace(place, point);
    return point;
  }

  /// The corners of the face that a point lies in are those that a linear cell would take it from.
  void findFace(const Place& place, CellLattice::Point& point) const
  {
    double weights[8] = {};
    if (shape_ == Shape::Hexahedron)
      vtkHexahedron::InterpolationFunctions(place.data(), weights);
    else if (shape_ == Shape::Wedge)
      vtkWedge::InterpolationFunctions(place.data(), weights);
    else
      vtkPyramid::InterpolationFunctions(place.data(), weights);
    std::vector<int> corners;
    for (int corner = 0; corner < 8; ++corner)
      if (std::abs(weights[corner]) > 1e-9)
        corners.push_back(corner);
    if (corners.size() == 4)
      std::copy(corners.begin(), corners.end(), point.corners.begin());
  }

  void add(int type, std::vector<int> points)
  {
    lattice_.cells.push_back({type, std::move(points)});
  }

  /// A tetrahedron, in the order that is not inside out.
  void addTetrahedron(int a, int b, int c, int d)
  {
    if (volumeOf(places_[a], places_[b], places_[c], places_[d]) < 0.0)
      std::swap(c, d);
    this->add(VTK_TETRA, {a, b, c, d});
  }

  void cutTetrahedron()
  {
    const int n = order_[0];
    for (int k = 0; k < n; ++k)
      for (int j = 0; j + k < n; ++j)
        for (int i = 0; i + j + k < n; ++i)
        {
          const int x = this->at(i + 1, j, k), y = this->at(i, j + 1, k), z = this->at(i, j, k + 1);
          this->addTetrahedron(this->at(i, j, k), x, y, z);
          if (i + j + k + 2 > n)
            continue;
          // Between four of these an octahedron is left, which is cut along a diagonal.
          const int xy = this->at(i + 1, j + 1, k), xz = this->at(i + 1, j, k + 1),
                    yz = this->at(i, j + 1, k + 1);
          this->addTetrahedron(x, yz, y, xy);
          this->addTetrahedron(x, yz, xy, xz);
          this->addTetrahedron(x, yz, xz, z);
          this->addTetrahedron(x, yz, z, y);
          if (i + j + k + 3 <= n)
            this->addTetrahedron(xy, xz, yz, this->at(i + 1, j + 1, k + 1));
        }
  }

  void cutHexahedron()
  {
    for (int k = 0; k < order_[2]; ++k)
      for (int j = 0; j < order_[1]; ++j)
        for (int i = 0; i < order_[0]; ++i)
          this->add(VTK_HEXAHEDRON,
            {this->at(i, j, k), this->at(i + 1, j, k), this->at(i + 1, j + 1, k),
              this->at(i, j + 1, k), this->at(i, j, k + 1), this->at(i + 1, j, k + 1),
              this->at(i + 1, j + 1, k + 1), this->at(i, j + 1, k + 1)});
  }

  void cutWedge()
  {
    const int n = order_[0];
    const auto add = [&](int k, std::array<std::array<int, 2>, 3> triangle)
    {
      std::vector<int> points;
      for (const int layer : {k, k + 1})
        for (const auto& [i, j] : triangle)
          points.push_back(this->at(i, j, layer));
      this->add(VTK_WEDGE, points);
    };
    for (int k = 0; k < order_[2]; ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i + j < n; ++i)
        {
          add(k, {{{i, j}, {i + 1, j}, {i, j + 1}}});
          if (i + j + 2 <= n)
            add(k, {{{i + 1, j + 1}, {i, j + 1}, {i + 1, j}}});
        }
  }

  /// By its nodes, as coordinates of a pyramid are all one at its tip: corners 0 to 3 and the tip
  /// 4, middles of the base's edges 5 to 8, of the others 9 to 12, and the base's own middle.
  void cutPyramid()
  {
    for (int node = 0; node < 13; ++node)
    {
      CellLattice::Point point;
      point.node = node;
      lattice_.points.push_back(point);
    }
    constexpr int middle = 13;
    lattice_.points.push_back(this->pointAt({0.5, 0.5, 0.0}));
    this->add(VTK_PYRAMID, {0, 5, middle, 8, 9});
    this->add(VTK_PYRAMID, {5, 1, 6, middle, 10});
    this->add(VTK_PYRAMID, {middle, 6, 2, 7, 11});
    this->add(VTK_PYRAMID, {8, middle, 7, 3, 12});
    this->add(VTK_PYRAMID, {9, 10, 11, 12, 4});
    this->add(VTK_PYRAMID, {9, 12, 11, 10, middle});
    this->add(VTK_TETRA, {5, middle, 9, 10});
    this->add(VTK_TETRA, {6, middle, 10, 11});
    this->add(VTK_TETRA, {7, middle, 11, 12});
    this->add(VTK_TETRA, {8, middle, 12, 9});
  }

  vtkCell* cell_;
  CellLattice::Order order_;
  CellLattice& lattice_;
  Shape shape_;
  std::vector<Place> places_; ///< of the lattice's points
};

/// How many nodes a cell of Lagrange type and such an order has.
vtkIdType lagrangeNodes(Shape shape, const CellLattice::Order& order)
{
  const vtkIdType a = order[0], b = order[1], c = order[2];
  return shape == Shape::Hexahedron ? (a + 1) * (b + 1) * (c + 1)
         : shape == Shape::Wedge    ? (a + 1) * (a + 2) / 2 * (c + 1)
                                    : (a + 1) * (a + 2) * (a + 3) / 6;
}

/// How many nodes a quadratic cell has; 0 for other types.
int quadraticNodes(int type)
{
  switch (type)
  {
  case VTK_QUADRATIC_TETRA:
    return 10;
  case VTK_QUADRATIC_HEXAHEDRON:
    return 20;
  case VTK_TRIQUADRATIC_HEXAHEDRON:
    return 27;
  case VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON:
    return 24;
  case VTK_QUADRATIC_WEDGE:
    return 15;
  case VTK_QUADRATIC_LINEAR_WEDGE:
    return 12;
  case VTK_BIQUADRATIC_QUADRATIC_WEDGE:
    return 18;
  case VTK_QUADRATIC_PYRAMID:
    return 13;
  default:
    return 0;
  }
}

} // namespace

bool CellLattice::cuts(int type)
{
  return shapeOf(type) != Shape::None;
}

std::optional<CellLattice::Order> CellLattice::orderOf(
  int type, vtkIdType nodes, const std::optional<Order>& told)
{
  const Shape shape = shapeOf(type);
  if (shape == Shape::None)
    return std::nullopt;
  if (const int wanted = quadraticNodes(type))
    return nodes == wanted ? std::optional(Order{2, 2, type == VTK_QUADRATIC_LINEAR_WEDGE ? 1 : 2})
                           : std::nullopt;
  constexpr int highest = 10; // that VTK takes
  const auto isGood = [&](const Order& order)
  {
    return std::all_of(order.begin(), order.end(), [](int n) { return n >= 1 && n <= highest; }) &&
           (shape == Shape::Hexahedron || order[0] == order[1]) &&
           nodes == lagrangeNodes(shape, order);
  };
  if (told)
    return isGood(*told) ? told : std::nullopt;
  for (int n = 1; n <= highest; ++n)
    if (isGood({n, n, n}))
      return Order{n, n, n};
  return std::nullopt;
}

const CellLattice& CellLattices::of(vtkCell* cell, const CellLattice::Order& order)
{
  auto& lattice = lattices_[{cell->GetCellType(), order[0], order[1], order[2]}];
  if (!lattice)
  {
    lattice = std::make_unique<CellLattice>();
    Builder(cell, order, *lattice).build();
  }
  return *lattice;
}
