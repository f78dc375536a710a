// The table of settings: every row goes through every door, and comes back the same.

#include <settings/History.h>
#include <table/CommandLine.h>
#include <table/Keys.h>
#include <table/Row.h>
#include <table/Session.h>

#include <base/Failure.h>

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <random>
#include <set>

using namespace mote::app;

namespace
{

/// For each row words that are not its default.
std::vector<std::string> sampleOf(const Row& row)
{
  static const std::map<std::string, std::vector<std::string>> samples = {
    {"step", {"3"}},
    {"color-by", {"v:magnitude"}},
    {"color-map", {"plasma"}},
    {"range", {"-1.5", "2e-05"}},
    {"percentiles", {"1", "99.5"}},
    {"where", {"c_pe > -3 && type == 2"}},
    {"calculate", {"speed=sqrt(vx^2 + vy^2)", "fast=speed >= 2"}},
    {"show", {"x=0:10", "type=2,4:5,8:", "c_pe=:-3.25"}},
    {"cut", {"x=0:10", "1,1,0=:2.5", "angle=-30:"}},
    {"cut-axis", {"0", "0", "2", "0", "1", "0.5"}},
    {"hide-ids", {"-2", "7:12", "2/7"}},
    {"picked", {"9", "2/4", "5:7"}},
    {"trajectories", {"4", "7:9"}},
    {"only-ids", {"9223372036854775807"}},
    {"show-range", {"1", "10"}},
    {"show-by", {"it's an array"}},
    {"radius", {"0.1"}},
    {"replicate", {"3", "2", "1"}},
    {"type-radius", {"1=0.5", "7=0.30000000000000004"}},
    {"opacity", {"7%=0.1", "12.5=0.3"}},
    {"iso", {"0.1", "-2"}},
    {"iso-array", {"cell:it's p"}},
    {"slice", {"z=0.5", "angle=-30,90", "1,1,0=2"}},
    {"wall-color", {"#203040"}},
    {"turn", {"rotor=1500", "case.foam: shaft*=-22.5"}},
    {"flow-from", {"0", "0", "0", "1", "2", "0.5"}},
    {"flow-array", {"U"}},
    {"nan-color", {"navy"}},
    {"plain-color", {"#203040"}},
    {"camera", {"1", "2", "3", "0", "0", "0", "0", "0", "1", "30.000000000000004"}},
    {"saved-view", {"a=b=0,0,9,0,0,0,0,1,0,30", "top=parallel,0,0,9,0,0,0,0,1,0,2.5"}},
    {"hide-data", {"2", "3"}},
    {"hide-part", {"inlet", "rotor, stage*"}},
    {"show-part", {"*"}},
    {"type-names", {"1=Cu", "2=Zr"}},
    {"type-colors", {"1=#ff6347", "3=#3060c0"}},
    {"shadows", {"4"}},
    {"light", {"-30,40"}},
    {"ambient-occlusion", {"baked"}},
    {"silhouettes", {"3%"}},
    {"silhouette-thickness", {"1:3"}},
    {"silhouette-color", {"#ff0000"}},
    {"silhouette-groups", {"type"}},
    {"error", {"1%"}},
    {"size", {"320x200"}},
    {"background", {"#ffffff", "#000080"}},
    {"title", {"\"speed\" in km/s"}},
    {"legend-format", {"%.2f"}},
    {"caption", {""}},
  };
  if (const auto found = samples.find(row.name); found != samples.end())
    return found->second;
  if (row.shape == Shape::Flag)
    return {row.get(Settings{}).front() == "true" ? "false" : "true"};
  if (!row.words.empty())
    return {row.words.back() == row.get(Settings{}).front() ? row.words.front() : row.words.back()};
  if (!row.numeric)
    return {};
  const double least = std::isfinite(row.limits.least) ? row.limits.least : 0.0;
  return {std::isfinite(row.limits.most) && row.limits.most <= 1.0 ? "0.75" : exactText(least + 3)};
}

Settings withSample(const Row& row)
{
  Settings settings;
  row.set(settings, sampleOf(row));
  return settings;
}

/// A data file to name, in a folder of its own.
class SettingsTable : public testing::Test
{
protected:
  SettingsTable()
    : folder(
        std::filesystem::path(testing::TempDir()) /
        (std::string("settings-") + testing::UnitTest::GetInstance()->current_test_info()->name()))
  {
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "data.xyz") << "1\n\nAr 0 0 0\n";
    session = (folder / "s.json").string();
  }
  ~SettingsTable() override { std::filesystem::remove_all(folder); }

  std::string data() const { return (folder / "data.xyz").string(); }

  std::filesystem::path folder;
  std::string session;
};

