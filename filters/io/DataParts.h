#pragma once

#include "MoteFiltersIOModule.h" // for export macro
#include "vtkSmartPointer.h"

class vtkDataSet;
class vtkIdList;
class vtkPointSet;
class vtkPolyData;

namespace mote
{

/// Some points of a data set, by their numbers, with their arrays and without cells.
MOTEFILTERSIO_EXPORT vtkSmartPointer<vtkPolyData> pointsOf(vtkDataSet* data, vtkIdList* ids);

/// Some cells, by their numbers, with their points and all arrays: a vtkPolyData of one, else a
/// vtkUnstructuredGrid.
MOTEFILTERSIO_EXPORT vtkSmartPointer<vtkDataSet> cellsOf(vtkDataSet* data, vtkIdList* ids);

/// The data set without the points that vtkGhostType marks as copies or hidden, and without cells;
/// the data set itself where none is.
MOTEFILTERSIO_EXPORT vtkSmartPointer<vtkPointSet> withoutMarkedPoints(vtkPointSet* data);

} // namespace mote
