#pragma once

#include "kernels/core/ClipRegion.h"

#include "vtkMoteClipCylinder.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

class vtkAbstractMapper;
class vtkPointSet;

namespace mote
{

/// Where in the world a mapper shows its data: its clipping planes, and a cylinder's piece.
class MapperClip
{
public:
  /// Returns whether it is another one; null for none.
  bool set(vtkMoteClipCylinder* cylinder);
  vtkMoteClipCylinder* cylinder() const { return cylinder_; }

  /// Planes and cylinders without a direction leave all.
  ClipRegion region(vtkAbstractMapper* mapper) const;
  /// Likewise, for an input that may have flat faces in the planes: with a tolerance of as much as
  /// its coordinates and hits on it are rounded.
  ClipRegion region(vtkAbstractMapper* mapper, vtkPointSet& input, const Mat4d& toWorld) const;
  /// When any of it changed last.
  vtkMTimeType time(vtkAbstractMapper* mapper) const;

private:
  vtkSmartPointer<vtkMoteClipCylinder> cylinder_;
};

} // namespace mote
