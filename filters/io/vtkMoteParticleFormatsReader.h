/**
 * @class   vtkMoteParticleFormatsReader
 * @brief   reads particles from GROMACS, AtomEye, Gadget, H5Part, openPMD, .bgeo and Uintah files
 *
 * The format is told by the content:
 * - GROMACS .gro: "id", "residue", "residue_name", "type" by the names of the atoms, "v"; nm and
 * ps;
 * - AtomEye .cfg, standard and extended: "mass", "type" by the elements, "v", auxiliary values;
 * - Gadget-1 and -2 binary snapshots, plain or gzip, of either byte order: "type" (0 gas, 1 halo,
 *   2 disk, 3 bulge, 4 stars, 5 boundary), "id", "v", "mass", of gas "u" and "rho";
 * - HDF5 snapshots of Gadget, SWIFT and AREPO, H5Part and openPMD: every array of numbers;
 * - classic .bgeo files of Houdini and Partio: every attribute of points;
 * - Uintah data archives, by their index.xml: "material", and every particle variable.
 *
 * Output: vtkPolyData with the points in double and file order, one vertex cell a point, the arrays
 * as point data, and as field data "box" (nine numbers: a, b, c) with "box_origin" and "boundary"
 * where the file tells them, "type_names" ("0=gas") and "units". Numbers that some kinds of
 * particles lack are not a number (NaN) there.
 *
 * The first file of a snapshot that is spread over several, with ".0" at the end of its name or
 * ".0." in it, stands for all.
 *
 * Time steps are those of the file. Each process may ask for a piece of the particles.
 */

#ifndef vtkMoteParticleFormatsReader_h
#define vtkMoteParticleFormatsReader_h

#include "MoteFiltersIOModule.h" // For export macro
#include "vtkMotePolyDataReader.h"

#include <memory> // For the implementation

class MOTEFILTERSIO_EXPORT vtkMoteParticleFormatsReader : public vtkMotePolyDataReader
{
public:
  static vtkMoteParticleFormatsReader* New();
  vtkTypeMacro(vtkMoteParticleFormatsReader, vtkMotePolyDataReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkMoteParticleFormatsReader();
  ~vtkMoteParticleFormatsReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMoteParticleFormatsReader(const vtkMoteParticleFormatsReader&) = delete;
  void operator=(const vtkMoteParticleFormatsReader&) = delete;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
