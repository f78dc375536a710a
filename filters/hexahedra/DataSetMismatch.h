#ifndef MoteDataSetMismatch_h
#define MoteDataSetMismatch_h

#include "MoteFiltersHexahedraModule.h" // For export macro

#include <string>

class vtkDataObject;

namespace mote
{

/// What does not fit together in a data set, or in one that a composite one holds: cells that name
/// points that are not there, or a grid with another number of points or coordinates than its
/// dimensions say. VTK reads such files, and crashes later. Part of a sentence; empty where all
/// fits.
MOTEFILTERSHEXAHEDRA_EXPORT std::string mismatchOf(vtkDataObject* object);

} // namespace mote

#endif
