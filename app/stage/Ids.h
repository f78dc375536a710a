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

/// Gives data sets of particles an array of that name, of 1 for those that --hide-ids and
/// --only-ids leave, else 0; where they have it already, what is 0 stays so.
void addIdMarks(
  const std::vector<NamedData>& data, const SelectionSettings& selection, const std::string& name);

} // namespace mote::app
