#pragma once

#include "BoxEdges.h"
#include "HandleMarks.h"
#include "PathLines.h"
#include "PickedMarks.h"
#include "Ruler.h"

#include <vtkNew.h>
#include <vtkRenderer.h>

#include <vector>

namespace mote::app
{

/// What stands in a view beside the data: box, marks and ruler of what is picked, paths.
class View
{
public:
  explicit View(vtkRenderer* renderer)
    : renderer_(renderer)
    , marks_(renderer)
    , ruler_(renderer)
    , box_(renderer)
    , paths_(renderer)
    , handles_(renderer)
  {
  }

  vtkRenderer* renderer() const { return renderer_; }
  PickedMarks& marks() { return marks_; }
  const HandleMarks& handles() const { return handles_; }
  /// Whether handles are seen where the settings leave it open; returns whether others are.
  bool offerHandles(const Stage& stage, bool on)
  {
    handles_.offer(on);
    return handles_.update(stage, parts_);
  }
  /// The parts that are shown here.
  const std::vector<std::size_t>& parts() const { return parts_; }

  /// What it shows from now on, of other data or with other settings.
  void show(const Stage& stage, const std::vector<std::size_t>& parts, const ParticlePaths* paths);
  /// Follows the picked and the camera; call before each frame.
  void update(const Stage& stage, const PickedSet& picked);
  /// The size of texts: 1 for a display of 96 dots an inch.
  void setScale(double scale)
  {
    ruler_.setScale(scale);
    handles_.setScale(scale);
  }

private:
  vtkRenderer* renderer_;
  PickedMarks marks_;
  Ruler ruler_;
  BoxEdges box_;
  PathLines paths_;
  HandleMarks handles_;
  std::vector<std::size_t> parts_;
};

} // namespace mote::app
