#pragma once

#include "MoteRenderingDataModule.h" // For export macro

#include "kernels/core/ArrayView.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

namespace mote
{

/// The kernels' name for a type of VTK's numbers; None where they have none, as for bits.
MOTERENDERINGDATA_EXPORT ArrayView::Type viewTypeOf(int vtkType);

/// A VTK array as the kernels see it, and what keeps its memory alive. Arrays of tuples in one
/// piece of memory are viewed as they are; others (structure of arrays, bits, implicit) are copied.
struct DataArrayView
{
  vtkSmartPointer<vtkDataArray> owner;
  ArrayView view;

  DataArrayView() = default;
  MOTERENDERINGDATA_EXPORT explicit DataArrayView(vtkDataArray* array);
};

} // namespace mote
