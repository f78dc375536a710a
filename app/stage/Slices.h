#pragma once

#include "settings/Settings.h"

#include <vtkMoteSlice.h>
#include <vtkSmartPointer.h>

#include <vector>

class vtkLinearTransform;

namespace mote::app
{

/// More are refused.
constexpr std::size_t mostSlices = 32;

/// The slices that --slice asks for, about the axis of --cut-axis, in the order of the settings.
/// `length` is the size of the data.
std::vector<vtkSmartPointer<vtkMoteSlice>> slicesOf(const Settings& settings, double length);

/// Moves slices with what they lie in.
void moveSlices(
  const std::vector<vtkSmartPointer<vtkMoteSlice>>& slices, vtkLinearTransform* moved);

} // namespace mote::app
