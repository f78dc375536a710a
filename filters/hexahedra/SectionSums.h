#ifndef MoteSectionSums_h
#define MoteSectionSums_h

#include "data/DataArrayView.h"
#include "kernels/hexahedra/SurfaceIntegral.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkDataSet;
class vtkPolyData;

namespace mote
{

/// A named array of a data set, or none where it lacks it.
struct IntegratedArray
{
  std::string name;
  DataArrayView values;
  bool ofCells = false;
  std::vector<std::string> columns; ///< a name for each component

  /// Finds it among the arrays of points, then of cells.
  static IntegratedArray of(vtkDataSet* data, const std::string& name);
  bool isThere() const { return !values.view.empty(); }
  int components() const { return static_cast<int>(columns.size()); }
};

/// What is integrated over a section.
struct SectionTask
{
  std::vector<std::string> arrays;
  std::string velocity, pressure; ///< empty for none
  double density = 1.0;
  double pressureFactor = 1.0;            ///< to the true pressure
  Vec3d origin{0.0}, axis{0.0, 0.0, 1.0}; ///< of torques; of unit length
  double tolerance = 1e-7;
};

/// A section: a slice, or the boundary.
struct Section
{
  std::string name;
  std::optional<SliceShape> slice; ///< none: the boundary
};

/// Sums over a section, in this order: the area; with a velocity the flow; for each component of
/// each array its integral and, with a velocity, that times the flow; with a pressure the torque;
/// with both the total pressure times the flow; with a velocity the flow either way, and the speed.
class SectionSums
{
public:
  /// The grid's cells and arrays, ready for sections. `columns` are names of the components of all
  /// arrays; those that the data lack are NaN. Of a grid the boundary is that of its cells; of a
  /// vtkPolyData it is its polygons, with normals by the right-hand rule, each as triangles to its
  /// middle, and there are no slices. Cells that are hidden or another's, by the array of ghosts,
  /// do not count.
  SectionSums(vtkDataSet* data, const SectionTask& task, const std::vector<std::string>& columns);

  SurfaceIntegrals of(const Section& section) const;

private:
  double valueAt(const IntegratedArray& array, int component, const SurfacePoint& at) const;
  /// Writes what is integrated; valueOf(array, component) is the value there.
  template <typename ValueOf>
  void fill(const Vec3d& place, const Vec3d& normal, const ValueOf& valueOf, double* values) const;
  /// The same of the sizes of what it is made of, whichever way it goes.
  template <typename ValueOf>
  void fillSizes(const Vec3d& place, const ValueOf& valueOf, double* values) const;
  SurfaceIntegrals ofPolygons() const;

  const SectionTask& task_;
  vtkPolyData* polygons_ = nullptr; ///< in place of a mesh
  HexMesh mesh_;
  std::shared_ptr<const HiddenCells> hidden_; ///< null: none
  FaceAdjacency adjacency_;
  struct Component
  {
    std::size_t array; ///< of arrays_
    int number;
  };
  std::vector<IntegratedArray> arrays_;
  std::vector<Component> columns_;
  IntegratedArray velocity_, pressure_;
  int count_ = 0;
};

} // namespace mote

#endif
