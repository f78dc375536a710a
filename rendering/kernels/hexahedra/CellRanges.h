#pragma once

#include "HexMesh.h"
#include "HexRay.h"

namespace mote
{

/// A scalar of a mesh's input: component `component` (or ArrayView::magnitude) of values of the
/// input's points or of the input's cells.
struct HexScalar
{
  ArrayView values;
  int component = 0;
  bool ofCells = false;
};

/// The least and greatest value in each cell: of its eight corners, or its own value. A cell with a
/// NaN has the range of all numbers, so that no query passes it over. In parallel. Throws Error
/// where there is another number of values than of points or of the input's cells, or no such
/// component.
RawVector<ScalarRange> cellRanges(const HexMesh& mesh, const HexScalar& scalar);

} // namespace mote
