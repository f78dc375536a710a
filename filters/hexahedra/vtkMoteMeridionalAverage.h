/**
 * @class   vtkMoteMeridionalAverage
 * @brief   the average of an array over circles about an axis, by radius and place along the axis
 *
 * The input is a data set with hexahedra, voxels, wedges, pyramids, tetrahedra or polyhedra, or a
 * composite one of several, such as the parts of a pump, which are then averaged together. What is
 * averaged, on points or cells, has one component or three.
 *
 * The plane of place along the axis and distance from it is cut into square bins. A bin's average
 * is the integral over the part of the cells' volume that falls into it when it turns about the
 * axis, by that volume. A cell that fits into a bin is cut into pieces of a third of a bin, with
 * two Gauss samples along each direction. One that reaches over more is cut into lines, along which
 * the integral between the edges of bins is exact: two between those edges as the cell's middle
 * meets them, by four a bin, up to 64, in the third direction. A point array is interpolated by the
 * trilinear map of the cell.
 *
 * First output, a vtkTable with a row for each bin that holds something: `axial` and `radial`, the
 * middle of the bin; `volume`; for an array NAME of one component `NAME`, its average, and
 * `NAME_deviation`, the standard deviation over the bin, such as from blade to blade; the same for
 * one component, which is named `NAME:2` or by its own name, `NAME:z`, and for `NAME:magnitude`;
 * for a vector
 * `NAME_axial`, `NAME_radial`, `NAME_circumferential` (right-handed about the axis) and
 * `NAME_magnitude`.
 *
 * Second output, a vtkImageData of the same columns: x along the axis, y from it, one point for
 * each bin; NaN, and volume 0, where nothing lies.
 *
 * Errors: no such array or component, another number of components, no cell with volume within the
 * ranges, an axis without direction. Each is reported by vtkErrorMacro as one sentence, kept in
 * GetErrorMessage(), with empty outputs.
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

  //@{
  /**
   * The array's name. Required.
   */
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
  //@}

  //@{
  /**
   * Where the array lies: vtkDataObject::FIELD_ASSOCIATION_POINTS, FIELD_ASSOCIATION_CELLS, or
   * FIELD_ASSOCIATION_POINTS_THEN_CELLS, the default, for one on points before one on cells.
   */
  vtkSetClampMacro(Association, int, 0, 2);
  vtkGetMacro(Association, int);
  //@}

  enum ComponentType
  {
    WHOLE = -1,
    MAGNITUDE = -2
  };

  //@{
  /**
   * The component that is averaged, from 0; or MAGNITUDE of all; or WHOLE, the default: an array of
   * one component, or the parts of a vector.
   */
  vtkSetMacro(Component, int);
  vtkGetMacro(Component, int);
  //@}

  //@{
  /**
   * How many bins lie along the longer edge of the plane, as far as the data reach. From 1 to 4096,
   * default 200.
   */
  vtkSetClampMacro(Resolution, int, 1, 4096);
  vtkGetMacro(Resolution, int);
  //@}

  //@{
  /**
   * Whether field arrays `AxisOrigin` and `AxisDirection` of the input, as vtkMotePumpSource makes
   * them, go before Origin and Axis. Default on.
   */
  vtkSetMacro(AxisFromInput, bool);
  vtkGetMacro(AxisFromInput, bool);
  vtkBooleanMacro(AxisFromInput, bool);
  //@}

  //@{
  /**
   * A point of the axis, and its direction of any length but 0. Default the z axis.
   */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  vtkSetVector3Macro(Axis, double);
  vtkGetVector3Macro(Axis, double);
  //@}

  //@{
  /**
   * The places along the axis and the distances from it that are averaged. Bins have the size that
   * they have without. Default all.
   */
  vtkSetVector2Macro(AxialRange, double);
  vtkGetVector2Macro(AxialRange, double);
  vtkSetVector2Macro(RadialRange, double);
  vtkGetVector2Macro(RadialRange, double);
  //@}

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
  int Association = 2;
  int Component = WHOLE;
  int Resolution = 200;
  bool AxisFromInput = true;
  double Origin[3] = {0.0, 0.0, 0.0};
  double Axis[3] = {0.0, 0.0, 1.0};
  double AxialRange[2], RadialRange[2];
  std::string ErrorMessage;
};

#endif
