/**
 * @class   vtkMoteMeridionalAverage
 * @brief   the average of an array over circles about an axis, by radius and place along the axis
 *
 * The input is a data set with hexahedra, voxels, wedges, pyramids, tetrahedra or polyhedra, or a
 * composite one of several, such as the parts of a pump, which are then averaged together. The
 * array, on points or cells, has one component or three.
 *
 * The plane of place along the axis and distance from it is cut into square bins. A bin's average
 * is the integral over the part of the cells' volume that falls into it when it turns about the
 * axis, by that volume. Cells are cut into pieces of a third of a bin, with two Gauss samples
 * along each direction; a point array is interpolated by the trilinear map of the cell.
 *
 * First output, a vtkTable with a row for each bin that holds something: `axial` and `radial`, the
 * middle of the bin; `volume`; for an array NAME of one component `NAME`, its average, and
 * `NAME_deviation`, the standard deviation over the bin, such as from blade to blade; for a vector
 * `NAME_axial`, `NAME_radial`, `NAME_circumferential` (right-handed about the axis) and
 * `NAME_magnitude`.
 *
 * Second output, a vtkImageData of the same columns: x along the axis, y from it, one point for
 * each bin; NaN, and volume 0, where nothing lies.
 *
 * Errors: no such array, another number of components, no cell with volume, an axis without
 * direction. Each is reported by vtkErrorMacro as one sentence, kept in GetErrorMessage(), with
 * empty outputs.
 */

#ifndef vtkMoteMeridionalAverage_h
#define vtkMoteMeridionalAverage_h

#include "MoteFiltersHexahedraModule.h" // For export macro
#include "vtkTableAlgorithm.h"

#include <string> // For names

class vtkImageData;

class MOTEFILTERSHEXAHEDRA_EXPORT vtkMoteMeridionalAverage : public vtkTableAlgorithm
{
public:
  static vtkMoteMeridionalAverage* New();
  vtkTypeMacro(vtkMoteMeridionalAverage, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The array's name. One on points is taken before one on cells. Required.
   */
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
  ///@}

  ///@{
  /**
   * How many bins lie along the longer edge of the plane. From 1 to 4096, default 200.
   */
  vtkSetClampMacro(Resolution, int, 1, 4096);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * Whether field arrays `AxisOrigin` and `AxisDirection` of the input, as vtkMotePumpSource makes
   * them, go before Origin and Axis. Default on.
   */
  vtkSetMacro(AxisFromInput, bool);
  vtkGetMacro(AxisFromInput, bool);
  vtkBooleanMacro(AxisFromInput, bool);
  ///@}

  ///@{
  /**
   * A point of the axis, and its direction of any length but 0. Default the z axis.
   */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  vtkSetVector3Macro(Axis, double);
  vtkGetVector3Macro(Axis, double);
  ///@}

  /**
   * The second output.
   */
  vtkImageData* GetImage();

  /**
   * What went wrong in the last run; empty if nothing did.
   */
  const std::string& GetErrorMessage() const { return this->ErrorMessage; }

protected:
  vtkMoteMeridionalAverage();
  ~vtkMoteMeridionalAverage() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMoteMeridionalAverage(const vtkMoteMeridionalAverage&) = delete;
  void operator=(const vtkMoteMeridionalAverage&) = delete;

  std::string Average(vtkDataObject* input, vtkTable* table, vtkImageData* image);

  std::string ArrayName;
  int Resolution = 200;
  bool AxisFromInput = true;
  double Origin[3] = {0.0, 0.0, 0.0};
  double Axis[3] = {0.0, 0.0, 1.0};
  std::string ErrorMessage;
};

#endif
