#ifndef MoteLocatorStructure_h
#define MoteLocatorStructure_h

#include "kernels/hexahedra/HexStructure.h"

#include "vtkObject.h"
#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

class vtkDataSet;

namespace mote
{

/// A structure over a data set's cells, and what it was made from.
struct LocatorStructure
{
  /// Equal while points, cells and settings are the same. Every change of a VTK object has a
  /// modification time of its own, so that the times of the objects that make up the geometry name
  /// it.
  using Key = std::vector<std::uint64_t>;

  /// Reads the data set, in the end in parallel. Throws Error where its arrays do not fit together
  /// or the axis has no direction.
  LocatorStructure(vtkDataSet* data, const HexStructureOptions& options);

  static Key keyOf(vtkDataSet* data, const HexStructureOptions& options);

  Key key;
  vtkWeakPointer<vtkObject> geometry; ///< an object without which nobody can ask for the key again
  std::shared_ptr<const HexMesh> mesh;
  std::shared_ptr<const HexStructure> structure;
  std::optional<CylinderAxis> axis; ///< given or found; none for a Cartesian structure
  vtkTimeStamp built;

  /// The cell that holds `p`; where none does, the one outside of which `p` lies least, by no more
  /// than VTK's cells allow in their own coordinates, 1e-6 for hexahedra and 1e-3 for others; or
  /// HexMesh::noCell. May be called from any number of threads.
  std::uint32_t cellAt(const Vec3d& p) const;
};

/// The structure of a name of hexStructureNames(). Throws Error for another one.
HexStructureKind structureKindNamed(const std::string& name);

/// Structures that locators made from one prototype share. Those whose geometry is gone are
/// dropped when one is asked for.
class SharedStructures
{
public:
  /// The structure of the key, or a new one. From any thread; a structure is built once.
  std::shared_ptr<const LocatorStructure> get(vtkDataSet* data, const HexStructureOptions& options);
  void drop(const LocatorStructure* structure);

private:
  std::mutex mutex_;
  std::vector<std::shared_ptr<const LocatorStructure>> all_;
};

} // namespace mote

#endif
