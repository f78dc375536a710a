#include "RowJson.h"

#include "base/Failure.h"
#include "base/Text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

namespace mote::app
{

namespace
{

namespace fs = std::filesystem;

/// A word of a row as JSON.
Json jsonOfWord(const Row& row, const std::string& word)
{
  double number = 0.0;
  if (row.numeric && parseNumber(word, number))
    // Whole numbers without a point, as far as doubles hold them exactly.
    return number == std::floor(number) && std::abs(number) < 9007199254740992.0
             ? Json(static_cast<std::int64_t>(number))
             : Json(number);
  return word;
}

/// A value of JSON as a word. Throws WrongValue for what is none.
std::string wordOf(const Json& value)
{
  if (value.is_string())
    return value.get<std::string>();
  if (value.is_boolean())
    return value.get<bool>() ? "true" : "false";
  if (value.is_number())
    return value.is_number_float() ? exactText(value.get<double>()) : value.dump();
  throw WrongValue{
    std::string("must be a text, a number or true or false, not ") + value.type_name()};
}

std::vector<std::string> wordsOf(const Row& row, const Json& value)
{
  if (value.is_null() && !row.get(Settings{}).empty() && row.shape != Shape::Many)
    throw WrongValue{"must not be null"};
  if (value.is_null())
    return {};
  if (!value.is_array())
    return {wordOf(value)};
  if (row.shape != Shape::Many)
    throw WrongValue{"takes one value, not a list"};
  std::vector<std::string> words;
  for (const Json& one : value)
    words.push_back(wordOf(one));
  return words;
}

bool isFile(const Row& row, const std::string& word)
{
  return row.namesFile && !word.empty() &&
         std::find(row.offers.begin(), row.offers.end(), word) == row.offers.end();
}

/// A file's name, and what is named in it, from the colon on.
std::pair<std::string, std::string> fileAndRest(const std::string& word, const fs::path& folder)
{
  std::error_code error;
  const std::size_t colon = word.rfind(':');
  if (colon == word.npos || fs::exists(folder / word, error))
    return {word, ""};
  return {word.substr(0, colon), word.substr(colon)};
}

} // namespace

Json jsonOf(const Row& row, const std::vector<std::string>& words, const std::string& path)
{
  if (row.shape == Shape::Flag)
    return words.front() == "true";
  if (!words.empty() && isFile(row, words.front()))
  {
    const auto [file, rest] = fileAndRest(words.front(), "");
    return storedName(file, path) + rest;
  }
  if (row.shape != Shape::Many)
    return words.empty() ? Json() : jsonOfWord(row, words.front());
  Json list = Json::array();
  for (const std::string& word : words)
    list.push_back(jsonOfWord(row, word));
  return list;
}

std::vector<std::string> givenWords(const Row& row, const Json& value)
{
  if (row.shape == Shape::OptionalOne && value.is_boolean())
    return {value.get<bool>() ? "on" : "off"};
  if (row.shape != Shape::Many || !row.commas || !value.is_string())
    return wordsOf(row, value);
  std::vector<std::string> words;
  std::istringstream text(value.get<std::string>());
  for (std::string word; std::getline(text, word, ',');)
    words.push_back(word);
  return words;
}

std::string groupName(const Row& row)
{
  return row.command.empty() ? lowerCase(row.group) : row.command;
}

NamedValues groupOf(const std::string& group, const Json& values, const std::vector<Row>& table,
  const std::string& path, const std::string& place)
{
  if (std::none_of(
        table.begin(), table.end(), [&](const Row& row) { return groupName(row) == group; }))
    throw Failure(
      place + ": " + group + " is no group of settings that this version of mote knows");
  if (!values.is_object())
    throw Failure(
      place + ": " + group + ": must be an object with a name and value for each choice");
  NamedValues named;
  Settings scratch;
  for (const auto& [name, value] : values.items())
  {
    const auto row = std::find_if(table.begin(), table.end(),
      [&, &wanted = name](const Row& r) { return r.name == wanted && groupName(r) == group; });
    if (row == table.end())
      throw Failure(place + ": " + group + "/" + name +
                    " is no setting that this version of mote "
                    "knows");
    try
    {
      named.emplace_back(&*row, wordsOf(*row, value));
      for (std::string& word : named.back().second)
        // Other words say themselves what they should be.
        if (isFile(*row, word) && word.find_first_of("./:") != word.npos)
        {
          const auto [file, rest] = fileAndRest(word, fs::path(path).parent_path());
          word = foundName(file, path, name) + rest;
        }
      row->set(scratch, named.back().second);
    }
    catch (const WrongValue& wrong)
    {
      throw Failure(place + ": " + group + "/" + name + ": " + wrong.sentence);
    }
  }
  return named;
}

std::string storedName(const std::string& file, const std::string& path)
{
  std::error_code error;
  if (!fs::exists(file, error))
    return file; // of what is generated: pump:0.02
  const fs::path folder = fs::absolute(path, error).lexically_normal().parent_path();
  const fs::path whole = fs::absolute(file, error).lexically_normal();
  const fs::path relative = whole.lexically_relative(folder);
  return relative.empty() || *relative.begin() == ".." ? whole.string() : relative.string();
}

std::string foundName(
  const std::string& stored, const std::string& path, const std::string& setting)
{
  std::error_code error;
  const fs::path folder = fs::path(path).parent_path();
  const fs::path named = folder / stored; // `stored` alone where that is absolute
  if (fs::exists(named, error))
    return named.string();
  if (const fs::path beside = folder / fs::path(stored).filename(); fs::exists(beside, error))
    return beside.string();
  if (stored.find(':') != std::string::npos && stored.find('/') == std::string::npos)
    return stored;
  throw Failure(path + ": the file " + stored + " is not there any more, and not beside " +
                fs::path(path).filename().string() + " either; put it there, or correct \"" +
                setting + "\"");
}

std::string sentenceOf(const std::exception& error)
{
  // "[json.exception.parse_error.101] parse error at line 3, column 5: syntax error ..."
  const std::string what = error.what();
  const std::size_t end = what.find("] ");
  return end == std::string::npos ? what : what.substr(end + 2);
}

} // namespace mote::app
