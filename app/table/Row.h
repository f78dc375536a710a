#pragma once

#include "settings/Settings.h"
#include "settings/Values.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mote::app
{

/// What must be made anew when a choice changes, from little to much.
enum class Invalidates
{
  Nothing,   ///< what is drawn stays
  Picture,   ///< what lies over the picture, or its size
  Shading,   ///< light, colours, what is shown
  Structure, ///< what rays are cast through
  Data       ///< what is read
};

/// One choice of the user's: the command line, its help, sessions, keys and reference pages know
/// it from here.
struct Row
{
  std::string group = {}; ///< "Light"
  std::string name = {};  ///< "shadows": --shadows on the command line, "shadows" in a session
  std::string value = {}; ///< what help writes for the value: "KIND", "LO HI"
  std::string help = {};  ///< a sentence
  Invalidates invalidates = Invalidates::Shading;
  std::string alias = {}; ///< one more name on the command line: "-c", "--ao"
  Shape shape = Shape::One;
  int count = 0;          ///< of values, where the shape is Many
  bool commas = true;     ///< whether values may be joined by commas, where there are several
  bool numeric = true;    ///< whether sessions write the values as numbers
  Limits limits = {};     ///< of numbers
  bool inDecades = false; ///< whether the small ones of them are told apart, too, by a slider
  std::vector<std::string> words = {};    ///< all values there are; none: any
  std::vector<std::string> offers = {};   ///< where any may be: those that have a name
  bool namesFile = false;                 ///< whether any other value there is a file
  std::string usual = {};                 ///< what help says of the default; empty: the value
  std::string needs = {};                 ///< the name of another row
  std::vector<std::string> excludes = {}; ///< names of others
  std::string command = {}; ///< that alone has it, "mote" for the window; empty: of pictures
  bool required = false;    ///< whether the command asks for it

  /// For keys, where `asked` are the settings that the user began with: goes on to the next value.
  /// None: to the other state of a flag, or to the next of the words or offers.
  std::function<void(Settings&, const Settings& asked)> next = {};
  /// What is chosen, in a few words that the window shows when a key has changed it; or none.
  std::function<std::string(const Settings&)> told = {};

  /// The values in these settings as words of the command line; none where nothing is chosen.
  std::function<std::vector<std::string>(const Settings&)> get = {};
  /// Sets them. Throws WrongValue, and leaves the settings as they are.
  std::function<void(Settings&, const std::vector<std::string>&)> set = {};

  /// As an option of the command line: a flag that is on by default says "no-".
  std::string option() const;
  bool isDefault(const Settings& settings) const;
  /// Goes on to the next value; see `next`.
  void goOn(Settings& settings, const Settings& asked) const;
  /// What values there are: the words, or "from 0 to 90"; empty: any.
  std::string values() const;
  /// What help says of the default, of a command whose settings begin with these; empty: nothing.
  std::string usualText(const Settings& settings = {}) const;
};

/// Rows and the words for them, as a command line names them.
using NamedValues = std::vector<std::pair<const Row*, std::vector<std::string>>>;

/// A row for a member of a group of the settings.
template <typename Group, typename T>
Row row(Group Settings::*group, T Group::*member, Row about,
  const std::function<void(const T&)>& check = {})
{
  using Values = ValuesOf<T>;
  about.numeric = Values::numeric;
  if (about.shape == Shape::One)
    about.shape = Values::shape;
  about.get = [group, member](const Settings& s) { return Values::words((s.*group).*member); };
  about.set = [group, member, check, limits = about.limits, allowed = about.words,
                count = about.count](Settings& s, const std::vector<std::string>& words)
  {
    if (!allowed.empty())
    {
      const std::vector<std::string> usual = Values::words((Settings{}.*group).*member);
      requireWords(words, allowed, usual.empty() ? "" : usual.front());
    }
    if (count > 0 && !words.empty() && static_cast<int>(words.size()) != count)
      throw WrongValue{
        "takes " + std::to_string(count) + " values, not " + std::to_string(words.size())};
    T value = Values::parse(words, limits);
    if (check)
      check(value);
    (s.*group).*member = std::move(value);
  };
  return about;
}

/// All choices of pictures, group after group: what sessions keep.
const std::vector<Row>& settingsTable();

/// What one command alone may be told.
const std::vector<Row>& commandTable();

/// Of `--steps`: from `first` on, counted from 1, to `last`, or to the end where that is 0.
struct StepRange
{
  int first = 1, last = 0, stride = 1;
};
/// "3", "2:9", "2:", ":9", "1:100:10"; none for other texts.
std::optional<StepRange> stepRange(const std::string& text);

/// A size such as "4G" in bytes; 0 for a text that is none.
std::uint64_t bytesOf(const std::string& text);

/// A size such as "4G", or "25%" of the machine's memory, in bytes; "0" is 0. None for a text that
/// is neither.
std::optional<std::uint64_t> memoryOf(const std::string& text);

/// The row of commandTable() that is a command's; null where there is none.
const Row* commandRow(const std::string& command, const std::string& name);

/// The row of that name; null where there is none.
const Row* rowNamed(const std::string& name);

} // namespace mote::app
