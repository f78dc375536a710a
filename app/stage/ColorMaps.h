#pragma once

#include "TypeNames.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkLookupTable;

namespace mote::app
{

/// The names that makeColorMap() knows, the default first; "types", the last, is for few integers.
const std::vector<std::string>& colorMapNames();

/// A table of 256 colours between the ends of `range`, of a map of these names or of a file, see
/// readColorMapFile(). Throws Failure for others.
vtkSmartPointer<vtkLookupTable> makeColorMap(
  const std::string& name, const double range[2], bool logarithmic);

/// Turns the order of the colours round.
void reverse(vtkLookupTable* table);

/// Whether two tables give every value the same colour.
bool areAlike(vtkLookupTable* a, vtkLookupTable* b);

/// How many types have colours of their own: as many as there are elements. Of more than two dozen
/// some are hard to tell apart.
constexpr std::size_t mostTypeColors = 118;

/// The first of these colours, as many as are asked for, but no more than there are. None of them
/// depends on how many there are.
std::vector<Color> typeColors(std::size_t count);

/// For types and a colour for each a table that has an entry for every integer from the least to
/// the greatest.
vtkSmartPointer<vtkLookupTable> makeTypeMap(
  const std::vector<int>& types, const std::vector<Color>& colors);

/// The same colours as a table of names, for legends: ascending. Types without a name have their
/// number.
vtkSmartPointer<vtkLookupTable> makeTypeLegend(
  const std::vector<int>& types, const std::vector<Color>& colors, const TypeNames& names);

} // namespace mote::app
