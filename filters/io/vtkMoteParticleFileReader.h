/**
 * @class   vtkMoteParticleFileReader
 * @brief   opens .mote files, Mote's own files of particles
 *
 * Output: vtkPolyData whose points (vtkMoteParticleFilePoints) and arrays stay in the file, mapped
 * into memory: opening takes the same time for files of any size, and pages come in as they are
 * used. There are no cells. Points stand in the order of the file; where the file was told to keep
 * it, the point array "vtkOriginalPointIds" has the order before that. Ranges of arrays and bounds
 * are known without a look at the values. Neither points nor arrays can be written to.
 *
 * A vtkMoteParticleMapper draws such data without a copy, with the radii that the file was written
 * with. vtkMoteParticleFileWriter writes the files; docs/mote-file.md describes them.
 *
 * Pieces: of several processes each gets its share of the particles, which stand beside one another
 * in the file and about so in space, in memory: as much as they take, and no tree. The radii of the
 * file are then an array, "radius", where there is none of that name.
 *
 * The file must not be made shorter while its data are in use; to replace it by another of the same
 * name is safe.
 */

#ifndef vtkMoteParticleFileReader_h
#define vtkMoteParticleFileReader_h

#include "MoteFiltersIOModule.h" // For export macro
#include "vtkMotePolyDataReader.h"

#include <memory> // For the file

namespace mote
{
class PkdTreeFile;
} // namespace mote

class MOTEFILTERSIO_EXPORT vtkMoteParticleFileReader : public vtkMotePolyDataReader
{
public:
  static vtkMoteParticleFileReader* New();
  vtkTypeMacro(vtkMoteParticleFileReader, vtkMotePolyDataReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkMoteParticleFileReader();
  ~vtkMoteParticleFileReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMoteParticleFileReader(const vtkMoteParticleFileReader&) = delete;
  void operator=(const vtkMoteParticleFileReader&) = delete;

  bool Open();

  std::shared_ptr<const mote::PkdTreeFile> File; // as of the last request for information
};

#endif
