#pragma once

#include "../Suite.h"

#include <kernels/hexahedra/CylinderAxis.h>
#include <kernels/hexahedra/HexField.h>

#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <memory>
#include <optional>
#include <string>

namespace mote::bench
{

/// A mesh with a scalar to measure on.
struct HexInput
{
  std::string name;   ///< as it was specified
  std::string scalar; ///< what the input calls it
  bool ofCells = false;
  /// The input's points and cells, and nothing else but the scalar: one component in double.
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  std::shared_ptr<const HexMesh> mesh;
  std::shared_ptr<const HexField> field;
  /// Of the input's field arrays AxisOrigin and AxisDirection, which the pump has.
  std::optional<CylinderAxis> axis;

  /// The scalar as a field is made of it.
  HexScalar hexScalar() const;
};

/// Makes or reads what the specification says: pump:SCALE:PART or a file with one unstructured
/// grid. Throws Error, also where there is no scalar or no cell that Mote can take.
HexInput makeHexInput(const std::string& specification);

/// The three parts of pump:SCALE, or the specification alone where it is something else.
std::vector<std::string> partsOf(const std::string& specification);

/// The forms of specifications, for --help.
std::vector<Named> hexInputs();

} // namespace mote::bench
