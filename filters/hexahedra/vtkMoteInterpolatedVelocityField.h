/**
 * @class   vtkMoteInterpolatedVelocityField
 * @brief   a velocity field for vtkStreamTracer that finds cells by Mote's structures
 *
 * Give one to vtkStreamTracer::SetInterpolatorPrototype(): streamlines then are found several times
 * as fast as by VTK's own fields (docs/hexahedra.md has figures). Data sets may be of any kind;
 * those of several inputs are asked one after the other, beginning with the last that held a point.
 * Hexahedra, voxels, wedges, pyramids, tetrahedra and polyhedra are found, as by
 * vtkMoteCylindricalLocator, and velocities within them are interpolated by VTK's weights; those of
 * cells are constant in each.
 *
 * What is built of points and cells is shared between a prototype and all that vtkStreamTracer
 * makes of it, as long as the points live: other seeds, or other values, build nothing. Fields that
 * share it may be used by several threads, one field each, once AddDataSet() was called for each
 * data set in one of them.
 *
 * Errors: an unknown structure name, cells that do not fit their connectivity: one sentence by
 * vtkErrorMacro, and the velocity is known nowhere in that data set.
 */

#ifndef vtkMoteInterpolatedVelocityField_h
#define vtkMoteInterpolatedVelocityField_h

#include "MoteFiltersHexahedraModule.h" // For export macro
#include "vtkCompositeInterpolatedVelocityField.h"
#include "vtkVersionMacros.h" // For the interface

#include <memory> // For the structures
#include <string> // For names
#include <vector>

namespace mote
{
class FlowInCells;
class SharedStructures;
} // namespace mote

class MOTEFILTERSHEXAHEDRA_EXPORT vtkMoteInterpolatedVelocityField
  : public vtkCompositeInterpolatedVelocityField
{
public:
  static vtkMoteInterpolatedVelocityField* New();
  vtkTypeMacro(vtkMoteInterpolatedVelocityField, vtkCompositeInterpolatedVelocityField);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Which structure finds cells, see vtkMoteCylindricalLocator. Default "cartbvh".
   */
  vtkSetMacro(StructureName, std::string);
  vtkGetMacro(StructureName, std::string);
  //@}

  /**
   * One more data set. It must live as long as the field is used.
   */
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
  void AddDataSet(vtkDataSet* dataset) override;
#else
  void AddDataSet(vtkDataSet* dataset, size_t maxCellSize = 0) override;

  /**
   * Of VTK 9.2: no locators of VTK's are built.
   */
  void Initialize(vtkCompositeDataSet* data, int strategy = INITIALIZE_ALL_DATASETS) override;
#endif

  using Superclass::FunctionValues;
  /**
   * The velocity at a point of three coordinates. 0 where no cell holds it.
   */
  int FunctionValues(double* x, double* f) override;

  void SetLastCellId(vtkIdType cell, int dataSet) override;
  void SetLastCellId(vtkIdType cell) override
  {
    this->Superclass::SetLastCellId(cell);
  }

  void CopyParameters(vtkAbstractInterpolatedVelocityField* from) override;

protected:
  vtkMoteInterpolatedVelocityField();
  ~vtkMoteInterpolatedVelocityField() override;

private:
  friend class vtkMoteStreamlines;

  vtkMoteInterpolatedVelocityField(const vtkMoteInterpolatedVelocityField&) = delete;
  void operator=(const vtkMoteInterpolatedVelocityField&) = delete;

  void TakeDataSet(vtkDataSet* dataset);
  void EnterCell(vtkDataSet* dataset, vtkIdType cell);
  bool TakeFrom(int dataSet, double* x, double* f);

  std::string StructureName = "cartbvh";
  std::shared_ptr<mote::SharedStructures> Shared;
  std::vector<std::unique_ptr<mote::FlowInCells>> Flows; ///< one for each of DataSets
};

#endif
