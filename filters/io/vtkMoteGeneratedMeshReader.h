/**
 * @class   vtkMoteGeneratedMeshReader
 * @brief   triangles that are made instead of read
 *
 * In the place of a file's name stands which: sphere:N, a displaced sphere of about N triangles, or
 * subdivide:FILE:N, the polygons of a file cut finer to about N triangles and displaced (see
 * mote::displacedSphere and mote::subdivided); N from 100 to 2^29. Output: vtkPolyData of points in
 * float and triangles, without arrays.
 */

#ifndef vtkMoteGeneratedMeshReader_h
#define vtkMoteGeneratedMeshReader_h

#include "MoteFiltersIOModule.h" // For export macro
#include "vtkMotePolyDataReader.h"

class MOTEFILTERSIO_EXPORT vtkMoteGeneratedMeshReader : public vtkMotePolyDataReader
{
public:
  static vtkMoteGeneratedMeshReader* New();
  vtkTypeMacro(vtkMoteGeneratedMeshReader, vtkMotePolyDataReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkMoteGeneratedMeshReader();
  ~vtkMoteGeneratedMeshReader() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMoteGeneratedMeshReader(const vtkMoteGeneratedMeshReader&) = delete;
  void operator=(const vtkMoteGeneratedMeshReader&) = delete;
};

#endif
