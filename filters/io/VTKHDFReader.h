#ifndef MoteVTKHDFReader_h
#define MoteVTKHDFReader_h

#include "vtkSmartPointer.h"

#include <string>

class vtkAlgorithm;

namespace mote
{

/// A reader of a VTKHDF file. Throws FileError for what cannot be read at all.
vtkSmartPointer<vtkAlgorithm> makeVTKHDFReader(const std::string& fileName);

} // namespace mote

#endif
