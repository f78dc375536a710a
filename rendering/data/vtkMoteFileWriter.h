/**
 * @class   vtkMoteFileWriter
 * @brief   what writers of one file have in common
 *
 * The file is written without a name, or under a temporary one in the same folder, and then
 * renamed: under its own name it is complete or is not there.
 */

#ifndef vtkMoteFileWriter_h
#define vtkMoteFileWriter_h

#include "MoteRenderingDataModule.h" // for export macro
#include "vtkWriter.h"

#include <functional> // for the progress
#include <string>     // for messages

class MOTERENDERINGDATA_EXPORT vtkMoteFileWriter : public vtkWriter
{
public:
  vtkAbstractTypeMacro(vtkMoteFileWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The file to write.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  //@}

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
  void WriteData() override {}

  /**
   * Writes the file. False where AbortExecute stopped it; throws std::exception.
   */
  virtual bool WriteFile() = 0;

  /**
   * Tells the progress, and whether to go on.
   */
  std::function<bool(double)> ProgressOfWrite();

  char* FileName = nullptr;

private:
  vtkMoteFileWriter(const vtkMoteFileWriter&) = delete;
  void operator=(const vtkMoteFileWriter&) = delete;

  std::string ErrorMessage;
};

#endif
