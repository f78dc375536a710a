// What is opened in the window, from which list, and what is remembered of it.

#include <base/Failure.h>
#include <base/ProgressRelay.h>
#include <base/Text.h>
#include <base/UserFiles.h>
#include <panels/FolderList.h>
#include <settings/KeptSession.h>
#include <settings/UserState.h>
#include <stage/Input.h>

#include <table/Opening.h>
#include <table/Session.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

using namespace mote::app;
namespace fs = std::filesystem;

namespace
{

class Opening : public testing::Test
{
protected:
  Opening()
    : folder(
        fs::path(testing::TempDir()) /
        (std::string("opening-") + testing::UnitTest::GetInstance()->current_test_info()->name()))
  {
    fs::remove_all(folder);
    fs::create_directories(folder);
    setenv("XDG_STATE_HOME", folder.c_str(), 1);
  }
  ~Opening() override { fs::remove_all(folder); }

  std::string make(const std::string& name, const std::string& text = "1\n\nAr 0 0 0\n") const
  {
    std::ofstream(folder / name) << text;
    return (folder / name).string();
  }

  fs::path folder;
};

} // namespace

TEST_F(Opening, FilesOfOneNameAreToldApartByTheirFolders)
{
  for (const char* name : {"first", "second"})
    fs::create_directories(folder / name / "results");
  const std::string one = this->make("first/results/gas.xyz"),
                    other = this->make("second/results/gas.xyz"), third = this->make("ice.xyz");
  ProgressRelay progress;
  const auto namesOf = [&](const std::vector<std::string>& files)
  {
    Input input(files);
    input.open(progress);
    std::vector<std::string> names;
    for (const NamedData& data : input.read(0, progress))
    {
      EXPECT_EQ(data.name, data.fileName);
      names.push_back(data.name);
    }
    return names;
  };
  EXPECT_EQ(namesOf({one, third}), (std::vector<std::string>{"gas.xyz", "ice.xyz"}));
  EXPECT_EQ(namesOf({one, other, third}),
    (std::vector<std::string>{"first/results/gas.xyz", "second/results/gas.xyz", "ice.xyz"}));
  EXPECT_EQ(namesOf({one, one}), (std::vector<std::string>{"gas.xyz", "gas.xyz"}))
    << "two of one file have nothing that tells them apart";
}

TEST_F(Opening, OtherDataTakeNothingThatSpeaksOfTheFormer)
{
  Settings now;
  now.data.files = {"a.dump"};
  now.data.step = "3";
  now.data.threads = 2;
  now.color.array = "energy";
  now.selection.where = "energy > 2";
  now.cuts.ranges = {{"x", {{0.0, 1.0}}}};
  now.cuts.axis = {1.0, 0.0, 0.0};
  now.flow.lines = 20;
  now.marks.picked = {"7"};
  now.marks.trajectories = IdRanges({{0, 7, 7}});
  now.film.steps = "2:9";
  now.camera.camera = std::vector<double>(10, 1.0);
  now.light.shadows = "soft";
  now.picture.title = "energy";
  now.output.session = "s.json";
  const Settings next = settingsToOpen(now, {"b.dump"}, false);
  Settings expected;
  expected.data.files = {"b.dump"};
  expected.data.threads = 2;
  expected.light.shadows = "soft";
  expected.output.session = "s.json";
  EXPECT_EQ(next, expected);
}

TEST_F(Opening, AddedFilesStandBesideTheOthersOnce)
{
  Settings now;
  now.data.files = {"a.dump"};
  now.color.array = "energy";
  const Settings next = settingsToOpen(now, {"b.dump", "a.dump"}, true);
  EXPECT_EQ(next.data.files, (std::vector<std::string>{"a.dump", "b.dump"}));
  EXPECT_EQ(next.color.array, "energy");
}

TEST_F(Opening, ASessionIsOpenedAlone)
{
  Settings kept;
  kept.data.files = {this->make("a.xyz")};
  kept.light.size = 30.0;
  const std::string session = (folder / "s.json").string();
  writeSession(kept, session);
  Settings now;
  now.output.panel = false;
  const Settings next = settingsToOpen(now, {session}, false);
  EXPECT_EQ(next.data.files, kept.data.files);
  EXPECT_EQ(next.light.size, 30.0);
  EXPECT_FALSE(next.output.panel);
  // The size of saved pictures is the session's, where it has one.
  now.output.size = {640, 480};
  EXPECT_EQ(settingsToOpen(now, {session}, false).output.size, now.output.size);
  kept.output.size = {320, 200};
  writeSession(kept, session);
  EXPECT_EQ(settingsToOpen(now, {session}, false).output.size, kept.output.size);
  EXPECT_THROW(settingsToOpen(now, {session, "b.dump"}, false), Failure);
  EXPECT_THROW(settingsToOpen(now, {session}, true), Failure);
}

