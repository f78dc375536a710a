/**
 * @class   vtkMoteMeshFileReader
 * @brief   opens .mote files of triangles
 *
 * Output: vtkPolyData whose points (vtkMoteMeshFilePoints), triangles and arrays stay in the file,
 * mapped into memory: opening reads the nodes of the tree, about 1.2 bytes a triangle, and other
 * pages come in as they are used. Triangles stand in the order of the file; where the file was told
 * to keep it, the arrays "vtkOriginalPointIds" and "vtkOriginalCellIds" have the order before that.
 * Ranges of arrays and bounds are known without a look at the values. Nothing can be written to.
 *
 * A vtkMoteMeshMapper draws such data without a copy and without building anything, at any pixels
 * of error. vtkMoteMeshFileWriter writes the files; docs/mote-file.md describes them.
 *
 * The file must not be made shorter while its data are in use; to replace it by another of the same
 * name is safe.
 */

#ifndef vtkMoteMeshFileReader_h
#define vtkMoteMeshFileReader_h

#include "MoteFiltersIOModule.h" // For export macro
#include "vtkMotePolyDataReader.h"

#include <memory> // For the file

namespace mote
{
class RlodTreeFile;
} // namespace mote

class MOTEFILTERSIO_EXPORT vtkMoteMeshFileReader : public vtkMotePolyDataReader
{
public:
  static vtkMoteMeshFileReader* New();
  vtkTypeMacro(vtkMoteMeshFileReader, vtkMotePolyDataReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkMoteMeshFileReader();
  ~vtkMoteMeshFileReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMoteMeshFileReader(const vtkMoteMeshFileReader&) = delete;
  void operator=(const vtkMoteMeshFileReader&) = delete;

  std::shared_ptr<const mote::RlodTreeFile> File; // as of the last request for information
};

#endif
