#pragma once

#include "kernels/scene/Surface.h"

#include "vtkMoteSlice.h"
#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"

#include <array>
#include <vector>

namespace mote
{

/// The slices of a mapper, in their order.
class MapperSlices
{
public:
  /// Null is not added.
  void add(vtkMoteSlice* slice);
  void clear();
  int count() const { return static_cast<int>(slices_.size()); }
  /// Null where there is none of this number.
  vtkMoteSlice* slice(int number) const;

  void addRange(double low, double high);
  void clearRanges();
  const std::vector<std::array<double, 2>>& ranges() const { return ranges_; }

  /// In the coordinates of data that are drawn turned.
  std::vector<SliceShape> shapes(const Mat4d& turn = Mat4d(1.0)) const;
  /// When any of them changed last, or which there are.
  vtkMTimeType time() const;

private:
  std::vector<vtkSmartPointer<vtkMoteSlice>> slices_;
  std::vector<std::array<double, 2>> ranges_;
  vtkTimeStamp changedAt_;
};

} // namespace mote
