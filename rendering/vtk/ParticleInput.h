#pragma once

#include "DataArrayView.h"

#include "kernels/particles/ParticleSet.h"

#include <map>
#include <string>
#include <vector>

class vtkPointSet;

namespace mote
{

/// How vtkMoteParticleMapper was asked to choose radii; `mode` is one of its RadiusModes.
struct RadiusChoice
{
  int mode = 0;
  double radius = 0.5;
  double scale = 1.0;
  std::string radiusArray;
  std::string typeArray;
  std::map<int, double> typeRadii;
};

/// A vtkPointSet as the kernels see it. The views hold while this object lives.
struct ParticleInput
{
  ParticleSet set;
  DataArrayView positions;
  DataArrayView radii;
  std::vector<double> typeRadii; ///< a particle each, in RADIUS_BY_TYPE mode
  double commonRadius = 0.0;     ///< 0 where radii differ
};

/// Array of the points that holds the radii under `choice`, or null for none; with half = true
/// where it holds diameters. Throws Error where the choice names an array that is missing or unfit.
vtkDataArray* findRadiusArray(vtkPointSet* points, const RadiusChoice& choice, bool& half);

/// Looks up radii as `choice` says. Throws Error as findRadiusArray() does.
ParticleInput makeParticleInput(vtkPointSet* points, const RadiusChoice& choice);

} // namespace mote
