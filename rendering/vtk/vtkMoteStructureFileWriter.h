/**
 * @class   vtkMoteStructureFileWriter
 * @brief   what the writers of .mote files have in common
 *
 * docs/mote-file.md describes the files.
 */

#ifndef vtkMoteStructureFileWriter_h
#define vtkMoteStructureFileWriter_h

#include "MoteRenderingVTKModule.h" // for export macro
#include "vtkMoteFileWriter.h"

namespace mote
{
struct FieldArrays;
} // namespace mote

class MOTERENDERINGVTK_EXPORT vtkMoteStructureFileWriter : public vtkMoteFileWriter
{
public:
  vtkAbstractTypeMacro(vtkMoteStructureFileWriter, vtkMoteFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Whether the input's order is kept, as arrays "vtkOriginalPointIds" and, of triangles,
   * "vtkOriginalCellIds" (4 bytes each; 8 for points above 2^32). On by default; without effect
   * where the input has an array of that name, which is then written as any.
   */
  vtkSetMacro(WriteOriginalIds, vtkTypeBool);
  vtkGetMacro(WriteOriginalIds, vtkTypeBool);
  vtkBooleanMacro(WriteOriginalIds, vtkTypeBool);
  //@}

protected:
  vtkMoteStructureFileWriter();
  ~vtkMoteStructureFileWriter() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  /**
   * Warns of arrays that are not written.
   */
  void WarnOfLeftOut(const mote::FieldArrays& arrays);

  vtkTypeBool WriteOriginalIds = 1;

private:
  vtkMoteStructureFileWriter(const vtkMoteStructureFileWriter&) = delete;
  void operator=(const vtkMoteStructureFileWriter&) = delete;
};

#endif
