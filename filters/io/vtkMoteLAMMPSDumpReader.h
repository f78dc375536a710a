/**
 * @class   vtkMoteLAMMPSDumpReader
 * @brief   reads atoms from LAMMPS dumps and data files
 *
 * Reads the text files that the LAMMPS commands `dump atom` and `dump custom` write: one or many
 * time steps a file, one file or a series, plain or gzip (told by the content, not by the name).
 *
 * Data files, which `write_data` writes and `read_data` reads, are one time step each: that of
 * their title, else 0. Columns are those of the atom style behind "Atoms", else of the only style
 * that fits; "v" comes from the section of velocities, by ids. Bonds, and what else there is, are
 * passed over.
 *
 * Output: vtkPolyData with
 * - points, double, in file order: Cartesian positions in the dump's units of length. Coordinates
 *   come from x, xu, xs or xsu (the first there is, for each axis); scaled ones are multiplied with
 *   the cell, triclinic or not.
 * - one vertex cell a point, so that filters on cells see atoms (8 bytes an atom).
 * - point data: an array for every other column that is enabled, under its own name. id and mol are
 *   vtkIdType, type, proc, ix, iy, iz int (wider where a value needs it), element and other
 *   columns of words strings, the rest double. Columns that make a vector become one array whose
 *   components carry the columns' names: vx vy vz are "v", c_s[1] c_s[2] c_s[3] "c_s".
 * - point data "type" (int) also where no column has that name but one of words does (element, else
 *   typelabel, else the first): the distinct words of the time step numbered from 1 in alphabetical
 *   order. It comes and goes with the array of words, and is not in the array selection. A step
 *   that lacks some of the words numbers the others differently.
 * - field data: "TimeValue" (as other readers name it), "timestep", "box" (nine values: the cell
 *   vectors a, b, c), "box_origin", "boundary" ("pp pp fm") and "units", the last two where given.
 *
 * Time steps are those of all files together, ascending; a step's time is its `ITEM: TIME` if every
 * step has one, else the number of the step. Of two steps at one time the later one in the files
 * counts, as after a restart. A requested time becomes the nearest step at or before it.
 *
 * Every file is passed over once to find its steps. Where it has grown since, what was added is
 * passed over; where it has changed otherwise (size or time of change), or is gzip, all of it. Gzip
 * is inflated for that; a step then inflates little more than its own text.
 *
 * Pieces: of several processes each reads its share of the atoms alone, in file order, with the
 * numbers that words have in the whole step. Each passes over the file once to find its steps, and
 * over the atoms before its own. A column may become wider in one piece than in another.
 *
 * Errors are reported through vtkErrorMacro as one sentence with the file, and line and column
 * where there are such, which GetLastErrorMessage repeats; GetErrorCode tells its kind. After an
 * error, as after an abort, the output is empty. A damaged step in a file is an error only when it
 * is asked for.
 */

#ifndef vtkMoteLAMMPSDumpReader_h
#define vtkMoteLAMMPSDumpReader_h

#include "MoteFiltersIOModule.h" // For export macro
#include "vtkMotePolyDataReader.h"

#include <memory> // For the implementation

class vtkDataArraySelection;

class MOTEFILTERSIO_EXPORT vtkMoteLAMMPSDumpReader : public vtkMotePolyDataReader
{
public:
  static vtkMoteLAMMPSDumpReader* New();
  vtkTypeMacro(vtkMoteLAMMPSDumpReader, vtkMotePolyDataReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The one file to read; replaces a series. Null and "" mean none. GetFileName gives the first
   * file, or null.
   */
  void SetFileName(const char* fileName) override;
  const char* GetFileName() override;
  //@}

  //@{
  /**
   * The files of a series, in any order: each has one or more time steps. GetFileName takes an
   * index from 0 to GetNumberOfFileNames() - 1, and gives null for others.
   */
  void AddFileName(const char* fileName);
  void RemoveAllFileNames();
  int GetNumberOfFileNames();
  const char* GetFileName(int index);
  //@}

  /**
   * 1 if the file can be opened and begins like a LAMMPS text dump (possibly gzip), else 0.
   */
  static int CanReadFile(const char* fileName);

  /**
   * Which arrays to read, known after UpdateInformation; all are enabled at first. Columns of
   * arrays that are disabled are passed over and not parsed. To enable an array that the files do
   * not have is an error.
   */
  vtkDataArraySelection* GetPointDataArraySelection();

  //@{
  /**
   * Whether columns that make a vector become one array (default on). When off every column is an
   * array of its own.
   */
  vtkSetMacro(CombineVectors, bool);
  vtkGetMacro(CombineVectors, bool);
  vtkBooleanMacro(CombineVectors, bool);
  //@}

  //@{
  /**
   * Whether to store float columns in single precision, half the memory (default off). Dumps
   * usually have six digits, which a float holds, but not those written with a longer format.
   * Positions are double in any case: boxes may lie far from the origin.
   */
  vtkSetMacro(SinglePrecision, bool);
  vtkGetMacro(SinglePrecision, bool);
  vtkBooleanMacro(SinglePrecision, bool);
  //@}

  //@{
  /**
   * Whether a damaged last step of a file is left out of the time steps (default off): of a file
   * that is being written it is half there.
   */
  vtkSetMacro(LeaveOutDamagedEnd, bool);
  vtkGetMacro(LeaveOutDamagedEnd, bool);
  vtkBooleanMacro(LeaveOutDamagedEnd, bool);
  //@}

  /**
   * Takes over what another reader has found when it passed over the same files, so that this one
   * need not; and LeaveOutDamagedEnd. Neither reader may be at work. What has changed since is
   * looked at anew.
   */
  void TakeIndexOf(vtkMoteLAMMPSDumpReader* other);

  /**
   * The later of the reader's own and its array selection's time of change.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkMoteLAMMPSDumpReader();
  ~vtkMoteLAMMPSDumpReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMoteLAMMPSDumpReader(const vtkMoteLAMMPSDumpReader&) = delete;
  void operator=(const vtkMoteLAMMPSDumpReader&) = delete;

  void OfferArrays();

  class Internals;
  std::unique_ptr<Internals> Internal;
  bool CombineVectors = true;
  bool SinglePrecision = false;
  bool LeaveOutDamagedEnd = false;
  bool Ready = false; // the last RequestInformation succeeded
};

#endif
