#pragma once

class vtkPolyData;

namespace mote
{

/// The typical distance of neighbours, on whichever ranks these are; ghosts do not count. All ranks
/// must ask together; a null pointer stands for no particles.
double commonSpacingOf(vtkPolyData* particles);

/// Writes down a spacing, to be asked for by keptSpacingOf() when the particles lie in another
/// order: the spacing is that of a few of them, so that it may differ a little then.
void keepSpacing(double spacing, vtkPolyData* particles);

/// The one written down; 0 where none is.
double keptSpacingOf(vtkPolyData* particles);

} // namespace mote
