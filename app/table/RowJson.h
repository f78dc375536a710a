#pragma once

#include "Row.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace mote::app
{

// Settings as JSON: what sessions and recordings share.

using Json = nlohmann::ordered_json;

/// Words of a row as JSON: numbers, true and false, a text, or a list of them; files as a JSON file
/// at `path` names them.
Json jsonOf(const Row& row, const std::vector<std::string>& words, const std::string& path);

/// What JSON says of a row as words of its set(): of several values joined by commas, too, as on
/// the command line. Throws WrongValue for what is no value.
std::vector<std::string> givenWords(const Row& row, const Json& value);

/// The group of a row as JSON names it: "Colour" is "colour"; of a command's row the command.
std::string groupName(const Row& row);

/// The values of one group of a JSON file at `path`, for those rows of a table that it names.
/// `place` is where they stand, for messages. Throws Failure for a group or name that the table
/// does not have, and for wrong values.
NamedValues groupOf(const std::string& group, const Json& values, const std::vector<Row>& table,
  const std::string& path, const std::string& place);

/// A file as a JSON file at `path` names it: relative where it lies in its folder or below.
std::string storedName(const std::string& file, const std::string& path);
/// The other way; what is not found at an absolute place is looked for beside `path`. Throws
/// Failure where it is at neither, which says that `setting` is to be corrected.
std::string foundName(
  const std::string& stored, const std::string& path, const std::string& setting = "files");

/// What is wrong with a text that is no JSON.
std::string sentenceOf(const std::exception& error);

} // namespace mote::app
