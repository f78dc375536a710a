#pragma once

#include "settings/Settings.h"

#include <string>

namespace mote::app
{

/// Whether a file name is that of a session: it ends in .json.
bool isSessionFile(const std::string& path);

/// Settings as the text of a session that will lie at `path`: JSON, with data files relative to it
/// where they lie in its folder or below.
std::string sessionText(const Settings& settings, const std::string& path);

/// The settings that a session's text holds; what it leaves out keeps its default. `path` is where
/// it lies: relative names of data files start from there, and what is not found at an absolute
/// place is looked for beside the session. Throws Failure with a sentence that names the place for
/// what is no session, an unknown entry, a wrong value, a later version, or a missing data file.
Settings parseSession(const std::string& text, const std::string& path);

/// The same for a file. Throws Failure.
Settings readSession(const std::string& path);
void writeSession(const Settings& settings, const std::string& path);

/// Throws Failure where the session that the settings ask for would not be one, would take the
/// place of what is read, or cannot be written; before any work is done.
void checkSessionOutput(const Settings& settings);

} // namespace mote::app
