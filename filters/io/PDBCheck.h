#ifndef MotePDBCheck_h
#define MotePDBCheck_h

#include <string>

namespace mote
{

/// Throws FileError where a Protein Data Bank file has been cut short or has an atom without
/// coordinates, of which vtkPDBReader says nothing. Looks at the records up to END.
///
/// END itself is not asked for: many programs leave it out. A file cut exactly at a line's end is
/// therefore only noticed if it has fewer atoms than its MASTER record counts.
void checkPDBIsWhole(const std::string& path);

} // namespace mote

#endif
