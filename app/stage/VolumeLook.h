#pragma once

#include "settings/Settings.h"

#include <optional>
#include <vector>

class vtkUnstructuredGrid;

namespace mote::app
{

/// The slice across x, y or z that shows about the most of these volumes: along the axis of the
/// cuts where there is most, else as near to the middle as what it shows allows. None where there
/// is nothing.
std::optional<ShowRange> fullestSlice(
  const std::vector<vtkUnstructuredGrid*>& volumes, const std::vector<double>& cutAxis = {});

/// The settings of volumes with what the user left open chosen: whether the cloud is seen, walls
/// and slices. Without a cloud walls are shown, those towards the eye left out so that one looks
/// in; and what is cut open shows the cells that the cuts go through, or else there is this slice.
/// Where a selection `hidesCells`, the others are shown from outside, in the colours of the data.
VolumeSettings lookInForce(
  const Settings& settings, const ShowRange& slice, bool hidesCells = false);

/// Bounds with those of all copies around the axis; what is not initialized stays so.
void addRepetitions(const Settings& settings, double bounds[6]);

} // namespace mote::app