Settings parsedLine(std::vector<std::string> words)
{
  CLI::App app;
  GivenSettings given;
  addAllSettings(app, given);
  std::reverse(words.begin(), words.end());
  app.parse(words);
  return given.settings;
}

} // namespace

TEST_F(SettingsTable, HasANameAndHelpForEveryRow)
{
  std::set<std::string> names;
  for (const Row& row : settingsTable())
  {
    EXPECT_TRUE(names.insert(row.name).second) << row.name << " stands twice";
    EXPECT_FALSE(row.group.empty()) << row.name;
    EXPECT_GT(row.help.size(), 10u) << row.name;
    EXPECT_FALSE(row.help.ends_with('.')) << row.name;
    EXPECT_EQ(row.value.empty(), row.shape == Shape::Flag) << row.name;
    EXPECT_EQ(rowNamed(row.name), &row);
    EXPECT_TRUE(row.needs.empty() || rowNamed(row.needs)) << row.name;
    for (const std::string& other : row.excludes)
      EXPECT_TRUE(rowNamed(other)) << row.name;
  }
  EXPECT_EQ(rowNamed("no-such-row"), nullptr);
}

TEST_F(SettingsTable, DefaultsAreValues)
{
  for (const Row& row : settingsTable())
  {
    Settings settings;
    EXPECT_TRUE(row.isDefault(settings)) << row.name;
    EXPECT_NO_THROW(row.set(settings, row.get(Settings{}))) << row.name;
    EXPECT_EQ(settings, Settings{}) << row.name;
  }
}

TEST_F(SettingsTable, EveryRowIsSetAndRead)
{
  for (const Row& row : settingsTable())
  {
    ASSERT_TRUE(!sampleOf(row).empty()) << row.name << " has no sample";
    const Settings settings = withSample(row);
    EXPECT_FALSE(row.isDefault(settings)) << row.name;
    Settings again;
    row.set(again, row.get(settings));
    EXPECT_EQ(again, settings) << row.name;
    for (const Row& other : settingsTable())
      EXPECT_TRUE(&other == &row || other.isDefault(settings))
        << row.name << " changes " << other.name;
  }
}

TEST_F(SettingsTable, EveryRowGoesThroughTheCommandLine)
{
  for (const Row& row : settingsTable())
  {
    Settings settings = withSample(row);
    for (const std::string& needed : {row.needs})
      if (!needed.empty())
        rowNamed(needed)->set(settings, sampleOf(*rowNamed(needed)));
    settings.data.files = {"data.xyz"};
    EXPECT_EQ(parsedLine(asOptions(settings)), settings)
      << row.name << ": " << asShellLine(asOptions(settings));
  }
}

TEST_F(SettingsTable, EveryRowGoesThroughASession)
{
  for (const Row& row : settingsTable())
  {
    Settings settings = withSample(row);
    settings.data.files = {data()};
    EXPECT_EQ(parseSession(sessionText(settings, session), session), settings) << row.name;
  }
}

TEST_F(SettingsTable, NumbersOfAnySizeGoThroughASession)
{
  for (const double value : {1e300, -1e300, 9007199254740993.0, -3.0, 0.1, 5e-324})
  {
    Settings settings;
    settings.data.files = {data()};
    settings.volume.isoValues = {value};
    EXPECT_EQ(parseSession(sessionText(settings, session), session), settings) << value;
  }
}

TEST_F(SettingsTable, HelpSpeaksOfEveryRow)
{
  CLI::App app;
  GivenSettings given;
  addAllSettings(app, given);
  const std::string help = app.help();
  for (const Row& row : settingsTable())
  {
    EXPECT_NE(help.find(row.option()), std::string::npos) << row.name;
    EXPECT_NE(help.find(row.help), std::string::npos) << row.name;
    for (const std::string& word : row.words)
      EXPECT_NE(help.find(word), std::string::npos) << row.name;
  }
}

TEST_F(SettingsTable, WrongValuesAreRefused)
{
  for (const Row& row : settingsTable())
  {
    Settings settings;
    const auto refuses = [&](std::vector<std::string> words)
    {
      if (row.count > 0)
        words.resize(static_cast<std::size_t>(row.count), words.front());
      try
      {
        row.set(settings, words);
        return false;
      }
      catch (const WrongValue& wrong)
      {
        return !wrong.sentence.empty() && settings == Settings{};
      }
    };
    for (const char* word : {"nan", "inf", "x", "", "1 2"})
    {
      EXPECT_TRUE(!row.numeric || refuses({word})) << row.name << " takes " << word;
    }
    if (row.limits.aboveZero && row.numeric)
    {
      EXPECT_TRUE(refuses({"0"})) << row.name;
    }
    if (std::isfinite(row.limits.least))
    {
      EXPECT_TRUE(refuses({exactText(row.limits.least - 1.0)})) << row.name;
    }
    if (std::isfinite(row.limits.most))
    {
      EXPECT_TRUE(refuses({exactText(row.limits.most + 1.0)})) << row.name;
    }
    if (!row.words.empty())
    {
      EXPECT_TRUE(refuses({"no-such-word"})) << row.name;
    }
    if (!row.words.empty() && row.get(Settings{}).front() != "")
    {
      EXPECT_TRUE(refuses({""})) << row.name;
    }
    if (row.shape == Shape::Flag)
    {
      EXPECT_TRUE(refuses({"maybe"})) << row.name;
    }
    if (row.shape == Shape::One)
    {
      EXPECT_TRUE(refuses({"1", "2"})) << row.name;
    }
  }
}

