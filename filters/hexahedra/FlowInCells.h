#ifndef MoteFlowInCells_h
#define MoteFlowInCells_h

#include "DataArrayView.h"
#include "LocatorStructure.h"

#include "kernels/core/Box.h"
#include "kernels/hexahedra/TrilinearCell.h"

#include <array>
#include <memory>
#include <optional>

class vtkDataArray;
class vtkDataSet;
class vtkGenericCell;
class vtkUnsignedCharArray;

namespace mote
{

/// Where a data set stands in the world: by its field array "Placement", if it has one, 16 numbers
/// of a matrix row by row, which turns and moves.
Mat4d placementOf(vtkDataSet* data);

/// Turns a vector with a data set that is placed so.
Vec3d turnedVector(const Mat4d& placement, const Vec3d& vector);

/// The velocity in the cells of one data set, at points that follow one another: cells that held
/// the last ones are asked first, and what was read of them is kept. Points and velocities are in
/// the world, see placementOf(). Cells that the ghost array hides are not found. For one thread.
class FlowInCells
{
public:
  FlowInCells(vtkDataSet* data, std::shared_ptr<const LocatorStructure> structure);

  vtkDataSet* data() const { return data_; }

  /// The vectors that are meant from now on, of points or of cells; null for none.
  void select(vtkDataArray* vectors, bool ofCells);

  /// Finds the cell at a point; false for none. All below is about that.
  bool find(const Vec3d& inWorld);
  void velocity(double f[3]) const;
  /// The data set's number of the cell; its own number where parts of a polyhedron make it up.
  vtkIdType cell() const { return entered_[last_].inputCell; }
  /// VTK's coordinates in the cell, which `cell` holds, and the weights of its points.
  void weights(vtkGenericCell* cell, double pcoords[3], double* weights) const;

private:
  /// A cell that held a point.
  struct Entered
  {
    std::uint32_t cell = HexMesh::noCell; ///< of the mesh
    vtkIdType inputCell = -1;
    Box box;
    std::optional<TrilinearCell> shape;
    std::array<Vec3d, 8> velocities{}; ///< of the corners
    Vec3d rst{0.5};
  };

  void enter(std::uint32_t cell, Entered& entered) const;
  bool isHeld(Entered& entered, const Vec3d& p) const;

  vtkDataSet* data_;
  Mat4d toWorld_, toData_;
  vtkUnsignedCharArray* ghosts_; ///< of the data set; null: none is hidden
  std::shared_ptr<const LocatorStructure> structure_;
  vtkDataArray* selected_ = nullptr;
  DataArrayView vectors_;
  bool ofCells_ = false;

  /// Steps of an integrator go back and forth between a few.
  std::array<Entered, 8> entered_;
  std::size_t last_ = 0; ///< that held a point
  std::size_t next_ = 0; ///< to be replaced
  Vec3d p_{0.0};
  CornerValues shares_{}; ///< of the corners
};

} // namespace mote

#endif
