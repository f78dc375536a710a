/**
 * @class   vtkMoteVolumeQuantiles
 * @brief   how the values of an array are distributed over the volume of a mesh
 *
 * The input is any data set, or a composite one, whose data sets count together: its hexahedra,
 * voxels, wedges, pyramids and tetrahedra. The quantile of a share is the value that this share of
 * the volume lies below; 0 and 1 give the least and the greatest value. The output is a table with
 * the columns `share` (0, 0.01, ... 1) and `value`; without rows where there is no finite value.
 *
 * A cell's volume is divided among its corners as the trilinear map does, so that quantiles of
 * point arrays err by less than values vary within a cell. Of meshes with more than
 * MaximumNumberOfCells cells, so many are taken, evenly by number; least and greatest value are
 * then those of the cells that were taken.
 */

#ifndef vtkMoteVolumeQuantiles_h
#define vtkMoteVolumeQuantiles_h

#include "MoteFiltersHexahedraModule.h" // For export macro
#include "vtkTableAlgorithm.h"

#include <string>
#include <vector>

class MOTEFILTERSHEXAHEDRA_EXPORT vtkMoteVolumeQuantiles : public vtkTableAlgorithm
{
public:
  static vtkMoteVolumeQuantiles* New();
  vtkTypeMacro(vtkMoteVolumeQuantiles, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /** The array, of numbers; one that a part of the input lacks leaves that part out. */
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
  //@}

  //@{
  /** Whether it is an array of cells. Off: of points. */
  vtkSetMacro(OfCells, vtkTypeBool);
  vtkGetMacro(OfCells, vtkTypeBool);
  vtkBooleanMacro(OfCells, vtkTypeBool);
  //@}

  //@{
  /** The component, or -1 for the magnitude. Default 0. */
  vtkSetMacro(Component, int);
  vtkGetMacro(Component, int);
  //@}

  //@{
  /** At most so many cells are looked at, at least 1. Default 200,000. */
  vtkSetClampMacro(MaximumNumberOfCells, vtkIdType, 1, VTK_ID_MAX);
  vtkGetMacro(MaximumNumberOfCells, vtkIdType);
  //@}

  /** The quantile of a share from 0 to 1, as of the last Update(); NaN where there is no value. */
  double GetQuantile(double share) const;

protected:
  vtkMoteVolumeQuantiles();
  ~vtkMoteVolumeQuantiles() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMoteVolumeQuantiles(const vtkMoteVolumeQuantiles&) = delete;
  void operator=(const vtkMoteVolumeQuantiles&) = delete;

  std::string ArrayName;
  vtkTypeBool OfCells = 0;
  int Component = 0;
  vtkIdType MaximumNumberOfCells = 200000;
  std::vector<double> Values; // ascending
  std::vector<double> Shares; // of the volume up to and with each value
};

#endif
