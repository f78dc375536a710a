/**
 * @class   vtkMoteDelimitedPointsReader
 * @brief   reads points from a table of comma-separated values
 *
 * The first line names the columns; those named x, y and z (in either case) hold the coordinates
 * and every other one becomes a point array under its own name, numbers as numbers (see
 * vtkDelimitedTextReader's DetectNumericColumns) and all else as strings. Output: vtkPolyData with
 * the points in double and file order, and one vertex cell a point. A file without such columns,
 * with a coordinate that is no number, or without any row is an error.
 */

#ifndef vtkMoteDelimitedPointsReader_h
#define vtkMoteDelimitedPointsReader_h

#include "MoteFiltersIOModule.h" // For export macro
#include "vtkMotePolyDataReader.h"

class MOTEFILTERSIO_EXPORT vtkMoteDelimitedPointsReader : public vtkMotePolyDataReader
{
public:
  static vtkMoteDelimitedPointsReader* New();
  vtkTypeMacro(vtkMoteDelimitedPointsReader, vtkMotePolyDataReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkMoteDelimitedPointsReader();
  ~vtkMoteDelimitedPointsReader() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMoteDelimitedPointsReader(const vtkMoteDelimitedPointsReader&) = delete;
  void operator=(const vtkMoteDelimitedPointsReader&) = delete;
};

#endif
