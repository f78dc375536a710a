#include "BoxCuts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace mote
{

BoxCuts::BoxCuts(std::vector<Place> places, const vtkBoundingBox& all, int boxes)
  : boxes_(boxes)
{
  // Which have no order.
  std::erase_if(places, [](const Place& at)
    { return !std::isfinite(at[0]) || !std::isfinite(at[1]) || !std::isfinite(at[2]); });
  this->cut(places.begin(), places.end(), all, 0, boxes);
}

int BoxCuts::boxOf(const double* place) const
{
  int node = 0;
  while (nodes_[node].axis >= 0)
    node = place[nodes_[node].axis] < nodes_[node].value ? nodes_[node].low : nodes_[node].high;
  return nodes_[node].box;
}

int BoxCuts::longestAxis(Iterator begin, Iterator end)
{
  vtkBoundingBox box;
  std::for_each(begin, end, [&](Place& place) { box.AddPoint(place.data()); });
  double sides[3] = {0.0, 0.0, 0.0};
  if (box.IsValid())
    box.GetLengths(sides);
  return static_cast<int>(std::max_element(sides, sides + 3) - sides);
}

/// Where to cut along an axis so that the places before `middle` are below, or about as many: those
/// of the same value stay together.
double BoxCuts::valueAt(Iterator begin, Iterator middle, Iterator end, int axis)
{
  std::nth_element(
    begin, middle, end, [axis](const Place& a, const Place& b) { return a[axis] < b[axis]; });
  const double value = (*middle)[axis];
  double next = std::numeric_limits<double>::infinity();
  std::ptrdiff_t below = 0, upTo = 0;
  for (Iterator place = begin; place != end; ++place)
  {
    below += (*place)[axis] < value;
    upTo += (*place)[axis] <= value;
    if ((*place)[axis] > value)
      next = std::min(next, (*place)[axis]);
  }
  const std::ptrdiff_t wanted = middle - begin;
  const bool isNext = upTo < end - begin && (below == 0 || upTo - wanted < wanted - below);
  return isNext ? next : value;
}

/// Makes the node of these places and boxes, and those below; answers its number.
int BoxCuts::cut(
  Iterator begin, Iterator end, const vtkBoundingBox& bounds, int firstBox, int boxes)
{
  const auto number = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  nodes_[number].box = firstBox;
  if (boxes == 1 || begin == end)
  {
    boxes_[firstBox] = bounds;
    return number;
  }
  const int axis = longestAxis(begin, end), lowBoxes = boxes / 2;
  const double value = valueAt(begin, begin + (end - begin) * lowBoxes / boxes, end, axis);
  const Iterator middle =
    std::partition(begin, end, [&](const Place& place) { return place[axis] < value; });
  double lowBounds[6], highBounds[6];
  bounds.GetBounds(lowBounds);
  bounds.GetBounds(highBounds);
  lowBounds[2 * axis + 1] = highBounds[2 * axis] = value;
  const int low = this->cut(begin, middle, vtkBoundingBox(lowBounds), firstBox, lowBoxes);
  const int high =
    this->cut(middle, end, vtkBoundingBox(highBounds), firstBox + lowBoxes, boxes - lowBoxes);
  nodes_[number] = {axis, value, low, high, firstBox};
  return number;
}

} // namespace mote
