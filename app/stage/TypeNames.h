#pragma once

#include "Arrays.h"
#include "settings/Settings.h"

#include <map>
#include <string>
#include <vector>

namespace mote::app
{

/// Names of types, by their numbers.
using TypeNames = std::map<int, std::string>;

/// What the data call the types of an array: by an array of words beside it (element, typelabel,
/// species), by what a reader noted, or as elements where the numbers are those of the periodic
/// table. Empty where they have no names.
TypeNames typeNamesOf(vtkDataSet* data, const ArrayChoice& types);

/// A colour for each of these types, as chemists have them, where they are named after elements by
/// their symbols. Those with other names, or none, among elements have colours of the map of types.
/// None at all where no type is an element.
std::vector<Color> elementColors(const std::vector<int>& types, const TypeNames& names);

} // namespace mote::app
