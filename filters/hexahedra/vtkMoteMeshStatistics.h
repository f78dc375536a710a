/**
 * @class   vtkMoteMeshStatistics
 * @brief   what volume meshes hold: cells, volumes, quality, and means of arrays by volume
 *
 * The input is any data set, or a composite one, of whose data sets each is a block. Both outputs
 * are tables; the first has one row for each block:
 *
 *  - `block`: its name; empty for an input that is one data set;
 *  - `cells`: all but ghosts; `hexahedra` (voxels among them), `wedges`, `pyramids`, `tetrahedra`,
 *    `polyhedra`, and `other` types, of which the rest says nothing: polyhedra that are not closed
 *    or too concave for volumes (see vtkMoteVolumeMapper) are among these;
 *  - `inverted`: cells with a corner that is inside out (wedges may be listed in both orders);
 *    `zero_volume`: with less than 1e-14 of the cube of their longest edge; `non_finite`: with a
 *    corner at no place, left out of the rest;
 *  - `volume`, `min_volume`, `max_volume`: of a cell's trilinear map, exact, counted above 0;
 *  - of all but polyhedra `min_scaled_jacobian`, `mean_scaled_jacobian`: at the worst corner of a
 *    cell, 1 for a cube and for every regular cell; `max_aspect_ratio`: the longest by the shortest
 * edge.
 *
 * The second output has one row for each block and array of numbers that lies on points or cells:
 * `block`, `array`, `of` ("point" or "cell"), `components`, and `min`, `mean`, `max` of the value,
 * or of the magnitude where there are several components. The mean is the integral over the volume
 * by the volume: exact for point arrays as the trilinear map interpolates their values.
 * `non_finite` counts the cells that were left out for such a value. NaN stands where there is
 * nothing to tell.
 *
 * Computed in parallel, with the same result for every number of threads.
 */

#ifndef vtkMoteMeshStatistics_h
#define vtkMoteMeshStatistics_h

#include "MoteFiltersHexahedraModule.h" // For export macro
#include "vtkTableAlgorithm.h"

class MOTEFILTERSHEXAHEDRA_EXPORT vtkMoteMeshStatistics : public vtkTableAlgorithm
{
public:
  static vtkMoteMeshStatistics* New();
  vtkTypeMacro(vtkMoteMeshStatistics, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkMoteMeshStatistics();
  ~vtkMoteMeshStatistics() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMoteMeshStatistics(const vtkMoteMeshStatistics&) = delete;
  void operator=(const vtkMoteMeshStatistics&) = delete;
};

#endif
