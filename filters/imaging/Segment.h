/**
 * Segments in the plane, for lines that are drawn into images.
 */

#ifndef MoteSegment_h
#define MoteSegment_h

#include "Canvas.h"

namespace mote::imaging
{

/// Pixels that a line between two points may touch, so far beside it.
Rect rectAround(const double a[2], const double b[2], double beside);

/// Place along a segment, from 0 to 1, of its point that is nearest.
double nearestShare(const double a[2], const double b[2], double x, double y);

/// How far a point is from a segment.
double distanceTo(const double a[2], const double b[2], double x, double y);

/// The part of a segment that lies in the rectangle; false where there is none.
bool clipped(const double from[2], const double to[2], const Rect& rect, double a[2], double b[2]);

} // namespace mote::imaging

#endif
