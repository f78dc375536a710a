#ifndef MoteTreePositions_h
#define MoteTreePositions_h

#include "kernels/particles/PkdTreeFile.h"

#include "vtkDoubleArray.h"
#include "vtkGenericDataArray.h"

#include <memory>
#include <mutex>
#include <vector>

namespace mote
{

/// The centres of a tree's particles as an array of VTK: three components, worked out when they are
/// asked for. New arrays like it are ordinary ones.
class TreePositions : public vtkGenericDataArray<TreePositions, double>
{
  using Base = vtkGenericDataArray<TreePositions, double>;

public:
  vtkAbstractTypeMacro(TreePositions, Base);
  static TreePositions* New();

  void SetTree(const PkdTree& tree);

  double GetValue(vtkIdType i) const { return this->GetTypedComponent(i / 3, int(i % 3)); }
  double GetTypedComponent(vtkIdType tuple, int component) const
  {
    return this->Tree.center(static_cast<std::size_t>(tuple))[component];
  }
  void GetTypedTuple(vtkIdType i, double* tuple) const
  {
    const Vec3d center = this->Tree.center(static_cast<std::size_t>(i));
    tuple[0] = center.x, tuple[1] = center.y, tuple[2] = center.z;
  }

  ///@{
  /// What lies in a file is not changed.
  void SetValue(vtkIdType, double) {}
  void SetTypedTuple(vtkIdType, const double*) {}
  void SetTypedComponent(vtkIdType, int, double) {}
  ///@}

  /// Copies all when it is first called.
  void* GetVoidPointer(vtkIdType i) override;
  bool HasStandardMemoryLayout() const override { return false; }

protected:
  TreePositions() { this->SetNumberOfComponents(3); }
  ~TreePositions() override = default;

  vtkObjectBase* NewInstanceInternal() const override { return vtkDoubleArray::New(); }
  bool AllocateTuples(vtkIdType tuples) { return tuples == 0; }
  bool ReallocateTuples(vtkIdType) { return false; }

private:
  friend class vtkGenericDataArray<TreePositions, double>;
  TreePositions(const TreePositions&) = delete;
  void operator=(const TreePositions&) = delete;

  PkdTree Tree;
  std::once_flag Copied;
  std::vector<double> Copy;
};

} // namespace mote

#endif
