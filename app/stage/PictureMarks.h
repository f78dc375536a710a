#pragma once

#include "PickedSet.h"

#include <array>
#include <vector>

class vtkCamera;
class vtkMoteImageMarks;
class vtkPolyData;

namespace mote::app
{

/// Draws over a picture what the window draws over its view: veils and rulers of what is picked,
/// paths of particles.
class PictureMarks
{
public:
  /// For pictures of this size in pixels, seen by the camera.
  PictureMarks(vtkCamera* camera, const std::array<int, 2>& size, vtkMoteImageMarks* to);

  void addPicked(
    const PickedSet::Parts& parts, const PickedSet& picked, const std::vector<std::size_t>& shown);
  /// Lines with colours of cells, as ParticlePaths::fill() makes them.
  void addPaths(vtkPolyData* lines);

private:
  using Place = std::array<double, 3>;
  void addRuler(const PickedSet::Parts& parts, const PickedSet& picked);
  void addLine(Place from, Place to, const double color[3], double width, bool onTop);
  Place inEye(const Place& place) const;
  Place inPicture(const Place& eye) const;

  vtkMoteImageMarks* to_;
  std::array<int, 2> size_;
  bool isParallel_;
  Place position_{}, right_{}, up_{}, forward_{};
  double half_;  ///< of the view's height: world units, or at distance 1
  double scale_; ///< factor on widths in pixels
};

} // namespace mote::app
