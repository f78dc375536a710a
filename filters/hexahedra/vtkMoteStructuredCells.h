/**
 * @class   vtkMoteStructuredCells
 * @brief   images and structured grids as unstructured grids of voxels and hexahedra
 *
 * vtkMoteVolumeMapper, cell locators and averages are for unstructured grids. Of() makes one of a
 * vtkImageData, vtkRectilinearGrid or vtkStructuredGrid: voxels where the axes are those of space,
 * else hexahedra, in the order of the grid's cells and points, with the grid's own arrays. Where a
 * grid's cells are inside out as a whole, as in a left-handed structured grid, their corners are
 * taken in the other order. Where a structured grid meets itself (around a body, or in the wake
 * behind it), and all point arrays have one value on both sides, cells share the points there, so
 * that there is no wall between them.
 *
 * Cells that are marked as ghosts or blanked (vtkGhostType), which several pieces have or none is
 * to show, are left out, of unstructured grids and polygons too.
 */

#ifndef vtkMoteStructuredCells_h
#define vtkMoteStructuredCells_h

#include "MoteFiltersHexahedraModule.h" // For export macro
#include "vtkObject.h"

class vtkDataSet;

class MOTEFILTERSHEXAHEDRA_EXPORT vtkMoteStructuredCells : public vtkObject
{
public:
  static vtkMoteStructuredCells* New();
  vtkTypeMacro(vtkMoteStructuredCells, vtkObject);

  /**
   * The unstructured grid that a structured one makes. Where there is nothing to be done, as for
   * grids that are flat, for other data sets, and where it would take more memory than
   * `mostBytes` (0: any), the data set itself.
   */
  VTK_NEWINSTANCE static vtkDataSet* Of(vtkDataSet* data, vtkTypeUInt64 mostBytes = 0);

protected:
  vtkMoteStructuredCells() = default;
  ~vtkMoteStructuredCells() override = default;

private:
  vtkMoteStructuredCells(const vtkMoteStructuredCells&) = delete;
  void operator=(const vtkMoteStructuredCells&) = delete;
};

#endif
