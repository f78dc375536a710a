/**
 * @class   vtkMoteCollectionReader
 * @brief   reads collections of files: .pvd and .series
 *
 * A .pvd file names other files with their times and parts, as ParaView and many simulations write
 * them; a .series file (JSON) names one file for each time, as OpenFOAM's foamToVTK does. The
 * output has a block for each file of the time that is asked for, or of the latest before it, with
 * the name that the collection gives it; blocks are whatever vtkMoteReaderTable reads. Times are
 * those of the collection.
 *
 * A file is opened when its step is asked for. Errors are reported through vtkErrorMacro as one
 * sentence with the file that is to blame, and the output is empty then.
 */

#ifndef vtkMoteCollectionReader_h
#define vtkMoteCollectionReader_h

#include "MoteFiltersIOModule.h" // For export macro
#include "vtkMultiBlockDataSetAlgorithm.h"

#include <memory> // For the implementation

class MOTEFILTERSIO_EXPORT vtkMoteCollectionReader : public vtkMultiBlockDataSetAlgorithm
{
public:
  static vtkMoteCollectionReader* New();
  vtkTypeMacro(vtkMoteCollectionReader, vtkMultiBlockDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The collection.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  //@}

protected:
  vtkMoteCollectionReader();
  ~vtkMoteCollectionReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMoteCollectionReader(const vtkMoteCollectionReader&) = delete;
  void operator=(const vtkMoteCollectionReader&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;
  char* FileName = nullptr;
};

#endif
