#ifndef MoteLegacyTime_h
#define MoteLegacyTime_h

#include <optional>
#include <string_view>

namespace mote
{

/// The time that a legacy VTK file tells as field data "TimeValue", double or float, text or
/// binary; VTK's readers do not offer it before they have read the file through. `beginning` are
/// the file's first bytes, which field data come in; nothing if it is not among them, or is no
/// finite number.
std::optional<double> legacyTime(std::string_view beginning);

} // namespace mote

#endif
