#ifndef MoteEnSightReader_h
#define MoteEnSightReader_h

#include "vtkSmartPointer.h"

#include <string>

class vtkAlgorithm;

namespace mote
{

/// A reader of an EnSight Gold case, ASCII or binary, that goes through the files of a step before
/// VTK's reads them (see EnSightCase): what is damaged in them is an error. Throws FileError for a
/// case file that is damaged.
vtkSmartPointer<vtkAlgorithm> makeEnSightReader(const std::string& fileName);

} // namespace mote

#endif
