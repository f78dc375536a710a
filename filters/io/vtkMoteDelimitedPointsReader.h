/**
 * @class   vtkMoteDelimitedPointsReader
 * @brief   reads points from a table of values between commas, semicolons, tabs or blanks
 *
 * Plain or gzip (told by the content). A line names the columns: the first one with names of x and
 * y, which may be x, X, "X [m]", x-coordinate, Position_X, or Points:0 as ParaView writes it; lines
 * above it are passed over, and it may begin with the mark of a comment (#, % or //). What
 * separates its names is what is most frequent of comma, semicolon and tab, or blanks. Where the
 * first line has three numbers or more, columns have no names: they are x, y, z, column4 and so on.
 * z = 0 where there is no column z. Where the coordinates of the first row have decimal commas, all
 * numbers may.
 *
 * Every other column becomes a point array: int, 64-bit integer or double by its values, and
 * strings where one is no number. Columns U:0, U:1 ... become one array U. What is empty is NaN.
 * Values may stand in quotes, but no quotes go over line ends. Blank lines are passed over.
 *
 * Output: vtkPolyData with the points in double and file order, and one vertex cell a point. A file
 * without such columns, with a coordinate that is no number, with lines of other numbers of values,
 * or without any row is an error.
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

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMoteDelimitedPointsReader(const vtkMoteDelimitedPointsReader&) = delete;
  void operator=(const vtkMoteDelimitedPointsReader&) = delete;
};

#endif
