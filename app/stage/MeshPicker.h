#pragma once

#include "Part.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>
#include <map>
#include <optional>

class vtkPolyData;
class vtkStaticCellLocator;

namespace mote::app
{

/// Finds points of meshes on a line. What it looks through is made for a mesh when it is asked for
/// first.
class MeshPicker
{
public:
  struct Hit
  {
    vtkIdType point = 0;      ///< of the part's data: the nearest corner of the face that is met
    std::array<double, 3> at; ///< where the face is met
    double share = 0.0;       ///< of the way
  };
  /// The first face of a part that is shown as a surface, on the way from one place to the other.
  std::optional<Hit> hit(
    const Part& part, const std::array<double, 3>& from, const std::array<double, 3>& to);

private:
  struct Faces
  {
    vtkSmartPointer<vtkPolyData> surface;
    vtkSmartPointer<vtkStaticCellLocator> locator;
    vtkMTimeType time = 0;
  };
  std::map<const Part*, Faces> faces_;
};

} // namespace mote::app
