#ifndef MoteCollapsedCell_h
#define MoteCollapsedCell_h

#include "kernels/core/Vec.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>

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
    OtherType, ///< no hexahedron, voxel, wedge, pyramid or tetrahedron
    NonFinite, ///< a corner is not
    Hidden     ///< a ghost or blanked cell
  };

  explicit CellReader(vtkDataSet* data);
  CellReader(const CellReader& other);
  ~CellReader();

  Answer read(vtkIdType cell, CollapsedCell& into);

private:
  vtkDataSet* data_;
  vtkUnsignedCharArray* ghosts_;
  vtkNew<vtkIdList> ids_;
};

} // namespace mote

#endif
