#ifndef MotePumpInput_h
#define MotePumpInput_h

#include "ReaderFormats.h"

namespace mote
{

/// The format of pump:SCALE[:PART], which stands where a file's name may; null for all other names.
/// Throws FileError for a wrong scale or part.
const ReaderFormat* pumpFormat(const std::string& name);

} // namespace mote

#endif
