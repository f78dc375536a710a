#include "BoxCuts.h"

#include <algorithm>

namespace mote
{

BoxCuts::BoxCuts(std::vector<Place> places, const vtkBoundingBox& all, int boxes)
  : boxes_(boxes)
  , axis_(boxes > mostSlabs ? -1 : longestAxis(places.begin(), places.end()))
{
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
  const int axis = axis_ >= 0 ? axis_ : longestAxis(begin, end), lowBoxes = boxes / 2;
  const Iterator middle = begin + (end - begin) * lowBoxes / boxes;
  std::nth_element(
    begin, middle, end, [axis](const Place& a, const Place& b) { return a[axis] < b[axis]; });
  const double value = (*middle)[axis];
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
