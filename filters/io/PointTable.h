#ifndef MotePointTable_h
#define MotePointTable_h

#include "PointRows.h"

namespace mote
{

/// Reads what is above the first row of a table of points: the names of its columns, what separates
/// its values, and what its first row tells of their types. The cursor stands at the first row
/// then, which is where the rows of the answer begin; how many there are is not counted.
///
/// Throws FileError where there are no columns that can be x and y, and where there is no row.
PointRows readTableHead(TextCursor& cursor);

/// Throws FileError where a file is no text, or readTableHead() does.
void checkPointTable(const std::string& path);

} // namespace mote

#endif
