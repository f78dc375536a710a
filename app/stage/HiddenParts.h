#pragma once

#include "Input.h"
#include "settings/Settings.h"

#include <string>
#include <vector>

namespace mote::app
{

/// What a data set is called where it is hidden by name: its block, or the file.
const std::string& partName(const NamedData& one);

/// Whether a pattern, in which each * stands for any letters, is a data set's name, what stands
/// behind the last / in it, or file and name, as in "case.foam: inlet".
bool isNamed(const NamedData& one, const std::string& pattern);

/// Which data sets --hide-data, --hide-part and --show-part hide, and which boundaries are hidden
/// because nothing asks for them.
std::vector<bool> hiddenParts(
  const std::vector<NamedData>& data, const SelectionSettings& selection);

/// Those that are not hidden.
std::vector<NamedData> shownParts(
  const std::vector<NamedData>& data, const SelectionSettings& selection);

/// Other settings that hide or show the data set with this index, and change no other.
SelectionSettings withPart(const SelectionSettings& selection, const std::vector<NamedData>& data,
  std::size_t index, bool isShown);

/// The other settings, but with the parts that `parts` hides and shows.
SelectionSettings withPartsOf(const SelectionSettings& parts, SelectionSettings other);

/// A sentence that names the boundaries that are hidden where nobody has chosen yet; else nothing.
std::string hiddenBoundaries(
  const std::vector<NamedData>& data, const SelectionSettings& selection);

} // namespace mote::app
