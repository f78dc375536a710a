#pragma once

#include "MoteRenderingDataModule.h" // for export macro
#include "vtkBoundingBox.h"

#include <array>
#include <vector>

namespace mote
{

/// Space cut into boxes with about as many places in each, by halves along the longest side. Up to
/// eight are slabs side by side instead: ParaView's order of boxes fails for some views where two
/// are beside one another along an edge alone.
class MOTERENDERINGDATA_EXPORT BoxCuts
{
public:
  using Place = std::array<double, 3>;
  static constexpr int mostSlabs = 8;

  /// `places`, of which a sample does, tell where to cut what lies in `all` into so many boxes.
  BoxCuts(std::vector<Place> places, const vtkBoundingBox& all, int boxes);

  /// The number of the box that a place lies in, from 0.
  int boxOf(const double* place) const;
  /// Invalid where there were too few places for all boxes.
  const vtkBoundingBox& bounds(int box) const { return boxes_[box]; }
  bool areSlabs() const { return axis_ >= 0; }

private:
  struct Node
  {
    int axis = -1; ///< -1: a box
    double value = 0.0;
    int low = 0, high = 0, box = 0;
  };
  using Iterator = std::vector<Place>::iterator;

  static int longestAxis(Iterator begin, Iterator end);
  int cut(Iterator begin, Iterator end, const vtkBoundingBox& bounds, int firstBox, int boxes);

  std::vector<Node> nodes_;
  std::vector<vtkBoundingBox> boxes_;
  const int axis_; ///< of all cuts; -1: of the longest side each
};

} // namespace mote
