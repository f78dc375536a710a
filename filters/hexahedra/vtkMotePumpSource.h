/**
 * @class   vtkMotePumpSource
 * @brief   a synthetic centrifugal pump of hexahedra, with a flow that turns
 *
 * Three parts, in the manner of the pump of Wang, Elshehaly and Cao ("Cylindrical Acceleration
 * Structures for Large Hexahedral Volume Visualization"), by formulas (docs/pump.md):
 *
 *  - `inlet`: a straight pipe whose cells hold the axis;
 *  - `rotor`: an impeller with seven backward-swept, twisted blades between hub and shroud;
 *  - `diffuser`: a ring with nine vanes, and a volute that leaves it by a straight pipe.
 *
 * Blades and vanes are gaps in the mesh, which is drawn thin to them and to all walls. Inside a
 * part cells share vertices; the parts share none.
 *
 * The output is a vtkMultiBlockDataSet with the three named blocks, or, with SetPart(), the
 * vtkUnstructuredGrid of one. Point arrays (float): `pressure` in Pa, the active scalars, and
 * `velocity` in m/s in the frame at rest, the active vectors. Lengths are metres. Field arrays
 * `AxisOrigin` and `AxisDirection` tell where the pump stands.
 *
 * The output has NumberOfTimeSteps time steps over one revolution; any other time may be asked for
 * as well. Every part keeps its place, the rotor, too: it is seen from a frame that turns with it.
 * Points and cells are made once: the outputs of all times hold the same vtkPoints and
 * vtkCellArray, with the same MTime. All is computed in parallel.
 *
 * Errors: an axis without length, a radius, rotation rate or origin that is not finite, reported by
 * vtkErrorMacro with an empty output.
 */

#ifndef vtkMotePumpSource_h
#define vtkMotePumpSource_h

#include "MoteFiltersHexahedraModule.h" // For export macro
#include "vtkDataObjectAlgorithm.h"

#include <memory> // For the parts

class MOTEFILTERSHEXAHEDRA_EXPORT vtkMotePumpSource : public vtkDataObjectAlgorithm
{
public:
  static vtkMotePumpSource* New();
  vtkTypeMacro(vtkMotePumpSource, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum PartType
  {
    ALL = 0,
    INLET,
    ROTOR,
    DIFFUSER
  };

  //@{
  /**
   * How many cells there are, as a share of 6.45 million: inlet 0.86, rotor 2.15, diffuser 3.44
   * million at 1. From 0.0005 to 10. Default 0.01.
   */
  vtkSetClampMacro(Scale, double, 0.0005, 10.0);
  vtkGetMacro(Scale, double);
  //@}

  //@{
  /**
   * Which part to make, or all of them. Default ALL.
   */
  vtkSetClampMacro(Part, int, ALL, DIFFUSER);
  vtkGetMacro(Part, int);
  void SetPartToAll() { this->SetPart(ALL); }
  void SetPartToInlet() { this->SetPart(INLET); }
  void SetPartToRotor() { this->SetPart(ROTOR); }
  void SetPartToDiffuser() { this->SetPart(DIFFUSER); }
  //@}

  //@{
  /**
   * The impeller's radius in metres, above 0. Default 0.1.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  //@}

  //@{
  /**
   * Revolutions a second, above 0. Default 25.
   */
  vtkSetMacro(RotationRate, double);
  vtkGetMacro(RotationRate, double);
  //@}

  //@{
  /**
   * The middle of the impeller's eye, where the inlet ends. Default 0.
   */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  //@}

  //@{
  /**
   * The direction in which water enters, of any length but 0; the impeller turns to the right about
   * it. Default z.
   */
  vtkSetVector3Macro(Axis, double);
  vtkGetVector3Macro(Axis, double);
  //@}

  //@{
  /**
   * Time steps in one revolution. Default 80.
   */
  vtkSetClampMacro(NumberOfTimeSteps, int, 1, 100000);
  vtkGetMacro(NumberOfTimeSteps, int);
  //@}

  //@{
  /**
   * vtkAlgorithm::SINGLE_PRECISION or DOUBLE_PRECISION, the default: at large scales or far from 0
   * the thinnest cells are flat in single precision.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DOUBLE_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  //@}

  /**
   * How many cells a part has at a scale (clamped as Scale is), without making them; of ALL their
   * sum.
   */
  static vtkIdType GetNumberOfCells(double scale, int part);

protected:
  vtkMotePumpSource();
  ~vtkMotePumpSource() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMotePumpSource(const vtkMotePumpSource&) = delete;
  void operator=(const vtkMotePumpSource&) = delete;

  bool CheckFrame();
  void MakeParts();

  double Scale = 0.01;
  int Part = ALL;
  double Radius = 0.1;
  double RotationRate = 25.0;
  double Origin[3] = {0.0, 0.0, 0.0};
  double Axis[3] = {0.0, 0.0, 1.0};
  int NumberOfTimeSteps = 80;
  int OutputPointsPrecision = DOUBLE_PRECISION;

  struct Internals;
  std::unique_ptr<Internals> Made;
};

#endif
