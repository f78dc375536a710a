/**
 * @class   vtkMoteMeshFileWriter
 * @brief   writes triangles as a .mote file, ready to be drawn
 *
 * Input is what a vtkMoteMeshMapper draws: polygons and strips, or the faces of grids, cut into
 * triangles. The file holds their tree with R-LODs, the triangles, the points that they use, all
 * point, cell and field arrays of numbers, and the time; triangles have the values of their cells.
 * Triangles with a corner that is not finite are left out, and so is text, with a warning. Normals
 * of points, if there are any, make the triangles smooth. vtkMoteMeshFileReader opens it;
 * docs/mote-file.md describes it.
 *
 * Mesh, tree and arrays are in memory while it is written: for float points some 110 bytes a
 * triangle in all.
 */

#ifndef vtkMoteMeshFileWriter_h
#define vtkMoteMeshFileWriter_h

#include "MoteRenderingVTKModule.h" // for export macro
#include "vtkMoteStructureFileWriter.h"
#include "vtkSmartPointer.h" // for the mapper

class vtkMoteMeshMapper;

class MOTERENDERINGVTK_EXPORT vtkMoteMeshFileWriter : public vtkMoteStructureFileWriter
{
public:
  static vtkMoteMeshFileWriter* New();
  vtkTypeMacro(vtkMoteMeshFileWriter, vtkMoteStructureFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The mapper whose structure is written, and, where the writer has no input of its own, whose
   * input. One of the writer's own at first.
   */
  void SetMapper(vtkMoteMeshMapper* mapper);
  vtkMoteMeshMapper* GetMapper();
  //@}

protected:
  vtkMoteMeshFileWriter();
  ~vtkMoteMeshFileWriter() override;
  void ReportReferences(vtkGarbageCollector* collector) override;
  bool WriteFile() override;

private:
  vtkMoteMeshFileWriter(const vtkMoteMeshFileWriter&) = delete;
  void operator=(const vtkMoteMeshFileWriter&) = delete;

  vtkSmartPointer<vtkMoteMeshMapper> Mapper;
};

#endif
