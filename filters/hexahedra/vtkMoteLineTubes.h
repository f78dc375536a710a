/**
 * @class   vtkMoteLineTubes
 * @brief   lines as tubes: streamlines, bonds, fibres
 *
 * The input is a vtkPolyData or an unstructured grid whose lines and polylines are taken; other
 * cells are left out. The output are vtkTubeFilter's strips, capped at the ends, with its normals.
 * That filter gives up a whole line where two of its points coincide or where it turns back on
 * itself, as streamlines do where the flow stands still. Here such points are passed over, and a
 * line ends and begins anew where it turns by more than 143 degrees or where a coordinate is not
 * finite. A line without length has no tube; GetNumberOfLinesLeftOut() counts these.
 *
 * Arrays of points go on, and of cells: strips have the values of the line that they are around.
 */

#ifndef vtkMoteLineTubes_h
#define vtkMoteLineTubes_h

#include "MoteFiltersHexahedraModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For names of arrays

class vtkDataSet;

class MOTEFILTERSHEXAHEDRA_EXPORT vtkMoteLineTubes : public vtkPolyDataAlgorithm
{
public:
  static vtkMoteLineTubes* New();
  vtkTypeMacro(vtkMoteLineTubes, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Whether a data set is a vtkPolyData or an unstructured grid of lines and polylines alone, at
   * least one.
   */
  static bool IsOfLines(vtkDataSet* data);

  //@{
  /**
   * Radius of the tubes, in the units of the points; at least 0. 0, the default, takes 0.0015 of
   * the diagonal of the bounds, or a twentieth of the mean length of the lines where that is less.
   */
  vtkSetClampMacro(Radius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Radius, double);
  //@}

  //@{
  /**
   * An array of points with one component that holds the radius at each, in place of Radius. Empty,
   * the default: none. Values that are not above zero and finite make the tube a thousandth of the
   * greatest radius thin.
   */
  vtkSetMacro(RadiusArrayName, std::string);
  vtkGetMacro(RadiusArrayName, std::string);
  //@}

  //@{
  /**
   * Factor on all radii. Above 0, default 1.
   */
  vtkSetClampMacro(RadiusScale, double, VTK_DBL_MIN, VTK_DOUBLE_MAX);
  vtkGetMacro(RadiusScale, double);
  //@}

  //@{
  /**
   * How many sides a tube has. Below 3, the default, 8 for up to a million points, and fewer for
   * more, so that there are no more than eight million corners, but at least 3.
   */
  vtkSetClampMacro(NumberOfSides, int, 0, 1000);
  vtkGetMacro(NumberOfSides, int);
  //@}

  /**
   * How many lines of the last run have no tube, as they have no length.
   */
  vtkGetMacro(NumberOfLinesLeftOut, vtkIdType);

protected:
  vtkMoteLineTubes() = default;
  ~vtkMoteLineTubes() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMoteLineTubes(const vtkMoteLineTubes&) = delete;
  void operator=(const vtkMoteLineTubes&) = delete;

  double Radius = 0.0, RadiusScale = 1.0;
  std::string RadiusArrayName;
  int NumberOfSides = 0;
  vtkIdType NumberOfLinesLeftOut = 0;
};

#endif
