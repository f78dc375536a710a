/**
 * @class   vtkMoteDelimitedPointsReader
 * @brief   reads points from a table of values between commas, semicolons or tabs
 *
 * The first line names the columns, and tells by its most frequent one of comma, semicolon and tab
 * what separates the values; blanks around names and numbers do not matter. The columns x, y and z
 * (in either case) hold the coordinates, z = 0 where there is no column z,
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
