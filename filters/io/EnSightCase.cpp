#include "EnSightCase.h"

#include "EnSightGeometry.h"
#include "FileError.h"
#include "TextFile.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace mote
{

namespace
{

constexpr std::size_t mostSteps = 1'000'000;

std::string trimmed(const std::string& text)
{
  const char* const blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == text.npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string> wordsOf(const std::string& text)
{
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
    words.push_back(word);
  return words;
}

template <class T>
bool isNumber(const std::string& word, T& value)
{
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  return error == std::errc() && stop == end;
}

/// Sections that are not read.
bool isPassedOver(const std::string& section)
{
  return section == "MATERIAL" || section == "SCRIPTS" || section == "BLOCK_CONTINUATION";
}

/// 1 of "scalar per node", 3 of vectors, 6 and 9 of tensors; 0 for what is none of them. Words
/// between would lead VTK's reader to no kind at all.
int componentsOf(const std::string& kind)
{
  static const std::map<std::string, int> known = {
    {"scalar", 1}, {"vector", 3}, {"tensor symm", 6}, {"tensor asym", 9}};
  std::vector<std::string> words = wordsOf(kind);
  if (words.size() < 3 || words[words.size() - 2] != "per" ||
      (words.back() != "node" && words.back() != "element"))
    return 0;
  words.resize(words.size() - 2);
  const auto found = known.find(words.size() == 1 ? words[0] : words[0] + " " + words[1]);
  return found == known.end() || words.size() > 2 ? 0 : found->second;
}

} // namespace

EnSightCase::EnSightCase(const std::string& path)
  : path_(path)
{
  this->parse();
  this->require();
}

void EnSightCase::fail(const std::string& sentence, bool isHere) const
{
  throw FileError(FileError::Kind::Malformed, path_, sentence, isHere ? line_ : 0);
}

void EnSightCase::parse()
{
  std::ifstream file(path_, std::ios::binary);
  std::string section;
  std::set<std::string> met;
  bool isGold = false;
  for (std::string line; std::getline(file, line);)
  {
    ++line_;
    line = trimmed(line.substr(0, line.find('#')));
    if (line.empty())
      continue;
    if (std::any_of(
          line.begin(), line.end(), [](char c) { return c >= 0 && c < ' ' && c != '\t'; }))
      this->fail("this is no text");
    static const std::vector<std::string> sections = {"FORMAT", "GEOMETRY", "VARIABLE", "TIME",
      "FILE", "MATERIAL", "SCRIPTS", "BLOCK_CONTINUATION"};
    if (std::find(sections.begin(), sections.end(), line) != sections.end())
    {
      // VTK's reader would never end.
      if (isPassedOver(section))
        this->fail("the section " + section + " is passed over at the end of a case alone, and " +
                   line + " comes behind it");
      // Nor would it come past these right behind the model.
      if (isPassedOver(line) && !met.contains("VARIABLE") && !met.contains("TIME"))
        this->fail("the section " + line + " is passed over behind VARIABLE or TIME alone");
      if (!met.insert(line).second)
        this->fail("the section " + line + " comes twice");
      section = line;
      continue;
    }
    const std::size_t colon = line.find(':');
    const std::string key = colon == line.npos ? "" : trimmed(line.substr(0, colon));
    // VTK's reader would take the colon for a word, or for a part of the next.
    if (colon != line.npos && key.size() < colon)
      this->fail("blanks stand before the colon of '" + key + "'");
    if (colon != line.npos && colon + 1 < line.size() && line[colon + 1] != ' ' &&
        line[colon + 1] != '\t')
      this->fail("no blank stands behind the colon of '" + key + "'");
    const std::string value = trimmed(line.substr(colon == line.npos ? 0 : colon + 1));
    if (section.empty())
      throw FileError(FileError::Kind::OtherFormat, path_, "this is no EnSight case");
    if (section == "FORMAT" && key == "type")
    {
      isGold = wordsOf(value) == std::vector<std::string>{"ensight", "gold"};
      if (!isGold)
        throw FileError(FileError::Kind::OtherFormat, path_,
          "EnSight Gold cases are read, and this is of the type '" + value + "'");
    }
    else
      this->parseLine(section, key, value);
  }
  if (!isGold)
    throw FileError(FileError::Kind::OtherFormat, path_, "this is no whole EnSight Gold case");
  if (met.contains("FILE") && geometry_.fileSet == 0) // VTK's reader would not end
    this->fail("there are file sets, but the model is of none, which is not read", false);
}

void EnSightCase::parseLine(
  const std::string& section, const std::string& key, const std::string& value)
{
  if (section == "GEOMETRY" && key == "model")
  {
    if (!geometry_.file.empty()) // VTK's reader takes the first
      this->fail("the case names two models");
    std::vector<std::string> words = wordsOf(value);
    std::erase_if(words, [](const std::string& word) { return word.starts_with("change_coords"); });
    geometry_ = this->patternOf(words, 0);
  }
  else if (section == "GEOMETRY")
    this->fail("in the geometry, a model is read, and not '" + key + "'");
  else if (section == "VARIABLE")
    this->parseVariable(key, value);
  else if (section == "TIME")
    this->parseTime(key, value);
  else if (section == "FILE")
    this->parseFileSet(key, value);
  else if (section == "FORMAT") // VTK's reader would never end
    this->fail("behind the type of the format comes a section, such as GEOMETRY");
}

/// Sets of files that hold many steps each: read are those of one file. What is said of others, and
/// of sets that nothing names, does not matter, but VTK's reader would never end at other words.
void EnSightCase::parseFileSet(const std::string& key, const std::string& value)
{
  if (key != "file set" && key != "number of steps" && key != "filename index")
    this->fail("file sets have no '" + key + "'");
  int number = 0;
  const std::vector<std::string> words = wordsOf(value);
  if (words.empty() || !isNumber(words[0], number) || number < 0)
    this->fail("'" + key + "' has no number");
  if (key == "file set")
    fileSet_ = number;
  else if (key == "filename index")
    fileSets_[fileSet_].isSpread = true;
  else
    fileSets_[fileSet_].steps += static_cast<std::size_t>(number);
}

/// A file's name behind `after` other words, and before them the numbers of a time set and a file
/// set.
EnSightCase::Pattern EnSightCase::patternOf(std::vector<std::string> words, std::size_t after) const
{
  Pattern pattern;
  if (words.size() < after + 1 || words.size() > after + 3)
    this->fail("expected the name of a file, and before it the number of a time set");
  pattern.file = words.back();
  if (pattern.file.size() > 2 && pattern.file.front() == '"' && pattern.file.back() == '"')
    pattern.file = pattern.file.substr(1, pattern.file.size() - 2);
  words.resize(words.size() - 1 - after);
  if ((!words.empty() && (!isNumber(words[0], pattern.timeSet) || pattern.timeSet < 1)) ||
      (words.size() > 1 && (!isNumber(words[1], pattern.fileSet) || pattern.fileSet < 1)))
    this->fail("expected the number of a time set or file set, from 1");
  return pattern;
}

void EnSightCase::parseVariable(const std::string& key, const std::string& value)
{
  const std::vector<std::string> words = wordsOf(value);
  if (key.starts_with("constant per "))
    return;
  Variable variable;
  variable.isOfNodes = key.ends_with("node");
  variable.components = componentsOf(key);
  if (variable.components == 0)
    this->fail("variables are read that are scalars, vectors or tensors per node or element, and "
               "not '" +
               key + "'");
  variable.pattern = this->patternOf(words, 1);
  variables_.push_back(variable);
}

void EnSightCase::parseTime(const std::string& key, const std::string& value)
{
  const std::vector<std::string> words = wordsOf(value);
  int number = 0;
  const auto requireNumber = [&](int least)
  {
    if (words.empty() || !isNumber(words[0], number) || number < least)
      this->fail("'" + key + "' has no number from " + std::to_string(least));
  };
  if (!key.empty())
    listed_ = "";
  if (key == "time set")
  {
    requireNumber(1);
    if (timeSets_.contains(number))
      this->fail("the time set " + words[0] + " comes twice");
    timeSet_ = number;
    timeSets_[number];
    return;
  }
  if (timeSet_ == 0)
    this->fail("expected a time set");
  TimeSet& set = timeSets_[timeSet_];
  if (key == "number of steps")
  {
    requireNumber(1);
    counts_[timeSet_] = static_cast<std::size_t>(number);
  }
  else if (key == "filename start number")
  {
    requireNumber(0);
    starts_[timeSet_].first = number;
  }
  else if (key == "filename increment")
  {
    requireNumber(0);
    starts_[timeSet_].second = number;
  }
  else if (key == "time values" || key == "filename numbers")
    listed_ = key;
  else if (!key.empty() || listed_.empty())
    this->fail("times have no '" + (key.empty() ? value : key) + "'");
  if (listed_.empty())
    return;
  for (const std::string& word : words)
  {
    double time = 0.0;
    if (listed_ == "time values" ? !isNumber(word, time) || !std::isfinite(time)
                                 : !isNumber(word, number) || number < 0)
      this->fail("'" + word + "' is no number of '" + listed_ + "'");
    if (listed_ == "time values")
      set.times.push_back(time);
    else
      set.numbers.push_back(number);
  }
}

/// What holds where the lines fit together.
void EnSightCase::require() const
{
  for (const auto& [number, set] : timeSets_)
  {
    const std::string name = "the time set " + std::to_string(number);
    const auto count = counts_.find(number);
    const std::size_t steps = count == counts_.end() ? 0 : count->second;
    if (steps == 0 || steps > mostSteps || set.times.size() != steps)
      this->fail(name + " says that there are " + std::to_string(steps) + " steps, and has " +
                   std::to_string(set.times.size()) + " time values",
        false);
    if (!std::is_sorted(set.times.begin(), set.times.end()))
      this->fail("the time values of " + name + " do not ascend", false);
    if (!set.numbers.empty() && set.numbers.size() != steps)
      this->fail(name + " has " + std::to_string(set.numbers.size()) + " filename numbers for " +
                   std::to_string(steps) + " steps",
        false);
  }
  if (geometry_.file.empty())
    this->fail("the case names no model", false);
  std::vector<Pattern> all = {geometry_};
  for (const Variable& variable : variables_)
    all.push_back(variable.pattern);
  for (const Pattern& one : all)
  {
    const bool isCounted = one.file.find('*') != std::string::npos;
    const int set = one.timeSet == 0 && isCounted ? 1 : one.timeSet;
    if (set != 0 && !timeSets_.contains(set))
      this->fail(
        "'" + one.file + "' has the time set " + std::to_string(set) + ", which is not there",
        false);
    if (isCounted && timeSets_.at(set).numbers.empty() && !starts_.contains(set))
      this->fail(
        "the time set " + std::to_string(set) + " has no numbers for '" + one.file + "'", false);
    if (one.fileSet == 0)
      continue;
    const auto files = fileSets_.find(one.fileSet);
    if (isCounted || (files != fileSets_.end() && files->second.isSpread))
      this->fail("the steps of '" + one.file +
                   "' are spread over several files of many steps each, which is not read",
        false);
    if (set == 0 || files == fileSets_.end() ||
        files->second.steps != timeSets_.at(set).times.size())
      this->fail("'" + one.file + "' has the file set " + std::to_string(one.fileSet) +
                   ", which has not the steps of its time set",
        false);
  }
}

std::string EnSightCase::fileAt(const Pattern& pattern, std::optional<double> time) const
{
  std::string name = pattern.file;
  const std::size_t stars = name.find('*');
  if (stars != name.npos)
  {
    const int number = pattern.timeSet == 0 ? 1 : pattern.timeSet;
    const TimeSet& set = timeSets_.at(number);
    const auto after =
      std::upper_bound(set.times.begin(), set.times.end(), time.value_or(set.times.front()));
    const std::size_t step =
      after == set.times.begin() ? 0 : static_cast<std::size_t>(after - set.times.begin()) - 1;
    const auto start = starts_.find(number);
    const int own = set.numbers.empty()
                      ? start->second.first + static_cast<int>(step) * start->second.second
                      : set.numbers[step];
    const std::size_t width = std::min(name.find_first_not_of('*', stars), name.size()) - stars;
    std::string digits = std::to_string(own);
    digits.insert(0, width > digits.size() ? width - digits.size() : 0, '0');
    name.replace(stars, width, digits);
  }
  return (std::filesystem::path(path_).parent_path() / name).string();
}

void EnSightCase::requireFiles() const
{
  // Without a model VTK's reader would not come past other sections behind it.
  const std::string model = this->fileAt(geometry_, {});
  requireNoStream(model);
  readBeginning(model, 1);
  for (const Variable& variable : variables_)
    requireNoStream(this->fileAt(variable.pattern, {}));
}

void EnSightCase::checkAt(std::optional<double> time) const
{
  const std::string geometry = this->fileAt(geometry_, time);
  const std::vector<EnSightParts> parts = checkEnSightGeometry(geometry);
  this->requireSteps(geometry_, geometry, parts.size());
  const EnSightForm form = formOfEnSight(geometry);
  for (const Variable& variable : variables_)
  {
    const std::string file = this->fileAt(variable.pattern, time);
    this->requireSteps(variable.pattern, file,
      checkEnSightValues(file, form, parts, variable.components, variable.isOfNodes));
  }
}

/// That a file has the steps of its set: VTK's reader looks for them behind its end.
void EnSightCase::requireSteps(
  const Pattern& pattern, const std::string& file, std::size_t found) const
{
  const std::size_t wanted = pattern.fileSet == 0 ? 1 : fileSets_.at(pattern.fileSet).steps;
  if (found < wanted)
    throw FileError(FileError::Kind::Truncated, file,
      "it holds " + std::to_string(found) + " of the " + std::to_string(wanted) +
        " time steps of its set: it is truncated");
}

} // namespace mote
