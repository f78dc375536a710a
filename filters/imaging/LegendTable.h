/**
 * What a lookup table says to a legend.
 */

#ifndef MoteLegendTable_h
#define MoteLegendTable_h

#include "Canvas.h"
#include "LegendLayout.h"
#include "TickValues.h"

#include <string>
#include <vector>

class vtkScalarsToColors;

namespace mote::imaging
{

/// The table's range, or an empty text in `problem` that says why it has none to show.
TickScale scaleOf(vtkScalarsToColors* table, std::string& problem);

/// The colour of a value, opaque.
Color colorOf(vtkScalarsToColors* table, double value);

/// The annotated values of a table with IndexedLookup, in its order.
std::vector<Category> categoriesOf(vtkScalarsToColors* table);

/// Fills in the colours below and above the range, as far as the table uses them.
void addRangeColors(vtkScalarsToColors* table, LegendContent& content);

/// The colour of NaN; nothing where the kind of table has none.
std::optional<Color> nanColorOf(vtkScalarsToColors* table);

} // namespace mote::imaging

#endif
