/**
 * @class   vtkMoteReaderTable
 * @brief   the table from file name to reader
 *
 * One table says which reader reads which file; a new format is one entry of it (in
 * vtkMoteReaderTable.cxx). A file is recognised by its extension and, where that says nothing, by
 * its first bytes; `pump:SCALE[:PART]` names a vtkMotePumpSource instead. Every function is static;
 * the class is a vtkObject so that Python sees it.
 *
 * Errors are sentences that a user can act on. The C++ functions hand them back through `error`
 * and print nothing; the ones for Python (NewReader, ReadFile) report them as VTK errors and
 * return null. CheckFile gives the sentence itself.
 */

#ifndef vtkMoteReaderTable_h
#define vtkMoteReaderTable_h

#include "MoteFiltersIOModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For returned readers

#include <string> // For names
#include <vector> // For lists of names

class vtkAlgorithm;
class vtkDataObject;
class vtkInformationStringKey;

class MOTEFILTERSIO_EXPORT vtkMoteReaderTable : public vtkObject
{
public:
  static vtkMoteReaderTable* New();
  vtkTypeMacro(vtkMoteReaderTable, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * A reader that is ready to update, for one file or for several files that are the steps of one
   * series (only formats that know series: LAMMPS dumps, and by a vtkMoteFileSeriesReader .mote
   * files, those of VTK, points, XYZ and PLY). The file names must name readable files. Null, with
   * the reason in `error`, when a file is missing, is a directory, may not be read, or has a format
   * that is not in the table.
   */
  static vtkSmartPointer<vtkAlgorithm> MakeReader(
    const std::vector<std::string>& fileNames, std::string& error);
  static vtkSmartPointer<vtkAlgorithm> MakeReader(const std::string& fileName, std::string& error);

  /**
   * The same for Python: a new reader, or null after a VTK error with the reason.
   */
  VTK_NEWINSTANCE static vtkAlgorithm* NewReader(const std::string& fileName);

  /**
   * Why a file cannot be given to a reader, as one sentence; empty when it can. This looks at the
   * name, the permissions and the first bytes, and does not read the file through.
   */
  static std::string CheckFile(const std::string& fileName);

  /**
   * Whether the name of a file alone tells its format. Those that end in .txt or .dat may be tables
   * of points, or anything.
   */
  static bool NameTells(const std::string& fileName);

  /**
   * Updates a reader and returns its first output, or null with one sentence in `error` when the
   * reader (or something inside it) reported an error or produced nothing. What VTK would print
   * meanwhile is caught. A data set without any point counts as nothing, save from Mote's own
   * readers: they tell damage from an empty time step, which is a valid result. The second form
   * asks for a time, which becomes the nearest step at or before it. Warnings are dropped unless
   * `warnings` is given. The data are the reader's own output, which a later update changes.
   *
   * Several threads may read at a time, with readers of their own.
   */
  static vtkSmartPointer<vtkDataObject> Read(
    vtkAlgorithm* reader, std::string& error, std::string* warnings = nullptr);
  static vtkSmartPointer<vtkDataObject> Read(
    vtkAlgorithm* reader, double time, std::string& error, std::string* warnings = nullptr);

  /**
   * MakeReader and Read in one call, for Python: the data, or null after a VTK error with the
   * reason. The data are the first output at its first time step.
   */
  VTK_NEWINSTANCE static vtkDataObject* ReadFile(const std::string& fileName);

  /**
   * The time steps that a reader offers, ascending; empty when its data have no time. Updates the
   * reader's information. `error` works as in Read.
   */
  static std::vector<double> GetTimeSteps(vtkAlgorithm* reader, std::string& error);

  /**
   * Puts the files of one series together: names in one folder that differ only in the digits of
   * their last number (peri.00300.dump and peri.01500.dump) and whose format knows series form one
   * group, ordered by that number; every other name is a group of its own. Groups come in the order
   * of their first members. Files whose extension says nothing are opened for their first bytes.
   */
  static std::vector<std::vector<std::string>> GroupSeries(
    const std::vector<std::string>& fileNames);

  /**
   * The extensions that the table knows, with their dots, separated by blanks (".dump .vtp ...").
   */
  static std::string GetExtensions();

  /**
   * A text of a line or two a format, "  .vtp     VTK XML polygonal data", for help pages.
   */
  static std::string GetFormatsHelp();

  /**
   * The name of the (first) file, in the information of every reader that this table made.
   */
  static vtkInformationStringKey* FILE_NAME();

protected:
  vtkMoteReaderTable() = default;
  ~vtkMoteReaderTable() override = default;

private:
  vtkMoteReaderTable(const vtkMoteReaderTable&) = delete;
  void operator=(const vtkMoteReaderTable&) = delete;
};

#endif
