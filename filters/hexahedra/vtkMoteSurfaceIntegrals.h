/**
 * @class   vtkMoteSurfaceIntegrals
 * @brief   area, means, flow rates, torque and head on slices and boundaries of hexahedral meshes
 *
 * The input is a vtkPolyData, or a vtkUnstructuredGrid with hexahedra, voxels, wedges, pyramids,
 * tetrahedra or polyhedra, or a composite data set of several, such as the parts of a pump.
 * Sections are planes, half planes and cylinders, met with the trilinear cells themselves, and the
 * boundary; all in the input's coordinates. Of a vtkPolyData, such as a patch of a boundary, the
 * boundary is its polygons, with normals by the right-hand rule; each is triangles to its middle.
 *
 * The output is a table with a row for each part and section, and, of several parts, one for each
 * section of all of them together, named "all": of grids where there are any, as patches bound
 * them. Columns:
 * - `part`, `section`: names; `cells`: cells that the section meets, of a boundary its faces;
 *   `area`.
 * - For each array of AddArray(), and for each component of it (`U:0`, or by its name): `NAME`, the
 *   mean by area, and `NAME_integral`.
 * - With a velocity: `flow`, its integral along the normal: along a plane's normal, away from a
 *   cylinder's axis, with the angles of a half plane by the right-hand rule, out of a boundary; and
 *   for each array `NAME_flow_mean`, the mean weighted with the flow (by mass, where the density is
 *   the same everywhere).
 * - With a pressure, of boundaries: `torque` about the axis of what the pressure does to whoever
 *   is behind the boundary: the integral of p (r x n), n out of the mesh. NaN for other sections.
 * - With both: `total_pressure`, the mean of p + density v^2 / 2 weighted with the flow, and
 *   `head`, by how much that is greater than in the part's first section, over density times
 *   gravity, 9.80665 m/s^2; of patches, than at the patch whose name has "inlet" in it, or else at
 *   the first with a flow.
 * Through walls, and where as much flows in as out, means weighted with the flow are NaN, and
 * GetReport() says so.
 * Each number has a column `NAME_error` beside it, what the quadrature may err by, estimated from
 * a coarser rule. docs/hexahedra.md tells the rules.
 *
 * Cells that the array of ghosts marks as hidden or as another's do not count.
 *
 * Values of points are trilinear in the cells, those of cells even. Where a value is NaN, so are
 * its sums.
 *
 * Errors: no such array, a velocity without three components, a pressure with several, no section,
 * an axis, a normal or a radius that is none. Each is reported by vtkErrorMacro as one sentence,
 * kept in GetErrorMessage(), with an empty output. Parts that lack an array have NaN.
 */

#ifndef vtkMoteSurfaceIntegrals_h
#define vtkMoteSurfaceIntegrals_h

#include "MoteFiltersHexahedraModule.h" // For export macro
#include "vtkTableAlgorithm.h"

#include <memory> // For the sections
#include <string> // For names

class vtkDataSet;

class MOTEFILTERSHEXAHEDRA_EXPORT vtkMoteSurfaceIntegrals : public vtkTableAlgorithm
{
public:
  static vtkMoteSurfaceIntegrals* New();
  vtkTypeMacro(vtkMoteSurfaceIntegrals, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Adds a section, by a name for its rows.
   */
  void AddPlane(const std::string& name, const double center[3], const double normal[3]);
  void AddHalfPlane(const std::string& name, const double center[3], const double axis[3],
    const double outwards[3]);
  void AddCylinder(
    const std::string& name, const double center[3], const double axis[3], double radius);
  void AddBoundary(const std::string& name);
  void RemoveAllSections();
  int GetNumberOfSections();
  //@}

  //@{
  /**
   * Names of arrays to be integrated, of points before those of cells.
   */
  void AddArray(const std::string& name);
  void RemoveAllArrays();
  //@}

  //@{
  /**
   * Names of the velocity and the pressure; none by default.
   */
  vtkSetMacro(VelocityArrayName, std::string);
  vtkGetMacro(VelocityArrayName, std::string);
  vtkSetMacro(PressureArrayName, std::string);
  vtkGetMacro(PressureArrayName, std::string);
  //@}

  //@{
  /**
   * The fluid's density, above 0; default 1. Where the pressure is given over the density, as
   * incompressible solvers do, KinematicPressure is to be on, and it is multiplied. Default off.
   */
  vtkSetClampMacro(Density, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Density, double);
  vtkSetMacro(KinematicPressure, bool);
  vtkGetMacro(KinematicPressure, bool);
  vtkBooleanMacro(KinematicPressure, bool);
  //@}

  //@{
  /**
   * The axis of torques: whether field arrays `AxisOrigin` and `AxisDirection` of the input go
   * before, default on; a point of it, and its direction of any length but 0, default the z axis.
   */
  vtkSetMacro(AxisFromInput, bool);
  vtkGetMacro(AxisFromInput, bool);
  vtkBooleanMacro(AxisFromInput, bool);
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  vtkSetVector3Macro(Axis, double);
  vtkGetVector3Macro(Axis, double);
  //@}

  //@{
  /**
   * What of a cell's integral may change when the cell is cut finer, before it is cut no more: a
   * share of that of the absolute value, or of the integral of the field's size over the section,
   * such as of the speed where that is the flow, over the root of the number of cells; in
   * [1e-12, 0.1], default 1e-7.
   */
  vtkSetClampMacro(Tolerance, double, 1e-12, 0.1);
  vtkGetMacro(Tolerance, double);
  //@}

  /**
   * What went wrong in the last run; empty if nothing did.
   */
  const std::string& GetErrorMessage() const { return this->ErrorMessage; }

  /**
   * A sentence about sections of the last run without flow; empty where there are none.
   */
  const std::string& GetReport() const { return this->Report; }

protected:
  vtkMoteSurfaceIntegrals();
  ~vtkMoteSurfaceIntegrals() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMoteSurfaceIntegrals(const vtkMoteSurfaceIntegrals&) = delete;
  void operator=(const vtkMoteSurfaceIntegrals&) = delete;

  std::string Integrate(vtkDataObject* input, vtkTable* table);
  bool FindAxis(vtkDataSet* data, double origin[3], double axis[3]);

  std::string VelocityArrayName, PressureArrayName;
  double Density = 1.0;
  bool KinematicPressure = false;
  bool AxisFromInput = true;
  double Origin[3] = {0.0, 0.0, 0.0};
  double Axis[3] = {0.0, 0.0, 1.0};
  double Tolerance = 1e-7;
  std::string ErrorMessage, Report;

  struct Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
