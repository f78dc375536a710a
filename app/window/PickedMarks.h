#pragma once

#include "stage/PickedPlaces.h"

#include <vtkNew.h>

#include <array>
#include <vector>

class vtkActor;
class vtkActor2D;
class vtkOpenGLSphereMapper;
class vtkPoints;
class vtkPolyData;
class vtkRenderer;

namespace mote::app
{

/// What marks the picked in the window: a veil of one colour over each particle and point, the
/// edges of each cell; and the rectangle that is being drawn to pick by. Nothing is traced for
/// them.
class PickedMarks
{
public:
  explicit PickedMarks(vtkRenderer* renderer);
  ~PickedMarks();

  /// Follows the picked and the camera. Call before each frame; where nothing has changed it does
  /// nothing. What is picked and not shown now has no mark.
  void update(const PickedSet::Parts& parts, const PickedSet& picked);
  /// Only these parts have marks.
  void setParts(const std::vector<std::size_t>& parts);
  /// Makes all marks anew in the next update(): what is shown has changed.
  void forget() { isOld_ = true; }

  /// A rectangle between two corners in pixels of the view.
  void showRectangle(double x0, double y0, double x1, double y1);
  void hideRectangle();

private:
  void gather(const PickedSet::Parts& parts, const PickedSet& picked);
  void setCenters(vtkPoints* places);
  void addCell(const std::vector<CellEdge>& edges);
  void setSizes();

  vtkRenderer* renderer_;
  vtkNew<vtkActor> veils_, edges_;
  vtkNew<vtkOpenGLSphereMapper> veilMapper_;
  vtkNew<vtkPolyData> centers_, lines_;
  vtkNew<vtkPolyData> frame_;
  vtkNew<vtkActor2D> rectangle_;
  std::vector<float> radii_;                   ///< of the marked, as drawn
  std::vector<std::array<double, 3>> offsets_; ///< of their places from that of veils_
  unsigned long version_ = 0;
  vtkMTimeType cameraTime_ = 0;
  bool isOld_ = false;
  std::vector<std::size_t> marked_; ///< parts
};

} // namespace mote::app
