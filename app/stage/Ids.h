#pragma once

#include "Input.h"
#include "settings/Settings.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSet;

namespace mote::app
{

/// The array that names particles through time, such as "id"; null where there is none: then their
/// numbers in the data set do, from 0.
vtkDataArray* idArrayOf(vtkDataSet* data);

/// The id of a particle.
std::int64_t idOf(vtkDataArray* ids, vtkIdType particle);

/// Gives data sets an array of that name, of 1 for the particles and cells that --hide-ids and
/// --only-ids leave, else 0; where they have it already, what is 0 stays so. Cells count from 0.
/// Ids of cells alone leave particles as they are, and ids of particles cells: those have no such
/// array then.
void addIdMarks(
  const std::vector<NamedData>& data, const SelectionSettings& selection, const std::string& name);

} // namespace mote::app
