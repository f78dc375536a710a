#ifndef MoteCollapsedCell_h
#define MoteCollapsedCell_h

#include "GridCells.h"
#include "kernels/hexahedra/FacedCell.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <optional>
#include <vector>

class vtkDataSet;
class vtkIdList;
class vtkUnsignedCharArray;

namespace mote
{

/// A linear cell as a hexahedron in VTK's order: corners of wedges, pyramids and tetrahedra
/// coincide, and those of voxels are put in order. So all have one trilinear map from the unit
/// cube.
struct CollapsedCell
{
  int type = 0; ///< VTK's number
  std::array<vtkIdType, 8> ids{};
  std::array<Vec3d, 8> corners{};

  /// The integrals of the eight trilinear weights over the cell, exact by the 2 x 2 x 2 Gauss rule;
  /// their sum is the volume. All are negative where the cell is inside out.
  std::array<double, 8> cornerVolumes() const;
};

/// The sum of such integrals.
double volumeOf(const std::array<double, 8>& cornerVolumes);

/// The trilinear weights of the corners at a place of the unit cube.
std::array<double, 8> trilinearWeights(const Vec3d& rst);

/// The determinant of the trilinear map's Jacobian there.
double jacobianAt(const CollapsedCell& cell, const Vec3d& rst);

struct CellQuality
{
  /// The least product of the three edges' directions at a corner, 1 for a cube and made 1 for the
  /// regular wedge, pyramid (its base alone) and tetrahedron, too; 0 where an edge has no length.
  double scaledJacobian = 0.0;
  double aspectRatio = 0.0; ///< the longest by the shortest edge; infinite if that has no length
  bool inverted = false;    ///< a corner is inside out; wedges may be listed in both orders
  bool zeroVolume = false;  ///< by the cube of the longest edge below 1e-14
};

CellQuality qualityOf(const CollapsedCell& cell, double volume);

/// Reads cells of a data set one by one. One for every thread; the first is to be made before there
/// are several.
class CellReader
{
public:
  enum class Answer
  {
    Taken,
    InParts,   ///< a polyhedron; see parts()
    OtherType, ///< none of these, or a polyhedron that cannot be cut; see FacedCell
    NonFinite, ///< a corner is not
    Hidden     ///< a ghost or blanked cell
  };

  explicit CellReader(vtkDataSet* data);
  CellReader(const CellReader& other);
  ~CellReader();

  /// Throws Error for a polyhedron with faces or points that are not there; see mismatchOf().
  Answer read(vtkIdType cell, CollapsedCell& into);

  /// What the polyhedron that was read last is cut into. Corners of the number -1 are its middle,
  /// where values are the mean of those of points().
  const std::vector<CollapsedCell>& parts() const { return parts_; }
  const std::vector<std::int64_t>& points() const { return faced_.ids(); }

private:
  Answer readFaces(vtkIdType cell);

  vtkDataSet* data_;
  vtkUnsignedCharArray* ghosts_;
  vtkNew<vtkIdList> ids_;
  std::optional<GridCells> grid_; ///< of a grid with polyhedra
  FacedCell faced_;
  std::vector<CollapsedCell> parts_;
};

} // namespace mote

#endif