TEST_F(SettingsTable, SessionsKeepTheViewsOfFilms)
{
  Settings settings;
  settings.data.files = {data()};
  settings.color.map = "plasma";
  EXPECT_EQ(sessionText(settings, session).find("key-frames"), std::string::npos);
  Settings key = settings;
  key.color.map.clear();
  key.camera.azimuth = 30.0;
  settings.keyFrames = {settings, key};
  EXPECT_EQ(parseSession(sessionText(settings, session), session), settings);
  History history;
  history.add(Settings());
  EXPECT_TRUE(history.undo(settings)->keyFrames.empty());
  EXPECT_EQ(history.redo(Settings())->keyFrames.size(), 2u);
  std::string text = sessionText(settings, session);
  text.replace(text.find("\"azimuth\": 30"), 9, "\"nothing\"");
  EXPECT_THROW(parseSession(text, session), Failure);
}

TEST_F(SettingsTable, SessionsFindTheirDataWhereverTheyLie)
{
  Settings settings;
  settings.data.files = {data()};
  writeSession(settings, session);
  EXPECT_EQ(readSession(session).data.files.front(), data());
  // Moved together, and by itself with the data beside it.
  const auto moved = folder / "moved";
  std::filesystem::create_directory(moved);
  std::filesystem::rename(folder / "data.xyz", moved / "data.xyz");
  std::filesystem::rename(session, moved / "s.json");
  EXPECT_EQ(
    readSession((moved / "s.json").string()).data.files.front(), (moved / "data.xyz").string());
  std::filesystem::remove(moved / "data.xyz");
  try
  {
    readSession((moved / "s.json").string());
    ADD_FAILURE() << "missing data went unnoticed";
  }
  catch (const Failure& failure)
  {
    EXPECT_NE(std::string(failure.what()).find("data.xyz"), std::string::npos) << failure.what();
  }
}

TEST_F(SettingsTable, WrongSessionsGetASentenceWithThePlace)
{
  const std::string files = "\"files\": [\"" + data() + "\"]";
  const std::map<std::string, std::string> wrong = {
    {"", "is no session"},
    {"[1, 2]", "is no session"},
    {"{\"mote-session\": 1,\n oops}", "line 2"},
    {"{" + files + "}", "mote-session"},
    {"{\"mote-session\": 99, " + files + "}", "version 99"},
    {"{\"mote-session\": 1}", "names no data"},
    {"{\"mote-session\": 1, \"files\": [1]}", "files"},
    {"{\"mote-session\": 1, " + files + ", \"light\": {\"shadow\": \"soft\"}}", "light/shadow"},
    {"{\"mote-session\": 1, " + files + ", \"light\": {\"shadows\": \"pink\"}}",
      "light/shadows: 'pink'"},
    {"{\"mote-session\": 1, " + files + ", \"light\": {\"range\": [0, 1]}}", "light/range"},
    {"{\"mote-session\": 1, " + files + ", \"light\": 3}", "light"},
    {"{\"mote-session\": 1, " + files + ", \"colour\": {\"range\": [1e999, 2]}}", ""},
    {"{\"mote-session\": 1, " + files + ", \"colour\": {\"range\": [2, 1]}}", "LO must be"},
    {"{\"mote-session\": 1, " + files + ", \"camera\": {\"camera\": [1, 2]}}", "takes 10 values"},
  };
  for (const auto& [text, sentence] : wrong)
    try
    {
      parseSession(text, session);
      ADD_FAILURE() << "taken: " << text;
    }
    catch (const Failure& failure)
    {
      EXPECT_NE(std::string(failure.what()).find(session), std::string::npos) << failure.what();
      EXPECT_NE(std::string(failure.what()).find(sentence), std::string::npos) << failure.what();
    }
}

