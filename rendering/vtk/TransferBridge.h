#pragma once

#include "kernels/shading/TransferFunction.h"

#include <string>

class vtkVolumeProperty;

namespace mote
{

/// The colours and opacities of a volume's property, those of its component 0, as the kernels take
/// them: a knot at each node of either function. Where a function is not linear between its nodes
/// (midpoints and sharpness, colour spaces other than RGB, logarithms, colours in steps) there are
/// more, so that colours err by less than 1/1000 and opacities by less than 1/10000. Jumps are kept
/// as jumps.
TransferFunction transferOf(vtkVolumeProperty* property);

/// What of the property has no effect, as a sentence with a space behind; empty where all has.
std::string unusedOf(vtkVolumeProperty* property);

} // namespace mote
