#pragma once

#include "MoteRenderingDataModule.h" // for export macro
#include "vtkBoundingBox.h"

#include <array>
#include <vector>

namespace mote
{

/// Space cut into boxes with about as many places in each, by halves along the longest side. Boxes
/// beside one another have a face in common, so that there is an order of all from any view.
class MOTERENDERINGDATA_EXPORT BoxCuts
{
public:
  using Place = std::array<double, 3>;

  /// `places`, of which a sample does, tell where to cut what lies in `all` into so many boxes.
  BoxCuts(std::vector<Place> places, const vtkBoundingBox& all, int boxes);

  /// The number of the box that a place lies in, from 0.
  int boxOf(const double* place) const;
  /// Invalid where there were too few places for all boxes.
  const vtkBoundingBox& bounds(int box) const { return boxes_[box]; }

private:
  struct Node
  {
    int axis = -1; ///< -1: a box
    double value = 0.0;
    int low = 0, high = 0, box = 0;
  };
  using Iterator = std::vector<Place>::iterator;

  static double valueAt(Iterator begin, Iterator middle, Iterator end, int axis);
  static int longestAxis(Iterator begin, Iterator end);
  int cut(Iterator begin, Iterator end, const vtkBoundingBox& bounds, int firstBox, int boxes);

  std::vector<Node> nodes_;
  std::vector<vtkBoundingBox> boxes_;
};

} // namespace mote
