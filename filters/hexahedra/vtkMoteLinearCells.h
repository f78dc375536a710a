/**
 * @class   vtkMoteLinearCells
 * @brief   cells of higher order, cut into linear ones through their nodes
 *
 * vtkMoteVolumeMapper, cell locators and averages are for linear cells. Of() makes such of
 * quadratic tetrahedra, hexahedra, wedges and pyramids, with or without nodes in their faces and
 * middles, and of Lagrange tetrahedra, hexahedra and wedges of any order: a cell of order n becomes
 * n^3 cells of its kind between its nodes (a pyramid 6 pyramids and 4 tetrahedra), which neighbours
 * share. Where a quadratic cell has no node in a face or in its middle, one is made there, with the
 * values that the cell's own interpolation has. So places and values are those of the cells at all
 * nodes, and linear between: for cells of order 2 the error is a quarter of that of their corners
 * alone.
 *
 * All other cells stay. Each linear cell has the values of the one that it was cut from, and its
 * number in the array of cells `OriginalCellIds`.
 */

#ifndef vtkMoteLinearCells_h
#define vtkMoteLinearCells_h

#include "MoteFiltersHexahedraModule.h" // For export macro
#include "vtkObject.h"

class vtkDataSet;

class MOTEFILTERSHEXAHEDRA_EXPORT vtkMoteLinearCells : public vtkObject
{
public:
  static vtkMoteLinearCells* New();
  vtkTypeMacro(vtkMoteLinearCells, vtkObject);

  /**
   * The number of cells that Of() cuts: those of higher order in three dimensions. 0 for data sets
   * that are no unstructured grid.
   */
  static vtkIdType CountIn(vtkDataSet* data);

  /**
   * The grid of linear cells. Where there is nothing to be cut, and where the cells and points
   * would take more memory than `mostBytes` (0: any), the data set itself.
   */
  VTK_NEWINSTANCE static vtkDataSet* Of(vtkDataSet* data, vtkTypeUInt64 mostBytes = 0);

protected:
  vtkMoteLinearCells() = default;
  ~vtkMoteLinearCells() override = default;

private:
  vtkMoteLinearCells(const vtkMoteLinearCells&) = delete;
  void operator=(const vtkMoteLinearCells&) = delete;
};

#endif
