#pragma once

#include "kernels/shading/ColorMap.h"

class vtkScalarsToColors;

namespace mote
{

/// The kernels' form of a VTK lookup table or transfer function. vtkLookupTable is taken entry by
/// entry; functions are sampled finely enough (4096 entries) for 8-bit colours, so that only steps
/// within them are blurred, to a 4096th of the range. False where a table
/// over one range cannot say it: indexed lookup, logarithms over a range that is not positive.
bool toColorMap(vtkScalarsToColors* colors, ColorMap& map);

} // namespace mote
