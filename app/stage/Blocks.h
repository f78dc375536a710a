#pragma once

#include "Input.h"

#include <string>
#include <vector>

class vtkDataObject;

namespace mote::app
{

/// A data object of one's own that shares the arrays; of composite data with blocks of its own.
vtkSmartPointer<vtkDataObject> sharingCopy(vtkDataObject* object);

/// The data sets of what a reader made of a file that is called `name`: the data themselves, or
/// all that lie in composite data, in VTK's order. Those are called as their blocks are, "inlet";
/// where several are called the same, the names of the blocks that they lie in stand before,
/// "rotor/inlet". Images and structured grids have become hexahedra, which are drawn as a volume.
///
/// Beside a volume, surfaces are marked as boundaries: patches of a case hide what is within.
///
/// Throws Failure for what has no points in space.
std::vector<NamedData> dataSetsOf(vtkDataObject* object, const std::string& name);

} // namespace mote::app