TEST_F(SettingsTable, TenThousandDamagedSessionsAreReadOrRefused)
{
  Settings settings;
  for (const Row& row : settingsTable())
    row.set(settings, sampleOf(row));
  settings.data.files = {data()};
  const std::string whole = sessionText(settings, session);
  ASSERT_EQ(parseSession(whole, session), settings);
  std::mt19937 random(1);
  const auto below = [&](std::size_t n) { return random() % std::max<std::size_t>(1, n); };
  const std::string bytes = "{}[]\",:0123456789.eE+-truefalsn\\\0\x80\xff";
  int refused = 0;
  for (int i = 0; i < 10000; ++i)
  {
    std::string text = whole;
    for (std::size_t changes = 1 + below(4); changes > 0; --changes)
    {
      const std::size_t at = below(text.size());
      switch (below(4))
      {
      case 0:
        text[at] = bytes[below(bytes.size())];
        break;
      case 1:
        text.erase(at, 1 + below(20));
        break;
      case 2:
        text.insert(at, text.substr(below(text.size()), below(40)));
        break;
      default:
        text.resize(at);
      }
      if (text.empty())
        break;
    }
    try
    {
      parseSession(text, session);
    }
    catch (const Failure& failure)
    {
      ASSERT_FALSE(std::string(failure.what()).empty());
      ++refused;
    }
  }
  EXPECT_GT(refused, 5000);
}

TEST_F(SettingsTable, TheCommandLineOverrulesASession)
{
  Settings settings;
  settings.data.files = {data()};
  settings.light.shadows = "soft";
  settings.camera.camera = {1, 2, 3, 0, 0, 0, 0, 0, 1, 30};
  writeSession(settings, session);
  CLI::App app;
  GivenSettings given;
  addAllSettings(app, given);
  std::vector<std::string> words = {"--color-map=plasma", "--view=+x", session};
  app.parse(words);
  const Settings all = given.resolved();
  EXPECT_EQ(all.light.shadows, "soft");
  EXPECT_EQ(all.color.map, "plasma");
  EXPECT_EQ(all.camera.view, "+x");
  EXPECT_TRUE(all.camera.camera.empty()) << "a side stands in place of the session's camera";
  EXPECT_EQ(all.data.files, std::vector<std::string>{data()});
}

TEST_F(SettingsTable, AnotherProjectionKeepsTheSizeOfASessionsView)
{
  Settings settings;
  settings.data.files = {data()};
  settings.camera.camera = {0, 0, 10, 0, 0, 0, 0, 1, 0, 30};
  writeSession(settings, session);
  CLI::App app;
  GivenSettings given;
  addAllSettings(app, given);
  std::vector<std::string> words = {"--orthographic", session};
  app.parse(words);
  const Settings all = given.resolved();
  EXPECT_TRUE(all.camera.orthographic);
  EXPECT_DOUBLE_EQ(all.camera.camera.at(9), 10.0 * std::tan(std::numbers::pi / 12.0));
}

TEST_F(SettingsTable, KeysNameRowsThatChange)
{
  int bound = 0;
  for (int c = 32; c < 127; ++c)
  {
    const Binding& binding = bindingOf(std::string(1, static_cast<char>(c)));
    if (binding.row.empty())
      continue;
    const Row* row = rowNamed(binding.row);
    ASSERT_NE(row, nullptr) << binding.row;
    ++bound;
    Settings settings;
    if (binding.action == Action::Set)
    {
      EXPECT_NO_THROW(row->set(settings, {binding.value})) << binding.row;
    }
    else if (binding.action == Action::Next && binding.row != "color-by" &&
             binding.row != "background")
    {
      row->goOn(settings, Settings{});
      EXPECT_NE(settings, Settings{}) << binding.row;
      // The values come round.
      std::vector<Settings> seen;
      while (std::find(seen.begin(), seen.end(), settings) == seen.end())
      {
        seen.push_back(settings);
        ASSERT_LE(seen.size(), 4 + row->words.size() + row->offers.size()) << binding.row;
        row->goOn(settings, Settings{});
      }
    }
  }
  EXPECT_GT(bound, 20);
}

TEST(SettingsHistory, GoesBackAndForth)
{
  History history;
  Settings a, b, c;
  b.light.shadows = "soft";
  c.light.shadows = "hard";
  EXPECT_FALSE(history.undo(a));
  history.add(a); // now b
  history.add(b); // now c
  EXPECT_EQ(history.undo(c), b);
  EXPECT_EQ(history.undo(b), a);
  EXPECT_FALSE(history.undo(a));
  EXPECT_EQ(history.redo(a), b);
  history.add(b); // another way
  EXPECT_FALSE(history.redo(c));
  EXPECT_EQ(history.undo(c), b);
}

TEST(ShellLine, IsQuotedWhereItMustBe)
{
  EXPECT_EQ(asShellLine({"mote", "a b", "--show=x=0:1", "it's", "", "#fff"}),
    "mote 'a b' --show=x=0:1 'it'\\''s' '' '#fff'");
}
