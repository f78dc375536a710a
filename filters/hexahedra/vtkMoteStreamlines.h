/**
 * @class   vtkMoteStreamlines
 * @brief   streamlines from places spread evenly through volume meshes, or along a line
 *
 * The input is a data set with cells of volume, see vtkMoteInterpolatedVelocityField, or a
 * composite data set of several, through which lines go on. The vectors are those of
 * SetInputArrayToProcess(), of points or cells; without one the active vectors, or the first array
 * with three components. Vectors of cells become those of points first, as by
 * vtkCellDataToPointData, and so do all other arrays of cells then.
 *
 * Lines are vtkStreamTracer's, by Runge and Kutta's method of orders 4 and 5, both ways from each
 * seed, which all cores find together. They do not depend on the number of threads.
 *
 * Cells that the ghost array of a data set hides (vtkDataSetAttributes::HIDDENCELL) count as not
 * there: lines end at them. A data set with a field array "Placement", 16 numbers of a matrix row
 * by row, stands in the world as that turns and moves it, and its vectors turn with it; seeds and
 * lines are in the world. Nothing is built anew for that.
 *
 * Output 0 are the lines, with vtkStreamTracer's arrays. Output 1 are the seeds that lie in a cell,
 * a vertex each, with the arrays of points there: what glyphs are made of.
 *
 * Errors: no vectors, or not three components: one sentence by vtkErrorMacro, kept in
 * GetErrorMessage(), and no lines.
 */

#ifndef vtkMoteStreamlines_h
#define vtkMoteStreamlines_h

#include "MoteFiltersHexahedraModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For what runs share
#include <string> // For the message

class vtkPoints;

class MOTEFILTERSHEXAHEDRA_EXPORT vtkMoteStreamlines : public vtkPolyDataAlgorithm
{
public:
  static vtkMoteStreamlines* New();
  vtkTypeMacro(vtkMoteStreamlines, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * How many seeds there are. At least 0, default 100.
   */
  vtkSetClampMacro(NumberOfSeeds, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(NumberOfSeeds, vtkIdType);
  //@}

  //@{
  /**
   * Whether seeds lie evenly on the line from Point1 to Point2, both included, rather than evenly
   * through the volume of all cells. Default off.
   */
  vtkSetMacro(SeedsOnLine, bool);
  vtkGetMacro(SeedsOnLine, bool);
  vtkBooleanMacro(SeedsOnLine, bool);
  vtkSetVector3Macro(Point1, double);
  vtkGetVector3Macro(Point1, double);
  vtkSetVector3Macro(Point2, double);
  vtkGetVector3Macro(Point2, double);
  //@}

  //@{
  /**
   * Places of seeds in the world, in place of all others; those outside of all cells have no line.
   * Null, the default: none are given. Set other points where they have changed.
   */
  void SetSeedPlaces(vtkPoints* places);
  vtkPoints* GetSeedPlaces();
  //@}

  //@{
  /**
   * How far a line goes from its seed, each way, in the input's units; 0, the default: twice the
   * diagonal of the input. Lines end after MaximumNumberOfSteps, too (default 2000).
   */
  vtkSetClampMacro(MaximumLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumLength, double);
  vtkSetClampMacro(MaximumNumberOfSteps, vtkIdType, 1, VTK_ID_MAX);
  vtkGetMacro(MaximumNumberOfSteps, vtkIdType);
  //@}

  //@{
  /**
   * Whether there is an output 0. Default on.
   */
  vtkSetMacro(ComputeLines, bool);
  vtkGetMacro(ComputeLines, bool);
  vtkBooleanMacro(ComputeLines, bool);
  //@}

  /**
   * What was wrong with the last run; empty where nothing was.
   */
  const std::string& GetErrorMessage() const { return this->ErrorMessage; }

protected:
  vtkMoteStreamlines();
  ~vtkMoteStreamlines() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMoteStreamlines(const vtkMoteStreamlines&) = delete;
  void operator=(const vtkMoteStreamlines&) = delete;

  struct Internals;

  vtkIdType NumberOfSeeds = 100;
  bool SeedsOnLine = false, ComputeLines = true;
  double Point1[3] = {0.0, 0.0, 0.0}, Point2[3] = {1.0, 0.0, 0.0};
  double MaximumLength = 0.0;
  vtkIdType MaximumNumberOfSteps = 2000;
  std::string ErrorMessage;
  std::unique_ptr<Internals> Impl;
};

#endif
