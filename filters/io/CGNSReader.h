#ifndef MoteCGNSReader_h
#define MoteCGNSReader_h

#include "vtkSmartPointer.h"

#include <string>

class vtkAlgorithm;

namespace mote
{

/// A vtkCGNSReader with all bases, families, arrays and boundary patches on, which looks at the
/// file before it reads: counts and sizes that do not fit together, which VTK 9.1's reader would
/// trust, are an error. CGNS's library has one state for all: readers of several threads wait for
/// one another.
vtkSmartPointer<vtkAlgorithm> makeCGNSReader(const std::string& fileName);

} // namespace mote

#endif
