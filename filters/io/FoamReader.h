#ifndef MoteFoamReader_h
#define MoteFoamReader_h

#include "vtkSmartPointer.h"

#include <string>

class vtkAlgorithm;

namespace mote
{

/// A reader of an OpenFOAM case by any file in its folder or in its folder system, such as
/// case.foam or system/controlDict, with all arrays and patches on. A case that is split into
/// processor folders is read from these where it has not been put together, or not for as many
/// times. Polyhedra stay as they are. Throws FileError as foamCaseOf() does.
vtkSmartPointer<vtkAlgorithm> makeFoamReader(const std::string& fileName);

} // namespace mote

#endif
