/**
 * @class   vtkMoteCylindricalLocator
 * @brief   finds cells by a grid or a hierarchy in (r, theta, h) or (x, y, z)
 *
 * A vtkAbstractCellLocator over mote's structures of hexahedra (docs/hexahedra.md), for wherever
 * VTK takes one: vtkProbeFilter, vtkResampleWithDataSet, vtkStreamTracer (by a
 * vtkCellLocatorInterpolatedVelocityField). It takes any vtkDataSet. Hexahedra, voxels, wedges,
 * pyramids and tetrahedra are found, all with trilinear insides and bilinear faces; a point of a
 * face belongs to one of the cells beside it, the same one for every cell that is asked. Cells of
 * other types, of no volume, or with points that are not finite are never found. Ghost cells are,
 * as by VTK's locators; blanked cells of structured grids are not.
 *
 * A point a little outside of the mesh is in a cell, as for VTK's cells: up to 1e-6 in the cell's
 * own coordinates for hexahedra and voxels, 1e-3 for the others. So tolerances that are passed to
 * FindCell(), IntersectWithLine() and FindCellsAlongLine() are not used, as vtkStaticCellLocator
 * does not use them.
 *
 * VTK's filters make locators of their own by a prototype's NewInstance(). Here such a locator has
 * the prototype's settings, and shares the structures that the prototype's locators have built as
 * long as the points that they were built of live: a filter that runs again builds nothing where
 * only values have changed. What is compared are modification times of points and cells. (Data sets
 * that are neither vtkUnstructuredGrid nor vtkStructuredGrid are built again whenever they change
 * at all.)
 *
 * After BuildLocator() (or Update()) all queries that are given a vtkGenericCell, and FindCell(x),
 * may be called from any number of threads, each with a cell of its own. Without a build they find
 * nothing; with LazyEvaluation the first query builds, and must be the only one meanwhile. Of the
 * superclasses' other settings UseExistingSearchStructure alone is used.
 *
 * Errors: no data set, an unknown structure name, an axis without direction, cells that do not fit
 * their connectivity: one sentence by vtkErrorMacro, and nothing is found.
 */

#ifndef vtkMoteCylindricalLocator_h
#define vtkMoteCylindricalLocator_h

#include "MoteFiltersHexahedraModule.h" // For export macro
#include "vtkAbstractCellLocator.h"

#include <memory> // For the structures
#include <string> // For names

namespace mote
{
struct LocatorStructure;
class SharedStructures;
} // namespace mote

class MOTEFILTERSHEXAHEDRA_EXPORT vtkMoteCylindricalLocator : public vtkAbstractCellLocator
{
public:
  static vtkMoteCylindricalLocator* New();
  vtkAbstractTypeMacro(vtkMoteCylindricalLocator, vtkAbstractCellLocator);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Which structure to build, by name: "cylgrid" or "cartgrid", two-level grids; "cylbvh" or
   * "cartbvh", hierarchies; "cyl" in (r, theta, h), "cart" in (x, y, z). Default "cylbvh".
   */
  vtkSetMacro(StructureName, std::string);
  vtkGetMacro(StructureName, std::string);
  //@}

  //@{
  /**
   * Whether a cylindrical structure finds its axis from the cells, or takes Origin and Axis.
   * Default on. Answers do not depend on the axis, their speed does.
   */
  vtkSetMacro(FindAxis, bool);
  vtkGetMacro(FindAxis, bool);
  vtkBooleanMacro(FindAxis, bool);
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

  /**
   * Another data set is not searched before BuildLocator().
   */
  void SetDataSet(vtkDataSet* data) override;

  /**
   * When the structure in use was built, as a modification time; 0 where there is none. A
   * BuildLocator() that finds points, cells and settings unchanged leaves it as it is.
   */
  vtkMTimeType GetStructureTime();

  //@{
  /**
   * Cells that can be found, and memory of structure and copied cells in KiB; 0 before a build.
   */
  vtkIdType GetNumberOfCells();
  unsigned long GetActualMemorySize();
  //@}

  using vtkAbstractCellLocator::FindClosestPoint;
  using vtkAbstractCellLocator::FindClosestPointWithinRadius;
  using vtkAbstractCellLocator::IntersectWithLine;

