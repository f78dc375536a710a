#pragma once

#include "stage/Measure.h"

#include <vtkNew.h>

#include <array>

class vtkActor2D;
class vtkPolyData;
class vtkRenderer;
class vtkTextActor;

namespace mote::app
{

/// The lines between two or three picked, with their lengths and the angle, over the window's view.
class Ruler
{
public:
  explicit Ruler(vtkRenderer* renderer);
  ~Ruler();

  /// Follows what is picked, where any of it is in these parts.
  void update(
    const PickedSet::Parts& parts, const PickedSet& picked, const std::vector<std::size_t>& shown);
  /// The size of its texts and lines: 1 for a display of 96 dots an inch.
  void setScale(double scale);

private:
  void label(std::size_t number, const std::string& text, const Place& place);
  void part();

  vtkRenderer* renderer_;
  vtkNew<vtkPolyData> lines_;
  vtkNew<vtkActor2D> edge_, actor_;            ///< dark lines, and bright ones over them
  std::array<vtkNew<vtkTextActor>, 3> labels_; ///< of two distances and an angle
};

} // namespace mote::app
