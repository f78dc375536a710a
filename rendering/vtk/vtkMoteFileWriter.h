/**
 * @class   vtkMoteFileWriter
 * @brief   what the writers of .mote files have in common
 *
 * The file is written without a name, or under a temporary one in the same folder, and then
 * renamed: under its own name it is complete or is not there. docs/mote-file.md describes the
 * files.
 */

#ifndef vtkMoteFileWriter_h
#define vtkMoteFileWriter_h

#include "MoteRenderingVTKModule.h" // for export macro
#include "vtkWriter.h"

#include <functional> // for the progress
#include <string>     // for messages
#include <vector>     // for names

namespace mote
{
struct FieldArrays;
} // namespace mote

class MOTERENDERINGVTK_EXPORT vtkMoteFileWriter : public vtkWriter
{
public:
  vtkAbstractTypeMacro(vtkMoteFileWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to write.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Whether the input's order is kept, as arrays "vtkOriginalPointIds" and, of triangles,
   * "vtkOriginalCellIds" (4 bytes each; 8 for points above 2^32). On by default; without effect
   * where the input has an array of that name, which is then written as any.
   */
  vtkSetMacro(WriteOriginalIds, vtkTypeBool);
  vtkGetMacro(WriteOriginalIds, vtkTypeBool);
  vtkBooleanMacro(WriteOriginalIds, vtkTypeBool);
  ///@}

  /**
   * Writes the file: 1 where that was done, else 0 after an error, or where AbortExecute stopped
   * it.
   */
  int Write() override;

  /**
   * What went wrong in the last Write(), as one sentence; empty where nothing did.
   */
  std::string GetErrorMessage() { return this->ErrorMessage; }

protected:
  vtkMoteFileWriter();
  ~vtkMoteFileWriter() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override {}

  /**
   * Writes the file. False where AbortExecute stopped it; throws std::exception.
   */
  virtual bool WriteFile() = 0;

  /**
   * Tells the progress, and whether to go on.
   */
  std::function<bool(double)> ProgressOfWrite();

  /**
   * Warns of arrays that are not written.
   */
  void WarnOfLeftOut(const mote::FieldArrays& arrays);

  char* FileName = nullptr;
  vtkTypeBool WriteOriginalIds = 1;

private:
  vtkMoteFileWriter(const vtkMoteFileWriter&) = delete;
  void operator=(const vtkMoteFileWriter&) = delete;

  std::string ErrorMessage;
};

#endif
