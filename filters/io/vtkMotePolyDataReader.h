/**
 * @class   vtkMotePolyDataReader
 * @brief   what the readers of this module have in common: a file name and honest errors
 *
 * A subclass does its reading inside Attempt, which turns what the parsers throw into the reader's
 * last error. Requests succeed in the pipeline's eyes even then, with empty output: a request that
 * fails would leave the data of an earlier run downstream.
 */

#ifndef vtkMotePolyDataReader_h
#define vtkMotePolyDataReader_h

#include "MoteFiltersIOModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <functional> // For Attempt
#include <memory>     // For the scratch space
#include <string>
#include <utility> // For names and messages

namespace mote
{
class ScratchSpace;
} // namespace mote

class MOTEFILTERSIO_EXPORT vtkMotePolyDataReader : public vtkPolyDataAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkMotePolyDataReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The file to read; null and "" mean none, which GetFileName gives as null.
   */
  virtual void SetFileName(const char* fileName);
  virtual const char* GetFileName();
  //@}

  /**
   * What was wrong when the reader last ran, as one sentence with the file and, where there are
   * such, line and column; empty when all was well. GetErrorCode tells the kind of error, as one of
   * vtkErrorCode's. An abort is no error: it has a message and a code, but is not reported.
   */
  std::string GetLastErrorMessage();

#ifndef __VTK_WRAP__
  //@{
  /**
   * Where readers of text put what they read, in place of the heap; null, the default, for the
   * heap. With a space points have no cells, and arrays of text no values: what is meant to be
   * written as numbers, and may be larger than memory.
   */
  void SetScratchSpace(std::shared_ptr<mote::ScratchSpace> space);
  std::shared_ptr<mote::ScratchSpace> GetScratchSpace() const;
  //@}
#endif

protected:
  vtkMotePolyDataReader();
  ~vtkMotePolyDataReader() override;

  /**
   * Called by the work with the share that is done, 0 to 1; false means that it should stop.
   */
  using ProgressFunction = std::function<bool(double)>;

  /**
   * Runs `work`. True if it threw nothing; otherwise the error has been reported.
   */
  bool Attempt(const std::function<void(const ProgressFunction&)>& work);

  /**
   * Throws, inside Attempt, when there is no file name.
   */
  void RequireFileName();

  /**
   * RequestData of what is made instead of read: `make` gets the name, as a file's, and the output.
   */
  int RequestMade(vtkInformationVector* outputVector,
    const std::function<void(const std::string&, vtkPolyData*)>& make);

  /**
   * How readers of time steps hand on the step that they have read, with its time.
   */
  static void DeliverStep(vtkPolyData* result, double time, vtkPolyData* output);

private:
  vtkMotePolyDataReader(const vtkMotePolyDataReader&) = delete;
  void operator=(const vtkMotePolyDataReader&) = delete;

  void Fail(const std::string& message);

  std::string FileName;
  std::string LastErrorMessage;
  std::shared_ptr<mote::ScratchSpace> Space;
};

#endif
