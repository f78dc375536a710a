#pragma once

#include "stage/CutHandles.h"
#include "stage/Stage.h"

#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <array>
#include <optional>
#include <vector>

class vtkRenderer;

namespace mote::app
{

/// Outlines and marks of slices and of faces of cuts in a view, by which they are dragged. Nothing
/// is traced for them, and pictures have none.
class HandleMarks
{
public:
  explicit HandleMarks(vtkRenderer* renderer);

  /// Whether they are seen where the settings leave it open.
  void offer(bool on) { isOffered_ = on; }
  /// Follows the settings and these parts; none of them: no handles. Returns whether others are
  /// seen.
  bool update(const Stage& stage, const std::vector<std::size_t>& parts);
  /// What is held by the handle at a place of the window, in pixels; none where there is none.
  std::optional<CutGrip> at(const Settings& shown, const std::array<int, 2>& place) const;
  /// The size of marks: 1 for a display of 96 dots an inch.
  void setScale(double scale);

private:
  std::array<double, 2> inWindow(const CutHandle::Place& place) const;
  std::optional<CutHandle::Place> nearOutline(
    const CutHandle& handle, const std::array<int, 2>& place) const;

  vtkRenderer* renderer_;
  bool isOffered_ = false;
  double scale_ = 1.0;
  std::vector<CutHandle> handles_;
  vtkNew<vtkPolyData> lines_, middles_;
  vtkNew<vtkActor> outlines_;
  vtkNew<vtkActor2D> rims_, marks_; ///< of the middles, the one around the other
};

} // namespace mote::app
