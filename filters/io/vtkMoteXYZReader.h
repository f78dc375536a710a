/**
 * @class   vtkMoteXYZReader
 * @brief   reads atoms from XYZ and extended XYZ files
 *
 * An XYZ file has, for every frame, a line with the number of atoms, a comment line, and a line
 * `name x y z` an atom; plain or gzip (told by the content). The extended form describes other
 * columns in the comment, `Properties=species:S:1:pos:R:3:force:R:3`, and is recognised by that.
 *
 * Output: vtkPolyData with the points in double and file order, one vertex cell a point, and point
 * data: for plain XYZ "type" (int) where the names are numbers, else "element" (strings) and
 * "type": where all names of the frame are elements their numbers in the periodic table, 0 for "X"
 * and "Xx", else the names' places in alphabetical order, from 1; further columns as "column5",
 * "column6", and so on. For extended XYZ the properties under their own names (R double, I int, S
 * and L strings), and "type" from the first S property in the same way.
 *
 * Lattice="..." of a comment becomes the field data "box" (9 numbers, one vector after the other),
 * Origin="..." "box_origin", and pbc="T T F" "boundary", as vtkMoteLAMMPSDumpReader has them.
 *
 * Time steps are the frames; their times are what the comments call "Timestep: N" (as LAMMPS
 * writes), or Time=N, if all frames have it in ascending order, else 0, 1, 2 and so on. A requested
 * time becomes the nearest step at or before it. vtkXYZMolReader2 makes a vtkMolecule instead, of
 * elements only.
 */

#ifndef vtkMoteXYZReader_h
#define vtkMoteXYZReader_h

#include "MoteFiltersIOModule.h" // For export macro
#include "vtkMotePolyDataReader.h"

#include <memory> // For the implementation

class MOTEFILTERSIO_EXPORT vtkMoteXYZReader : public vtkMotePolyDataReader
{
public:
  static vtkMoteXYZReader* New();
  vtkTypeMacro(vtkMoteXYZReader, vtkMotePolyDataReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkMoteXYZReader();
  ~vtkMoteXYZReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMoteXYZReader(const vtkMoteXYZReader&) = delete;
  void operator=(const vtkMoteXYZReader&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
