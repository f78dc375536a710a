// Recordings: every kind of line comes back as it was, and the last settings are told.

#include <table/Recording.h>

#include <base/Failure.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

using namespace mote::app;

namespace
{

using Kind = RecordedEvent::Kind;

class RecordingTest : public testing::Test
{
protected:
  RecordingTest()
    : folder(
        std::filesystem::path(testing::TempDir()) /
        (std::string("recording-") + testing::UnitTest::GetInstance()->current_test_info()->name()))
  {
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "data.xyz") << "1\n\nAr 0 0 0\n";
    path = (folder / "a.rec").string();
    start.data.files = {(folder / "data.xyz").string()};
  }
  ~RecordingTest() override { std::filesystem::remove_all(folder); }

  std::filesystem::path folder;
  std::string path;
  Settings start;
};

RecordedEvent eventWith(Kind kind, const Settings& before, const Settings& after)
{
  RecordedEvent event;
  event.kind = kind;
  event.changes = changesBetween(before, after);
  return event;
}

} // namespace

TEST_F(RecordingTest, LinesComeBack)
{
  Settings changed = start;
  changed.color.map = "plasma";
  changed.selection.ranges = {{"x", {{0.1, 1e300}}}};
  changed.camera.camera = {1.0 / 3.0, 2, 3, 0, 0, 0, 0, 0, 1, 30};
  changed.output.speed = 3.0;
  changed.film.orbit = 90.0;
  std::vector<RecordedEvent> events;
  for (const Kind kind :
    {Kind::Change, Kind::Drag, Kind::Camera, Kind::Pass, Kind::Did, Kind::Refused, Kind::Seen})
    events.push_back(eventWith(kind, start, changed));
  events.push_back({.kind = Kind::Release});
  events.push_back({.kind = Kind::Action, .action = Action::HidePicked});
  events.push_back({.kind = Kind::Action, .action = Action::PickMore, .at = {0.25, -1.5}});
  events.push_back({.kind = Kind::Rectangle, .at = {0.25, 0.5}, .to = {1, 0}, .isThrough = true});
  events.push_back({.kind = Kind::Open, .adds = true, .files = start.data.files});
  events.push_back({.kind = Kind::Window, .window = {{640, 400}, {320, 400}, false, true}});
  events.push_back({.kind = Kind::End, .time = 3.25});
  {
    RecordingFile file(path, start, {{900, 700}, {580, 700}, true, false});
    for (const RecordedEvent& event : events)
      file.add(event);
  }
  const Recording recording = readRecording(path);
  EXPECT_TRUE(recording.hasEnd);
  EXPECT_EQ(recording.start, start);
  EXPECT_EQ(recording.window, (WindowState{{900, 700}, {580, 700}, true, false}));
  EXPECT_EQ(recording.events, events);
}

TEST_F(RecordingTest, EveryActionThatIsRecordedComesBack)
{
  int count = 0;
  for (int i = 0; i <= static_cast<int>(Action::Quit); ++i)
  {
    RecordedEvent event{.kind = Kind::Action, .action = static_cast<Action>(i)};
    if (!isRecorded(event.action))
      continue;
    ++count;
    EXPECT_EQ(eventOf(lineOf(event, path), path, "here"), event) << i;
  }
  EXPECT_GT(count, 10);
}

TEST_F(RecordingTest, TheLastSettingsAreTold)
{
  Settings first = start, second = start, inForce = start;
  first.color.map = "plasma";
  second = first;
  second.light.shadows = "hard";
  inForce = first;
  inForce.color.range = {1.0, 2.0};
  inForce.camera.camera = {1, 2, 3, 0, 0, 0, 0, 0, 1, 30};
  {
    RecordingFile file(path, start, {{900, 700}, {580, 700}, true, false});
    file.add(eventWith(Kind::Change, start, first));
    file.add(eventWith(Kind::Seen, first, inForce));
    file.add({.kind = Kind::Window, .window = {{640, 400}, {320, 400}, true, false}});
    file.add(eventWith(Kind::Change, first, second));
  }
  const Recording recording = readRecording(path);
  EXPECT_FALSE(recording.hasEnd);
  // What was seen holds on, where nothing of its group was changed since.
  Settings wanted = second;
  wanted.color.range = inForce.color.range;
  wanted.camera.camera = inForce.camera.camera;
  wanted.picture.size = {320, 400};
  EXPECT_EQ(recording.last(), wanted);
  Settings third = second;
  third.color.array = "other";
  std::ofstream(path, std::ios::app)
    << lineOf(eventWith(Kind::Change, second, third), path) << "\n";
  wanted.color = third.color;
  EXPECT_EQ(readRecording(path).last(), wanted);
}

TEST_F(RecordingTest, FilesThatAreWrittenAreNotRecorded)
{
  Settings other = start;
  other.output.file = "film.ogv";
  other.output.session = "s.json";
  other.output.record = "b.rec";
  other.output.play = "c.rec";
  other.output.playSpeed = 7.0;
  EXPECT_TRUE(changesBetween(start, other).empty());
}

TEST_F(RecordingTest, AnyEndIsReadAsFarAsItGoes)
{
  Settings changed = start;
  changed.color.map = "plasma";
  {
    RecordingFile file(path, start, {});
    file.add(eventWith(Kind::Change, start, changed));
    file.add({.kind = Kind::End});
  }
  std::ifstream file(path, std::ios::binary);
  const std::string whole((std::istreambuf_iterator<char>(file)), {});
  const std::size_t header = whole.find('\n');
  for (std::size_t length = 0; length <= whole.size(); ++length)
  {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << whole.substr(0, length);
    if (length < header)
    {
      EXPECT_THROW(readRecording(path), Failure) << length;
      continue;
    }
    Recording recording;
    EXPECT_NO_THROW(recording = readRecording(path)) << length;
    EXPECT_LE(recording.events.size(), 2u);
    EXPECT_EQ(recording.hasEnd, recording.events.size() == 2) << length;
  }
}
