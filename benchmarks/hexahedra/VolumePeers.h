#pragma once

#include "VolumeTask.h"

#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <memory>
#include <string>
#include <vector>

namespace mote::bench
{

/// Names and lines about VTK's mappers.
const std::vector<Named>& volumePeers();

/// An input as tetrahedra, of vtkDataSetTriangleFilter: what VTK's mappers draw.
struct Tetrahedra
{
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  double seconds = 0.0;
  double megabytes = 0.0; ///< of 1e6 bytes, points and values included
};
Tetrahedra makeTetrahedra(const HexInput& input);

/// One of VTK's mappers with a window off the screen.
class VolumePeer
{
public:
  /// `name` is one of volumePeers(); task and tetrahedra must outlive this.
  VolumePeer(const std::string& name, const VolumeTask& task, const Tetrahedra& tetrahedra);
  ~VolumePeer();

  /// Draws a frame, and answers how many seconds it took until it was in the window's memory.
  double draw();

  /// Premultiplied red, green, blue and alpha of the last frame, row after row from the bottom, in
  /// steps of 1/255.
  std::vector<float> colors() const;

private:
  struct Pipeline;
  std::unique_ptr<Pipeline> pipeline_;
};

} // namespace mote::bench