  //@{
  /**
   * The cell that holds `x`, or -1. `cell`, `pcoords` (3) and `weights` (8, and of a polyhedron as
   * many as it has points) may be null; the last two are those of the cell's VTK type.
   */
  vtkIdType FindCell(
    double x[3], double tol2, vtkGenericCell* cell, double pcoords[3], double* weights) override;
  vtkIdType FindCell(double x[3]) override;
  /// What VTK 9.2's filters call, where it overrides; `subId` is 0.
  vtkIdType FindCell(
    double x[3], double tol2, vtkGenericCell* cell, int& subId, double pcoords[3], double* weights);
  //@}

  /**
   * Whether `x` is within the bounds of a cell of the data set; false for a cell that is not there.
   */
  bool InsideCellBounds(double x[3], vtkIdType cellId) override;

  /**
   * The cells that meet a box (xmin, xmax, ymin, ...), in the order of their ids. Some of which
   * only the bounds meet it may be among them.
   */
  void FindCellsWithinBounds(double* bbox, vtkIdList* cells) override;

  /**
   * The cells that the line from p1 to p2 passes, each once, in the order of entry. A line of no
   * length has the cell of its point.
   */
  void FindCellsAlongLine(
    const double p1[3], const double p2[3], double tolerance, vtkIdList* cells) override;

  /**
   * The first face of a cell on the way from p1 to p2: `t` from 0 to 1, the place `x`, and the cell
   * that is entered there or, where the mesh is left, the one that is left, with the place's
   * `pcoords`. 1 if there is one, else 0. `cell` may be null.
   */
  int IntersectWithLine(const double p1[3], const double p2[3], double tol, double& t, double x[3],
    double pcoords[3], int& subId, vtkIdType& cellId, vtkGenericCell* cell) override;

  //@{
  /**
   * The point of a cell that is closest to `x`: `x` itself where a cell holds it, else the least of
   * the distances that VTK's cells tell (EvaluatePosition(); for warped cells not always the very
   * nearest point). cellId is -1 and the function 0 where there is none, or none within `radius`.
   */
  void FindClosestPoint(const double x[3], double closestPoint[3], vtkGenericCell* cell,
    vtkIdType& cellId, int& subId, double& dist2) override;
  vtkIdType FindClosestPointWithinRadius(double x[3], double radius, double closestPoint[3],
    vtkGenericCell* cell, vtkIdType& cellId, int& subId, double& dist2, int& inside) override;
  //@}

  //@{
  /**
   * Whether the first query builds. Default off. VTK 9.2 has functions that do nothing for this.
   */
  void SetLazyEvaluation(vtkTypeBool lazy) override { this->Lazy = lazy; }
  vtkTypeBool GetLazyEvaluation() override { return this->Lazy; }
  void LazyEvaluationOn() override { this->SetLazyEvaluation(1); }
  void LazyEvaluationOff() override { this->SetLazyEvaluation(0); }
  //@}

  //@{
  /**
   * Builds the structure where it is not there yet; see above for what is compared.
   */
  void BuildLocator() override;
  void FreeSearchStructure() override;
  //@}

  /**
   * Lines around what a structure covers: the mesh's bounding box, or the axis and a cylinder about
   * it. The same for every level.
   */
  void GenerateRepresentation(int level, vtkPolyData* pd) override;

protected:
  vtkMoteCylindricalLocator();
  ~vtkMoteCylindricalLocator() override;

  vtkObjectBase* NewInstanceInternal() const override;

private:
  /// Whether there is a structure, built now where that was left to the first query.
  bool IsBuilt();

  vtkMoteCylindricalLocator(const vtkMoteCylindricalLocator&) = delete;
  void operator=(const vtkMoteCylindricalLocator&) = delete;

  std::string StructureName = "cylbvh";
  bool FindAxis = true;
  vtkTypeBool Lazy = 0;
  double Origin[3] = {0.0, 0.0, 0.0};
  double Axis[3] = {0.0, 0.0, 1.0};

  std::shared_ptr<const mote::LocatorStructure> Structure;
  std::shared_ptr<mote::SharedStructures> Shared;
};

#endif
