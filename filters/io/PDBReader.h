#ifndef MotePDBReader_h
#define MotePDBReader_h

#include "vtkSmartPointer.h"

#include <string>

class vtkAlgorithm;

namespace mote
{

/// A vtkPDBReader that reports damaged files (see checkPDB) whenever it reads, whose models are
/// time steps, and which gives "radius" one component, as arrays of radii have, where VTK's has the
/// radius three times.
vtkSmartPointer<vtkAlgorithm> makePDBReader(const std::string& fileName);

} // namespace mote

#endif
