#pragma once

#include "DataArrayView.h"
#include "ParticleInput.h"

#include "kernels/shading/TransferFunction.h"

#include "vtkSmartPointer.h"

#include <string>

class vtkDataSet;
class vtkMapper;
class vtkVolumeProperty;

namespace mote
{

struct SurfaceColoring;

/// Colour by array in the kernels' form: of what has points, as any vtkMapper is told it, and of
/// volumes and the surfaces in them, as a vtkVolumeProperty tells it. Keeps between frames what
/// takes long to make.
class ArrayColors
{
public:
  /// The array of `data`, with a tuple for each point, that colours what the mapper draws; null
  /// where it is told to use no colours, or none that is there. With `ofCells` arrays with a tuple
  /// for each cell are taken, too, and it becomes true where it is one.
  static vtkDataArray* arrayOf(vtkMapper* mapper, vtkDataSet* data, bool* ofCells = nullptr);
  /// The component of the array that is looked up, or ArrayView::magnitude.
  static int componentOf(vtkMapper* mapper, vtkDataArray* array);
  /// The value of tuple `id` that is looked up; NaN where there is none.
  static double valueOf(vtkMapper* mapper, vtkDataArray* array, vtkIdType id);

  /// Describes the colours of the points, or as arrayOf() of points or cells; leaves them alone
  /// where no array gives any. Returns a sentence where an array that was asked for by name is
  /// missing, else nothing. Views hold until the next call.
  std::string describe(
    vtkMapper* mapper, vtkDataSet* data, SurfaceColoring& coloring, bool* ofCells = nullptr);

  /// transferOf(property), made anew where that has changed.
  const TransferFunction& describe(vtkVolumeProperty* property);

private:
  DataArrayView values_; ///< copied once where they are not one piece of memory
  InputKey valuesKey_;
  vtkSmartPointer<vtkDataArray> mapped_; ///< colours that only VTK can make
  InputKey mappedKey_;
  TransferFunction transfer_;
  InputKey transferKey_; ///< the property that it was made from, and when
};

} // namespace mote
