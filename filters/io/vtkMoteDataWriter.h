/**
 * @class   vtkMoteDataWriter
 * @brief   writes points or cells as a file that other programs read
 *
 * The ending of FileName says as what: .vtp, VTK's XML file of points, lines and polygons; .vtu,
 * VTK's XML file of any cells; .xyz or .xyz.gz, extended XYZ, of points alone. Numbers keep their
 * types in VTK's files, which are binary and not compressed; in XYZ they have as many digits as
 * tell them from all others.
 *
 * Input is a vtkDataSet; of an XYZ file a vtkPointSet, of a .vtp file a vtkPolyData. An XYZ file
 * has the columns species (an array of words named element, species or typelabel, or names of
 * types), pos, and all point arrays; box, periods and time are in its comment. Its blanks in words
 * become underscores.
 *
 * The file is complete or not there, as with every vtkMoteFileWriter.
 */

#ifndef vtkMoteDataWriter_h
#define vtkMoteDataWriter_h

#include "MoteFiltersIOModule.h" // for export macro
#include "vtkMoteFileWriter.h"

#include <string> // for endings

class vtkDataSet;
class vtkPointSet;

namespace mote
{
class AtomicFile;
} // namespace mote

class MOTEFILTERSIO_EXPORT vtkMoteDataWriter : public vtkMoteFileWriter
{
public:
  static vtkMoteDataWriter* New();
  vtkTypeMacro(vtkMoteDataWriter, vtkMoteFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * ".vtp", ".vtu", ".xyz" or ".xyz.gz" where the name ends so, in letters of any case; else empty.
   */
  static std::string EndingOf(const std::string& fileName);

protected:
  vtkMoteDataWriter();
  ~vtkMoteDataWriter() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  bool WriteFile() override;

private:
  vtkMoteDataWriter(const vtkMoteDataWriter&) = delete;
  void operator=(const vtkMoteDataWriter&) = delete;

  bool WriteXML(vtkDataSet* data, const std::string& ending, mote::AtomicFile& file);
  bool WriteXYZ(vtkPointSet* points, bool isCompressed, mote::AtomicFile& file);
};

#endif
