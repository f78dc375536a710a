#pragma once

#include "Part.h"
#include "base/ProgressRelay.h"
#include "settings/Settings.h"

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace mote::app
{

/// Which particles of a part, or which of its cells, are not hidden: 1 for those, else 0. Those
/// that are cut away are hidden, too: particles by their centres, cells by the mean of their
/// points, where their data say that they are. Of particles the structure must be built, where
/// hidesAny().
std::vector<unsigned char> shownMarks(const Part& part, const Settings& settings);

/// The particles, or cells, with these marks and all their arrays: points and polygons as
/// vtkPolyData, other cells as a vtkUnstructuredGrid. Of particles `withRadii` adds an array
/// "radius", as drawn, where the data have none of that name; the structure must be built for it.
vtkSmartPointer<vtkDataSet> markedData(
  const Part& part, const std::vector<unsigned char>& marks, bool withRadii);

/// Whether the settings hide particles or cells, or cut them away.
bool hidesAny(const Settings& settings);

/// Whether radii are what the settings say, and not just what looks well.
bool givesRadii(const ParticleSettings& settings);

/// Writes a file of the kind that its ending says; see vtkMoteDataWriter. Throws Failure and
/// Interrupted.
void writeData(vtkDataSet* data, const std::string& file, ProgressRelay& progress,
  const std::string& which = {});

} // namespace mote::app
