/**
 * @class   vtkMoteFileSeriesReader
 * @brief   reads files that hold one time step each, or frames of XYZ
 *
 * The steps come in the order in which the files were added. Their times are those that the files
 * tell themselves (field data "TimeValue") if every file tells one and they ascend, else 0, 1, 2
 * and so on. A requested time becomes the nearest step at or before it. RequestInformation opens
 * the files, up to the first one without a time; how much of a file that means to read is up to its
 * format's reader. Where the first XYZ files have several frames, all files are opened, and their
 * frames are the steps.
 *
 * Every file is read by the reader that vtkMoteReaderTable has for it, with its settings as they
 * are, and its data are passed on, composite ones as well, with the time as DATA_TIME_STEP. All
 * files must hold the same type of data, images and structured grids of the same extent. The last
 * step is kept and not read again while its file has the same size and time of change.
 *
 * Errors are reported through vtkErrorMacro as one sentence with the file that is to blame, which
 * GetLastErrorMessage repeats. After an error, as after an abort, the output is empty. A file whose
 * data are damaged is an error only when its step is asked for.
 *
 * Messages of the files' readers are caught as vtkMoteReaderTable::Read does it.
 */

#ifndef vtkMoteFileSeriesReader_h
#define vtkMoteFileSeriesReader_h

#include "MoteFiltersIOModule.h" // For export macro
#include "vtkDataObjectAlgorithm.h"

#include <memory> // For the implementation
#include <string> // For messages

class MOTEFILTERSIO_EXPORT vtkMoteFileSeriesReader : public vtkDataObjectAlgorithm
{
public:
  static vtkMoteFileSeriesReader* New();
  vtkTypeMacro(vtkMoteFileSeriesReader, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The files, a time step each, in the order of time. GetFileName takes an index from 0 to
   * GetNumberOfFileNames() - 1, and gives null for others.
   */
  void AddFileName(const char* fileName);
  void RemoveAllFileNames();
  int GetNumberOfFileNames();
  const char* GetFileName(int index);
  //@}

  /**
   * What was wrong when the reader last ran, as one sentence; empty when all was well. An abort is
   * no error: it has a message, but is not reported.
   */
  std::string GetLastErrorMessage();

protected:
  vtkMoteFileSeriesReader();
  ~vtkMoteFileSeriesReader() override;

  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMoteFileSeriesReader(const vtkMoteFileSeriesReader&) = delete;
  void operator=(const vtkMoteFileSeriesReader&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;
  std::string LastErrorMessage;
  bool Ready = false; // the last RequestInformation succeeded
};

#endif
