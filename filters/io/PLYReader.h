#ifndef MotePLYReader_h
#define MotePLYReader_h

#include "vtkPLYReader.h"

namespace mote
{

/// VTK's reader of PLY files, with what it leaves out: values of vertices and faces that it has no
/// use for, such as "quality" or "scalar_Intensity", as arrays of points and cells, and coordinates
/// of type double, where float would move them by more than a millionth of the mesh's size. What
/// would crash it is an error; see readPLYColumns().
class PLYReader : public vtkPLYReader
{
public:
  static PLYReader* New();

protected:
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
};

} // namespace mote

#endif
