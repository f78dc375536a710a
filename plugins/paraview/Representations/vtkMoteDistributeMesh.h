/**
 * @class   vtkMoteDistributeMesh
 * @brief   gives each rank the polygons of one box, and copies of those beside it
 *
 * See vtkMoteDistribute. Of the input the surfaces (vtkPolyData) are taken: their polygons with all
 * arrays, and strips as triangles; no lines and vertices. A polygon belongs to the box that has the
 * middle of its bounds, and ghosts lie within GhostDistance of the bounds of a rank's own, which
 * may reach out of its box.
 */

#ifndef vtkMoteDistributeMesh_h
#define vtkMoteDistributeMesh_h

#include "MoteParaViewRepresentationsModule.h" // For export macro
#include "vtkMoteDistribute.h"

class MOTEPARAVIEWREPRESENTATIONS_EXPORT vtkMoteDistributeMesh : public vtkMoteDistribute
{
public:
  static vtkMoteDistributeMesh* New();
  vtkTypeMacro(vtkMoteDistributeMesh, vtkMoteDistribute);

protected:
  vtkMoteDistributeMesh() = default;
  ~vtkMoteDistributeMesh() override = default;
  vtkSmartPointer<vtkPolyData> Collect(const std::vector<vtkPointSet*>& parts) override;
  bool IsOfCells() const override { return true; }

private:
  vtkMoteDistributeMesh(const vtkMoteDistributeMesh&) = delete;
  void operator=(const vtkMoteDistributeMesh&) = delete;
};

#endif
