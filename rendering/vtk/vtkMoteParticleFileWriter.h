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
 *
 * The file is written under a temporary name in the same folder and then renamed: under its own
 * name it is complete or is not there.
 */

#ifndef vtkMoteParticleFileWriter_h
#define vtkMoteParticleFileWriter_h

#include "MoteRenderingVTKModule.h" // for export macro
#include "vtkSmartPointer.h"        // for the mapper
#include "vtkWriter.h"

#include <string> // for messages

class vtkMoteParticleMapper;

class MOTERENDERINGVTK_EXPORT vtkMoteParticleFileWriter : public vtkWriter
{
public:
  static vtkMoteParticleFileWriter* New();
  vtkTypeMacro(vtkMoteParticleFileWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to write.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * The mapper whose rules of radii hold and, where the writer has no input of its own, whose
   * input is written. One of the writer's own at first. Its StructureName becomes "pkd-tree"; its
   * StructureForm is the form that is written.
   */
  void SetMapper(vtkMoteParticleMapper* mapper);
  vtkMoteParticleMapper* GetMapper();
  ///@}

  ///@{
  /**
   * Whether the points' order in the input is kept, as the point array "vtkOriginalPointIds" (4
   * bytes a particle; 8 above 2^32). On by default; without effect where the input has an array of
   * that name, which is then written as any.
   */
  vtkSetMacro(WriteOriginalIds, vtkTypeBool);
  vtkGetMacro(WriteOriginalIds, vtkTypeBool);
  vtkBooleanMacro(WriteOriginalIds, vtkTypeBool);
  ///@}

  /**
   * Writes the file: 1 where that was done, else 0 after an error.
   */
  int Write() override;

  /**
   * What went wrong in the last Write(), as one sentence; empty where nothing did.
   */
  std::string GetErrorMessage() { return this->ErrorMessage; }

protected:
  vtkMoteParticleFileWriter();
  ~vtkMoteParticleFileWriter() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  void ReportReferences(vtkGarbageCollector* collector) override;
  void WriteData() override {}

  char* FileName = nullptr;
  vtkTypeBool WriteOriginalIds = 1;

private:
  vtkMoteParticleFileWriter(const vtkMoteParticleFileWriter&) = delete;
  void operator=(const vtkMoteParticleFileWriter&) = delete;

  bool WriteParticles();

  vtkSmartPointer<vtkMoteParticleMapper> Mapper;
  std::string ErrorMessage;
};

#endif
