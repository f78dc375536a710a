#include "FileError.h"
#include "IOTestSupport.h"
#include "TextCursor.h"

#include <algorithm>
#include <random>
#include <vector>

namespace
{

using mote::FileError;
using mote::TextCursor;

/// Numbered lines of varying length, some 60 bytes each.
std::string numberedLines(int count)
{
  std::mt19937 random(3);
  std::string text;
  for (int i = 0; i < count; ++i)
  {
    text += std::to_string(i) + ' ' + std::string(random() % 120, static_cast<char>('a' + i % 26));
    text += '\n';
  }
  return text;
}

class TestTextCursor : public FileTest
{
};

TEST_F(TestTextCursor, LinesOfPlainAndGzipAreTheSame)
{
  const std::string text = numberedLines(200000); // several buffers of gzip
  TextCursor plain(write("a.txt", text));
  TextCursor gzip(writeGzip("named-as-if-plain.txt", text));
  std::string_view a;
  std::string_view b;
  std::string joined;
  while (plain.nextLine(a))
  {
    ASSERT_TRUE(gzip.nextLine(b));
    ASSERT_EQ(a, b);
    ASSERT_EQ(plain.offset(), gzip.offset());
    joined.append(a).push_back('\n');
  }
  EXPECT_FALSE(gzip.nextLine(b));
  EXPECT_TRUE(joined == text);
  EXPECT_DOUBLE_EQ(gzip.fraction(), 1.0);
}

TEST_F(TestTextCursor, SeekReturnsToAnyPlace)
{
  const std::string text = numberedLines(400000); // 24 MB: several snapshots
  for (const std::string& file : {write("a.txt", text), writeGzip("a.gz", text)})
  {
    TextCursor cursor(file);
    std::vector<TextCursor::Place> places;
    std::string_view line;
    for (int i = 0; cursor.nextLine(line); ++i)
      if (i % 30011 == 0)
        places.push_back(cursor.place());
    std::reverse(places.begin(), places.end());
    TextCursor other(file);
    for (const TextCursor::Place& place : places)
    {
      other.seek(place);
      EXPECT_EQ(other.line(), place.line);
      ASSERT_TRUE(other.nextLine(line));
      EXPECT_EQ(std::stoull(std::string(line)) + 1, place.line);
    }
    EXPECT_EQ(places.front().snapshot != nullptr, file.ends_with(".gz"));
  }
}

TEST_F(TestTextCursor, BlocksAreWholeLines)
{
  const std::string text = numberedLines(100000);
  for (const std::string& file : {write("a.txt", text), writeGzip("a.gz", text)})
  {
    TextCursor cursor(file);
    std::string joined;
    for (std::string_view block; !(block = cursor.block(1000)).empty();)
    {
      ASSERT_EQ(block.back(), '\n');
      const auto counts = mote::countBytes(block, '\n', 'x');
      ASSERT_EQ(
        counts.first, static_cast<std::uint64_t>(std::count(block.begin(), block.end(), '\n')));
      ASSERT_EQ(
        counts.second, static_cast<std::uint64_t>(std::count(block.begin(), block.end(), 'x')));
      joined += block;
      cursor.advance(block.size(), counts.first);
    }
    EXPECT_TRUE(joined == text);
    EXPECT_EQ(cursor.line(), 100001u);
  }
}

TEST_F(TestTextCursor, LineEnds)
{
  TextCursor cursor(write("a.txt", "one\r\n\r\nthree\n\nfive"), TextCursor::OpenEnd::Accept);
  std::string_view line;
  for (const char* expected : {"one", "", "three", "", "five"})
  {
    ASSERT_TRUE(cursor.nextLine(line));
    EXPECT_EQ(line, expected);
  }
  EXPECT_FALSE(cursor.nextLine(line));
  TextCursor strict(write("b.txt", "one\ntwo"));
  ASSERT_TRUE(strict.nextLine(line));
  try
  {
    strict.nextLine(line);
    FAIL();
  }
  catch (const FileError& error)
  {
    EXPECT_EQ(error.kind(), FileError::Kind::Truncated);
    EXPECT_NE(std::string(error.what()).find("b.txt, line 2: "), std::string::npos);
  }
}

TEST_F(TestTextCursor, LongLinesAndOpenEndsOfGzip)
{
  const std::string longLine(10000000, 'x');
  TextCursor cursor(
    writeGzip("a.gz", "short\n" + longLine + "\nopen"), TextCursor::OpenEnd::Accept);
  std::string_view line;
  ASSERT_TRUE(cursor.nextLine(line));
  ASSERT_TRUE(cursor.nextLine(line));
  EXPECT_TRUE(line == longLine);
  ASSERT_TRUE(cursor.nextLine(line));
  EXPECT_EQ(line, "open");
  EXPECT_FALSE(cursor.nextLine(line));
}

TEST_F(TestTextCursor, SeveralGzipMembersAreOneText)
{
  writeGzip("a.gz", "one\ntw");
  TextCursor cursor(writeGzip("a.gz", "o\nthree\n", true));
  std::string_view line;
  for (const char* expected : {"one", "two", "three"})
  {
    ASSERT_TRUE(cursor.nextLine(line));
    EXPECT_EQ(line, expected);
  }
  EXPECT_FALSE(cursor.nextLine(line));
}

/// A gzip member of so many bytes, for which its head has a long name. The text is not packed.
std::string memberOf(const std::string& text, std::size_t bytes)
{
  const auto make = [&](const std::string& name)
  {
    z_stream z = {};
    gz_header head = {};
    head.name = reinterpret_cast<Bytef*>(const_cast<char*>(name.c_str()));
    deflateInit2(&z, 0, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
    deflateSetHeader(&z, &head);
    std::string packed(text.size() + name.size() + 4096, '\0');
    z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
    z.avail_in = static_cast<uInt>(text.size());
    z.next_out = reinterpret_cast<Bytef*>(packed.data());
    z.avail_out = static_cast<uInt>(packed.size());
    EXPECT_EQ(deflate(&z, Z_FINISH), Z_STREAM_END);
    packed.resize(z.total_out);
    deflateEnd(&z);
    return packed;
  };
  return make(std::string(bytes - make("").size(), 'n'));
}

TEST_F(TestTextCursor, MembersMayEndWhereABufferDoes)
{
  constexpr std::size_t buffer = 256 * 1024; // of GzipStream
  const std::string first(buffer - 5000, 'a');
  for (const std::size_t bytes : {buffer - 1, buffer, buffer + 1})
  {
    const std::string member = memberOf(first + '\n', bytes);
    ASSERT_EQ(member.size(), bytes);
    TextCursor cursor(write("a.gz", member + memberOf("second\n", 2000)));
    std::string_view line;
    ASSERT_TRUE(cursor.nextLine(line));
    EXPECT_EQ(line.size(), first.size());
    ASSERT_TRUE(cursor.nextLine(line)) << bytes;
    EXPECT_EQ(line, "second");
    EXPECT_FALSE(cursor.nextLine(line));
  }
}

TEST_F(TestTextCursor, ZerosBehindGzipAreItsEnd)
{
  TextCursor cursor(write("a.gz", memberOf("one\n", 2000) + std::string(512, '\0')));
  std::string_view line;
  ASSERT_TRUE(cursor.nextLine(line));
  EXPECT_EQ(line, "one");
  EXPECT_FALSE(cursor.nextLine(line));
}

TEST_F(TestTextCursor, TruncatedGzipGivesWhatItHasAndThenThrows)
{
  const std::string text = numberedLines(1000);
  writeGzip("a.gz", text);
  truncate("a.gz", std::filesystem::file_size(path("a.gz")) / 2);
  TextCursor cursor(path("a.gz"));
  std::string_view line;
  int lines = 0;
  try
  {
    while (cursor.nextLine(line))
      ++lines;
    FAIL();
  }
  catch (const FileError& error)
  {
    EXPECT_EQ(error.kind(), FileError::Kind::Truncated) << error.what();
  }
  EXPECT_GT(lines, 100);
}

TEST_F(TestTextCursor, FilesThatCannotBeOpened)
{
  const auto kindOf = [](const std::string& file)
  {
    try
    {
      TextCursor cursor(file);
      return FileError::Kind::Aborted;
    }
    catch (const FileError& error)
    {
      return error.kind();
    }
  };
  EXPECT_EQ(kindOf(path("missing")), FileError::Kind::NotFound);
  EXPECT_EQ(kindOf(path("")), FileError::Kind::CannotOpen);
  EXPECT_EQ(kindOf("/dev/null"), FileError::Kind::CannotOpen);
  std::string_view line;
  EXPECT_FALSE(TextCursor(write("empty", "")).nextLine(line));
}

} // namespace