TEST_F(Opening, AFolderListsWhatCanBeReadInTheOrderOfNumbers)
{
  fs::create_directories(folder / "Zoo" / "system");
  for (const char* name : {"run.10.vtu", "run.9.vtu", "b.xyz", "a10.pdb", "a9.pdb", ".hidden.xyz"})
    this->make(name);
  this->make("words.txt", "words");
  this->make("points.txt", "x y z\n1 2 3\n"); // so, too
  this->make("other.json", "{\"mote\": 1}");
  this->make("melt", "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n0\n"); // by its first bytes
  Settings kept;
  kept.data.files = {this->make("a9.pdb")};
  writeSession(kept, (folder / "view.json").string());
  this->make("Zoo/system/controlDict", "FoamFile { object controlDict; }");
  std::string problem;
  std::vector<std::string> names;
  for (const FolderEntry& entry : listFolder(folder, problem))
    names.push_back(entry.name);
  EXPECT_EQ(problem, "");
  EXPECT_EQ(names, (std::vector<std::string>{"Zoo", "a9.pdb", "a10.pdb", "b.xyz", "melt",
                     "points.txt", "run.*.vtu", "view.json"}));
  const std::vector<FolderEntry> ofCase = listFolder(folder / "Zoo", problem);
  ASSERT_EQ(ofCase.size(), 2u);
  EXPECT_EQ(ofCase[1].name, "system/controlDict");
  EXPECT_EQ(ofCase[1].files, std::vector<std::string>{folder / "Zoo/system/controlDict"});
  EXPECT_TRUE(listFolder(folder / "none", problem).empty());
  EXPECT_NE(problem, "");
  EXPECT_TRUE(isFound("Copper-Scratch.dump.gz", "scr  COP"));
  EXPECT_FALSE(isFound("copper", "copper b"));
}

TEST_F(Opening, RecentFilesComeOnceLatestFirst)
{
  EXPECT_TRUE(readUserState().recent.empty());
  for (const char* name : {"a.xyz", "b.xyz", "a.xyz"})
    noteRecent({this->make(name)});
  noteRecent({"pump:0.02"}); // is no file
  ASSERT_EQ(readUserState().recent.size(), 3u);
  EXPECT_EQ(readUserState().recent[0], std::vector<std::string>{"pump:0.02"});
  EXPECT_EQ(readUserState().recent[1], std::vector<std::string>{(folder / "a.xyz").string()});
  for (int i = 0; i < 40; ++i)
    noteRecent({"lattice:" + std::to_string(i)});
  EXPECT_LE(readUserState().recent.size(), 12u);
  changeUserState([](UserState& state) { state.hints = false, state.hintsSeen = 3; });
  noteRecent({"lattice:8"});
  EXPECT_FALSE(readUserState().hints);
  EXPECT_EQ(readUserState().hintsSeen, 3);
}

TEST_F(Opening, AStateThatMakesNoSenseIsTheUsualOne)
{
  for (const char* text : {"", "{", "[]", "{\"recent\": 3, \"hints\": 4, \"hints-seen\": \"a\"}",
         "{\"recent\": [3, [], [4]]}"})
  {
    fs::create_directories(stateFile().parent_path());
    std::ofstream(stateFile()) << text;
    EXPECT_TRUE(readUserState().recent.empty()) << text;
    EXPECT_TRUE(readUserState().hints) << text;
    EXPECT_EQ(readUserState().hintsSeen, 0) << text;
  }
}

TEST_F(Opening, LongSentencesAreWrapped)
{
  EXPECT_EQ(wrapped("one two three", 8), "one two\nthree");
  EXPECT_EQ(wrapped("one two three", 80), "one two three");
  EXPECT_EQ(wrapped("a verylongword b", 4), "a\nverylongword\nb");
  EXPECT_EQ(wrapped(" a  b\n c", 80), " a  b\n c") << "lines that fit stay as they are";
  EXPECT_EQ(wrapped("", 5), "");
}

TEST_F(Opening, ASessionLacksWhatWasChosenSinceAndNotWhatWasLookedAt)
{
  KeptSession session;
  Settings now;
  now.data.files = {"a.dump"};
  EXPECT_FALSE(session.lacks(now)) << "there is none";
  session.keep(now);
  EXPECT_FALSE(session.lacks(now));
  now.camera.view = "+x";
  now.data.step = "3";
  EXPECT_FALSE(session.lacks(now)) << "looking changes nothing";
  now.color.map = "plasma";
  EXPECT_TRUE(session.lacks(now));
  now.color.map.clear();
  EXPECT_FALSE(session.lacks(now)) << "it was undone";
  now.data.files = {"a.dump", "b.dump"};
  EXPECT_TRUE(session.lacks(now)) << "data were added";
  now.data.files = {"b.dump"};
  EXPECT_FALSE(session.lacks(now)) << "other data are no session";
  now.data.files = {"a.dump"};
  now.selection.where = "x > 1";
  session.forget();
  EXPECT_FALSE(session.lacks(now));
}
