/**
 * @class   vtkMotePiecesWriter
 * @brief   writes data in pieces that are compact in space
 *
 * FileName is the index, NAME.pvtp of points, lines and polygons or NAME.pvtu of any cells, in
 * VTK's XML format; the pieces are NAME/NAME_0.vtp, NAME/NAME_1.vtp ... ParaView reads some on each
 * rank, and orders ranks by their boxes, which is what clouds and several rays a pixel need. Each
 * piece has about as many cells, by the mean of their points; data without cells have points in
 * their place.
 *
 * Input is a vtkDataSet, of a .pvtp file a vtkPolyData. Each piece is written as by
 * vtkMoteDataWriter, and the index last: it is complete or not there.
 */

#ifndef vtkMotePiecesWriter_h
#define vtkMotePiecesWriter_h

#include "MoteFiltersIOModule.h" // for export macro
#include "vtkMoteFileWriter.h"

#include <string> // for endings

class MOTEFILTERSIO_EXPORT vtkMotePiecesWriter : public vtkMoteFileWriter
{
public:
  static vtkMotePiecesWriter* New();
  vtkTypeMacro(vtkMotePiecesWriter, vtkMoteFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * ".pvtp" or ".pvtu" where the name ends so, in letters of any case; else empty.
   */
  static std::string EndingOf(const std::string& fileName);

  //@{
  /**
   * How many pieces, 1 to 65536; fewer are written where there are fewer cells. Default 8.
   */
  vtkSetClampMacro(NumberOfPieces, int, 1, 65536);
  vtkGetMacro(NumberOfPieces, int);
  //@}

  /**
   * How many the last Write() made.
   */
  vtkGetMacro(NumberOfWrittenPieces, int);

protected:
  vtkMotePiecesWriter();
  ~vtkMotePiecesWriter() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  bool WriteFile() override;

private:
  vtkMotePiecesWriter(const vtkMotePiecesWriter&) = delete;
  void operator=(const vtkMotePiecesWriter&) = delete;

  int NumberOfPieces = 8;
  int NumberOfWrittenPieces = 0;
};

#endif
