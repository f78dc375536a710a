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

} // namespace mote
