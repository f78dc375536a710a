/**
 * @class   vtkMoteBlocksWriter
 * @brief   writes several data sets as one file of blocks
 *
 * FileName is the index, NAME.vtm, in VTK's XML format; the blocks are NAME/NAME_0.vtu,
 * NAME/NAME_1.vtp ..., each as vtkMoteDataWriter writes it: .vtp for a vtkPolyData, .vtu for all
 * else. The index names them as the input's metadata do.
 *
 * Input is a vtkMultiBlockDataSet; blocks within blocks become blocks of the file, and those
 * without points are left out. The index is written last: it is complete or not there.
 */

#ifndef vtkMoteBlocksWriter_h
#define vtkMoteBlocksWriter_h

#include "MoteFiltersIOModule.h" // for export macro
#include "vtkMoteFileWriter.h"

#include <string> // for endings

class MOTEFILTERSIO_EXPORT vtkMoteBlocksWriter : public vtkMoteFileWriter
{
public:
  static vtkMoteBlocksWriter* New();
  vtkTypeMacro(vtkMoteBlocksWriter, vtkMoteFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * ".vtm" where the name ends so, in letters of any case; else empty.
   */
  static std::string EndingOf(const std::string& fileName);

protected:
  vtkMoteBlocksWriter();
  ~vtkMoteBlocksWriter() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  bool WriteFile() override;

private:
  vtkMoteBlocksWriter(const vtkMoteBlocksWriter&) = delete;
  void operator=(const vtkMoteBlocksWriter&) = delete;
};

#endif
