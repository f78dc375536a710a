#pragma once

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkDataObject;
class vtkPointSet;

namespace mote
{

/// The data sets with points that a data set or a composite of them is made of; none where it is
/// null.
std::vector<vtkPointSet*> pointSetsOf(vtkDataObject* data);

/// The points of these with their arrays, those that all have where there are several, and no
/// cells.
vtkSmartPointer<vtkPolyData> collectPoints(const std::vector<vtkPointSet*>& parts);

/// The data without points that are copies of what another rank has; the data itself where there
/// are none.
vtkSmartPointer<vtkPolyData> withoutGhosts(vtkPolyData* data);

} // namespace mote
