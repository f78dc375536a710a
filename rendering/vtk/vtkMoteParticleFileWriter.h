/**
 * @class   vtkMoteParticleFileWriter
 * @brief   writes particles as a .mote file, ready to be drawn
 *
 * Input is any vtkPointSet; each of its points is a particle, cells are not written. The file holds
 * a built P-k-d tree over the particles that can be drawn (positions and radii that are finite,
 * radii above zero), all point and field arrays of numbers, and the time; text is left out, with
 * a warning where it is point data. Positions are rounded to
 * at least the precision of float numbers over the data's size. vtkMoteParticleFileReader opens it;
 * docs/mote-file.md describes it.
 *
 * Radii are those of a mapper, whose rules can be set: GetMapper()->SetRadiusModeToConstant(). A
 * mapper with an input of its own (SetMapper()) has its particles written, all of them whatever its
 * ranges hide.
 */

#ifndef vtkMoteParticleFileWriter_h
#define vtkMoteParticleFileWriter_h

#include "MoteRenderingVTKModule.h" // for export macro
#include "vtkMoteStructureFileWriter.h"
#include "vtkSmartPointer.h" // for the mapper

class vtkMoteParticleMapper;

class MOTERENDERINGVTK_EXPORT vtkMoteParticleFileWriter : public vtkMoteStructureFileWriter
{
public:
  static vtkMoteParticleFileWriter* New();
  vtkTypeMacro(vtkMoteParticleFileWriter, vtkMoteStructureFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The mapper whose rules of radii hold and, where the writer has no input of its own, whose
   * input is written. One of the writer's own at first. Its StructureName becomes "pkd-tree"; its
   * StructureForm is the form that is written.
   */
  void SetMapper(vtkMoteParticleMapper* mapper);
  vtkMoteParticleMapper* GetMapper();
  //@}

protected:
  vtkMoteParticleFileWriter();
  ~vtkMoteParticleFileWriter() override;
  void ReportReferences(vtkGarbageCollector* collector) override;
  bool WriteFile() override;

private:
  vtkMoteParticleFileWriter(const vtkMoteParticleFileWriter&) = delete;
  void operator=(const vtkMoteParticleFileWriter&) = delete;

  vtkSmartPointer<vtkMoteParticleMapper> Mapper;
};

#endif
