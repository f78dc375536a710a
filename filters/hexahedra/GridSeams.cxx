#include "GridSeams.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

namespace mote
{

namespace
{

using Pairs = std::vector<std::pair<vtkIdType, vtkIdType>>;

class SeamFinder
{
public:
  SeamFinder(vtkStructuredGrid* grid, const std::array<vtkIdType, 3>& along)
    : grid_(grid)
    , along_(along)
    , strides_{1, along[0], along[0] * along[1]}
    , length_(grid->GetLength())
  {
  }

  std::vector<vtkIdType> find()
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const vtkIdType far = (along_[axis] - 1) * strides_[axis];
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      if (along_[axis] > 3)
        this->joinFaces({strides_[axis], -strides_[axis]}, along_[u], along_[v],
          [&](vtkIdType i, vtkIdType k)
          {
            const vtkIdType a = i * strides_[u] + k * strides_[v];
            return std::pair(a, a + far);
          });
      for (const vtkIdType side : {vtkIdType(0), far})
      {
        this->fold(side, u, v);
        this->fold(side, v, u);
      }
    }
    for (vtkIdType& stand : stands_)
      stand = this->least(stand);
    return std::move(stands_);
  }

private:
  /// The way from each of two points into the grid.
  struct Inwards
  {
    vtkIdType first, second;
  };

  /// A side that may be folded along its axis u, up to its middle.
  void fold(vtkIdType side, int u, int v)
  {
    if (along_[u] < 4)
      return;
    this->joinFaces(
      {strides_[u], -strides_[u]}, (along_[u] + 1) / 2, along_[v],
      [&](vtkIdType i, vtkIdType k)
      {
        const vtkIdType row = side + k * strides_[v];
        return std::pair(row + i * strides_[u], row + (along_[u] - 1 - i) * strides_[u]);
      },
      true);
  }

  /// Joins faces all corners of which, of nu * nv that pairOf(i, k) pairs, are at one place; none
  /// where `isFold` and all are.
  template <typename PairOf>
  void joinFaces(
    const Inwards& inwards, vtkIdType nu, vtkIdType nv, const PairOf& pairOf, bool isFold = false)
  {
    const auto at = [nu](vtkIdType i, vtkIdType k) { return static_cast<std::size_t>(i + nu * k); };
    std::vector<std::uint8_t> isOne(static_cast<std::size_t>(nu * nv)), isJoined(isOne.size());
    for (vtkIdType k = 0; k < nv; ++k)
      for (vtkIdType i = 0; i < nu; ++i)
        isOne[at(i, k)] = this->areAtOnePlace(pairOf(i, k), inwards);
    if (isFold && std::find(isOne.begin(), isOne.end(), 0) == isOne.end())
      return;
    Pairs met;
    for (vtkIdType k = 0; k + 1 < nv; ++k)
      for (vtkIdType i = 0; i + 1 < nu; ++i)
        if (isOne[at(i, k)] && isOne[at(i + 1, k)] && isOne[at(i, k + 1)] &&
            isOne[at(i + 1, k + 1)])
          for (const auto& [a, b] : {std::pair(i, k), {i + 1, k}, {i, k + 1}, {i + 1, k + 1}})
            if (std::exchange(isJoined[at(a, b)], 1) == 0)
              met.push_back(pairOf(a, b));
    this->join(met);
  }

  /// Whether two points are, and not such with which others of their sides are, too, as at a pole.
  /// The point in the middle of a fold is one by itself.
  bool areAtOnePlace(const std::pair<vtkIdType, vtkIdType>& pair, const Inwards& inwards) const
  {
    const auto [a, b] = pair;
    if (a == b)
      return true;
    double p[3], q[3], next[3], other[3];
    grid_->GetPoint(a, p);
    grid_->GetPoint(b, q);
    const double distance = std::sqrt(vtkMath::Distance2BetweenPoints(p, q));
    if (!(distance <= 1e-6 * length_))
      return false;
    grid_->GetPoint(a + inwards.first, next);
    grid_->GetPoint(b + inwards.second, other);
    const double size = std::sqrt(std::min(
      vtkMath::Distance2BetweenPoints(p, next), vtkMath::Distance2BetweenPoints(q, other)));
    return size > 3e-7 * length_ && distance <= 1e-3 * size;
  }

  /// Lets one stand for the other where values are the same.
  void join(const Pairs& met)
  {
    std::vector<std::uint8_t> isOne(met.size(), 1);
    vtkPointData* arrays = grid_->GetPointData();
    for (int n = 0; n < arrays->GetNumberOfArrays(); ++n)
      if (vtkDataArray* array = arrays->GetArray(n);
          array && array->GetNumberOfTuples() == grid_->GetNumberOfPoints())
        for (int c = 0; c < array->GetNumberOfComponents(); ++c)
          compare(met, *array, c, isOne);
    for (std::size_t i = 0; i < met.size(); ++i)
    {
      if (isOne[i] == 0)
        continue;
      if (stands_.empty())
      {
        stands_.resize(static_cast<std::size_t>(grid_->GetNumberOfPoints()));
        std::iota(stands_.begin(), stands_.end(), vtkIdType(0));
      }
      const vtkIdType a = this->least(met[i].first), b = this->least(met[i].second);
      stands_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
  }
  vtkIdType least(vtkIdType point) const
  {
    while (stands_[static_cast<std::size_t>(point)] != point)
      point = stands_[static_cast<std::size_t>(point)];
    return point;
  }
  static void compare(
    const Pairs& met, vtkDataArray& array, int component, std::vector<std::uint8_t>& isOne)
  {
    double largest = 0.0;
    for (const auto& [a, b] : met)
      for (const vtkIdType point : {a, b})
        if (const double value = std::abs(array.GetComponent(point, component));
            std::isfinite(value))
          largest = std::max(largest, value);
    for (std::size_t i = 0; i < met.size(); ++i)
    {
      const double a = array.GetComponent(met[i].first, component);
      const double b = array.GetComponent(met[i].second, component);
      if (!(a == b || std::abs(a - b) <= 1e-6 * largest || (std::isnan(a) && std::isnan(b))))
        isOne[i] = 0;
    }
  }

  vtkStructuredGrid* const grid_;
  const std::array<vtkIdType, 3> along_, strides_;
  const double length_;
  std::vector<vtkIdType> stands_;
};

} // namespace

std::vector<vtkIdType> seamsOf(vtkStructuredGrid* grid, const std::array<vtkIdType, 3>& along)
{
  return SeamFinder(grid, along).find();
}

} // namespace mote
