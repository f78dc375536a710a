#pragma once

#include "ParticleInput.h"

#include "kernels/core/ContentHash.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkUnsignedCharArray.h"

namespace mote
{

/// Which cells of its input a mapper was told to show: one value a cell, 0 hides it.
class VisibleCells
{
public:
  /// Returns whether it is another array.
  bool set(vtkUnsignedCharArray* isVisible);
  vtkUnsignedCharArray* get() const { return isVisible_; } ///< null: all
  vtkMTimeType time() const { return isVisible_ ? isVisible_->GetMTime() : 0; }

  /// Tells contents apart; empty for all. Throws Error where there is not one value for each of so
  /// many cells.
  const InputKey& key(vtkIdType cells);

private:
  vtkSmartPointer<vtkUnsignedCharArray> isVisible_;
  vtkMTimeType seen_ = 0;
  InputKey key_;
};

} // namespace mote
