#ifndef MoteSourcePositions_h
#define MoteSourcePositions_h

#include "kernels/particles/ParticleSource.h"

#include "vtkDoubleArray.h"
#include "vtkGenericDataArray.h"

#include <memory>
#include <mutex>
#include <vector>

namespace mote
{

/// The centres of a source's particles as an array of VTK: three components, worked out when they
/// are asked for. New arrays like it are ordinary ones.
class SourcePositions : public vtkGenericDataArray<SourcePositions, double>
{
  using Base = vtkGenericDataArray<SourcePositions, double>;

public:
  vtkAbstractTypeMacro(SourcePositions, Base);
  static SourcePositions* New();

  /// Null for no particles.
  void SetSource(std::shared_ptr<const ParticleSource> source);
  const std::shared_ptr<const ParticleSource>& GetSource() const { return this->Source; }

  double GetValue(vtkIdType i) const { return this->GetTypedComponent(i / 3, int(i % 3)); }
  double GetTypedComponent(vtkIdType tuple, int component) const
  {
    return this->At(tuple)[component];
  }
  void GetTypedTuple(vtkIdType i, double* tuple) const
  {
    const Vec3d center = this->At(i);
    tuple[0] = center.x, tuple[1] = center.y, tuple[2] = center.z;
  }

  //@{
  /// What nobody holds is not changed.
  void SetValue(vtkIdType, double) {}
  void SetTypedTuple(vtkIdType, const double*) {}
  void SetTypedComponent(vtkIdType, int, double) {}
  //@}

  /// Copies all when it is first called.
  void* GetVoidPointer(vtkIdType i) override;
  bool HasStandardMemoryLayout() const override { return false; }

protected:
  SourcePositions() { this->SetNumberOfComponents(3); }
  ~SourcePositions() override = default;

  vtkObjectBase* NewInstanceInternal() const override { return vtkDoubleArray::New(); }
  bool AllocateTuples(vtkIdType tuples) { return tuples == 0; }
  bool ReallocateTuples(vtkIdType) { return false; }

private:
  friend class vtkGenericDataArray<SourcePositions, double>;
  SourcePositions(const SourcePositions&) = delete;
  void operator=(const SourcePositions&) = delete;

  Vec3d At(vtkIdType i) const
  {
    Vec3d center;
    this->Source->positions(static_cast<std::size_t>(i), static_cast<std::size_t>(i) + 1, &center);
    return center;
  }

  std::shared_ptr<const ParticleSource> Source;
  std::once_flag Copied;
  std::vector<double> Copy;
};

} // namespace mote

#endif
