/**
 * @class   vtkMotePointsReader
 * @brief   reads points from a text file of `x y z` a line
 *
 * Plain or gzip (told by the content). Every line holds three numbers separated by blanks, in any
 * unit, and nothing else. Output: vtkPolyData with the points in double and file order, and one
 * vertex cell a point. An empty file is an error.
 */

#ifndef vtkMotePointsReader_h
#define vtkMotePointsReader_h

#include "MoteFiltersIOModule.h" // For export macro
#include "vtkMotePolyDataReader.h"

class MOTEFILTERSIO_EXPORT vtkMotePointsReader : public vtkMotePolyDataReader
{
public:
  static vtkMotePointsReader* New();
  vtkTypeMacro(vtkMotePointsReader, vtkMotePolyDataReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkMotePointsReader();
  ~vtkMotePointsReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMotePointsReader(const vtkMotePointsReader&) = delete;
  void operator=(const vtkMotePointsReader&) = delete;
};

#endif
