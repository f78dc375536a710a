/**
 * @class   vtkMoteGeneratedParticlesReader
 * @brief   particles that are made instead of read
 *
 * In the place of a file's name stands which: lattice:N, random:N:R or varied:N (see
 * mote::makeParticles). Output: vtkPolyData with points (vtkMoteSourcePoints) that are worked out
 * whenever they are looked at, without cells and arrays. A vtkMoteParticleMapper draws them with
 * the radii that belong to them.
 */

#ifndef vtkMoteGeneratedParticlesReader_h
#define vtkMoteGeneratedParticlesReader_h

#include "MoteFiltersIOModule.h" // For export macro
#include "vtkMotePolyDataReader.h"

class MOTEFILTERSIO_EXPORT vtkMoteGeneratedParticlesReader : public vtkMotePolyDataReader
{
public:
  static vtkMoteGeneratedParticlesReader* New();
  vtkTypeMacro(vtkMoteGeneratedParticlesReader, vtkMotePolyDataReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkMoteGeneratedParticlesReader();
  ~vtkMoteGeneratedParticlesReader() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMoteGeneratedParticlesReader(const vtkMoteGeneratedParticlesReader&) = delete;
  void operator=(const vtkMoteGeneratedParticlesReader&) = delete;
};

#endif
