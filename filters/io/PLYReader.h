#ifndef MotePLYReader_h
#define MotePLYReader_h

#include "vtkPLYReader.h"

namespace mote
{

/// A vtkPLYReader that reads what VTK 9.1's leaves out or answers with a crash: values of vertices
/// and faces other than places, normals and colours, such as "quality" or "scalar_Intensity";
/// coordinates of type double; texts whose last line has no end; damaged files (see readPLY()).
///
/// Output: vtkPolyData with the vertices in their order, in double where the file has double and
/// float would move them by more than a millionth of the mesh's size, and polygons. "Normals" and
/// texture coordinates ("TCoords") of points; "RGB" or "RGBA" of points and cells, from 0 to 255;
/// every other value under its own name, in its type. Texture coordinates of faces are not read.
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
