#pragma once

#include "VTKTestSupport.h"

#include "vtkMoteVolumeMapper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <functional>

namespace mote::testing
{

using Field = std::function<double(const Point&)>;

/// n x n x n hexahedra in [-1, 1]^3, with the field at their points ("f", float, the active
/// scalars) and in the middles of cells ("c", double).
vtkSmartPointer<vtkUnstructuredGrid> makeBox(int n, const Field& field);

/// The same numbers in other objects.
vtkSmartPointer<vtkUnstructuredGrid> copyOf(vtkUnstructuredGrid* grid);

/// The same cells, each with points of its own, which have the values of those that they were.
vtkSmartPointer<vtkUnstructuredGrid> cellsApart(vtkUnstructuredGrid* grid);

/// A vtkVolume with Mote's mapper, in one colour and with one opacity a unit length for all values.
struct VolumeProp
{
  explicit VolumeProp(vtkUnstructuredGrid* grid = nullptr);

  vtkNew<vtkMoteVolumeMapper> mapper;
  vtkNew<vtkVolume> volume;

  vtkVolumeProperty* property() const { return volume->GetProperty(); }
  void paint(const Point& color, double opacity) const;
};

/// What `opacity` a unit length covers along a path.
double covered(double opacity, double length);

/// The length of the ray through an image position inside of [-1, 1]^3, moved by `place`, and no
/// farther than `depth` along the view axis.
double chord(const TrueView& view, double x, double y, const Point& place = {0, 0, 0},
  double depth = std::numeric_limits<double>::infinity());

/// A renderer with a camera on the z axis that sees [-1.5, 1.5]^2, and a volume in it.
struct VolumeStage : VolumeProp
{
  explicit VolumeStage(vtkUnstructuredGrid* grid = nullptr, bool parallel = false);
  vtkNew<vtkRenderer> renderer;
  vtkCamera* camera() const;
  Picture trace(int width = 32, int height = 32, int samples = 1) const;
  TrueView view(int width = 32, int height = 32) const;
};

} // namespace mote::testing
