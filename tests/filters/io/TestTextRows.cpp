#include "FileError.h"
#include "IOTestSupport.h"
#include "TextRows.h"

#include <atomic>
#include <tbb/global_control.h>
#include <vector>

namespace
{

using mote::ColumnType;
using mote::FileError;
using mote::TextColumn;
using mote::TextCursor;

class TestTextRows : public FileTest
{
protected:
  /// What reading `rows` rows of a text as "a" (int) and "b" (double) throws.
  std::string failure(const std::string& text, std::uint64_t rows) const
  {
    std::vector<std::int64_t> a(rows);
    std::vector<double> b(rows);
    TextCursor cursor(write("rows", text), TextCursor::OpenEnd::Accept);
    try
    {
      mote::readRows(cursor, rows,
        {{"a", ColumnType::Int64, a.data(), 1}, {"b", ColumnType::Float64, b.data(), 1}}, {}, {});
    }
    catch (const FileError& error)
    {
      return error.what();
    }
    return "nothing";
  }
};

TEST_F(TestTextRows, EveryTypeAndStride)
{
  TextCursor cursor(write("rows", "1 2 3.5 4.25 word skipped\n\t-1   -2 nan 1e3 other x \r\n"));
  std::vector<std::int32_t> a(2);
  std::vector<std::int64_t> b(2);
  std::vector<float> c(4, 0.0F);
  std::vector<double> d(2);
  std::vector<std::string> e(2);
  const std::vector<TextColumn> columns = {{"a", ColumnType::Int32, a.data(), 1},
    {"b", ColumnType::Int64, b.data(), 1}, {"c", ColumnType::Float32, c.data() + 1, 2},
    {"d", ColumnType::Float64, d.data(), 1}, {"e", ColumnType::String, e.data(), 1},
    {"f", ColumnType::Skip, nullptr, 1}};
  EXPECT_TRUE(mote::readRows(cursor, 2, columns, {}, {}).complete);
  EXPECT_EQ(a, (std::vector<std::int32_t>{1, -1}));
  EXPECT_EQ(b, (std::vector<std::int64_t>{2, -2}));
  EXPECT_EQ(c[0], 0.0F);
  EXPECT_EQ(c[1], 3.5F);
  EXPECT_TRUE(c[3] != c[3]);
  EXPECT_EQ(d, (std::vector<double>{4.25, 1000.0}));
  EXPECT_EQ(e, (std::vector<std::string>{"word", "other"}));
  EXPECT_EQ(cursor.line(), 3u);
}

TEST_F(TestTextRows, ManyPiecesManyThreads)
{
  constexpr int Rows = 600000;
  std::string text;
  for (int i = 0; i < Rows; ++i)
    text += std::to_string(i) + ' ' + std::to_string(0.5 * i) + " filling filling filling\n";
  text += "after\n";
  for (const std::string& file : {write("rows", text), writeGzip("rows.gz", text)})
  {
    for (const std::size_t threads : {1, 2, 5})
    {
      tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      std::vector<std::int64_t> a(Rows);
      std::vector<double> b(Rows);
      std::atomic<std::uint64_t> stored{0};
      TextCursor cursor(file);
      mote::readRows(cursor, Rows,
        {{"a", ColumnType::Int64, a.data(), 1}, {"b", ColumnType::Float64, b.data(), 1}, {"c"},
          {"d"}, {"e"}},
        [&](std::uint64_t, std::uint64_t count) { stored += count; }, {});
      EXPECT_EQ(stored, static_cast<std::uint64_t>(Rows));
      for (int i = 0; i < Rows; ++i)
      {
        ASSERT_EQ(a[i], i);
        ASSERT_EQ(b[i], 0.5 * i);
      }
      std::string_view line;
      ASSERT_TRUE(cursor.nextLine(line));
      EXPECT_EQ(line, "after");
    }
  }
}

TEST_F(TestTextRows, ErrorsNameLineAndColumn)
{
  EXPECT_NE(
    failure("1 2\n3 x4\n", 2).find("rows, line 2, column 3: expected a number for 'b', found 'x4'"),
    std::string::npos);
  EXPECT_NE(failure("1 2\n3\n", 2)
              .find("line 2, column 2: expected 2 values, found only 1 ('b' is "
                    "missing)"),
    std::string::npos);
  EXPECT_NE(failure("1 2\n\n3 4\n", 2).find("line 2, column 1: expected 2 values, found an empty"),
    std::string::npos);
  EXPECT_NE(
    failure("1 2 3\n", 1).find("line 1, column 5: expected 2 values, found 3"), std::string::npos);
  EXPECT_NE(failure("1 2\n", 2).find("line 2: the file ends after 1 of 2 rows"), std::string::npos);
  EXPECT_EQ(failure("1 2", 1), "nothing");
}

TEST_F(TestTextRows, TheFirstErrorOfManyIsReported)
{
  std::string text;
  for (int i = 0; i < 200000; ++i)
    text += i >= 100000 && i % 1000 == 7 ? "1 bad\n" : "1 2\n";
  EXPECT_NE(failure(text, 200000).find("line 100008, column 3:"), std::string::npos);
}

TEST_F(TestTextRows, IntegersThatAreNoneAskForMore)
{
  std::vector<std::int32_t> a(2);
  const std::vector<TextColumn> columns = {{"a", ColumnType::Int32, a.data(), 1}};
  const auto typeFor = [&](const std::string& text)
  {
    TextCursor cursor(write("rows", text));
    const mote::RowsResult result = mote::readRows(cursor, 2, columns, {}, {});
    return result.complete ? ColumnType::Int32 : result.widen.type;
  };
  EXPECT_EQ(typeFor("1\n2\n"), ColumnType::Int32);
  EXPECT_EQ(typeFor("1\n3000000000\n"), ColumnType::Int64);
  EXPECT_EQ(typeFor("1\n1.5\n"), ColumnType::Float64);
}

TEST_F(TestTextRows, WhatAnotherProgramChangesMeanwhileIsNotReadBeyond)
{
  // Lines that were counted are gone, or have become fewer, once the first are parsed.
  for (const char other : {'1', ' ', '\0'})
  {
    const std::uint64_t rows = 262'144; // the file ends with a page
    std::string text;
    for (std::uint64_t i = 0; i < rows; ++i)
      text += "123 5.25 wordword\n"; // of which the last is passed over
    text.resize(text.size() / 4096 * 4096);
    text.back() = '\n';
    const std::string file = write("rows", text);
    TextCursor cursor(file);
    std::vector<std::int64_t> a(rows);
    std::vector<double> b(rows);
    std::atomic<bool> isChanged{false};
    const auto change = [&](std::uint64_t, std::uint64_t)
    {
      if (isChanged.exchange(true))
        return;
      std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
      stream << std::string(text.size(), other);
    };
    EXPECT_THROW(mote::readRows(cursor, rows,
                   {{"a", ColumnType::Int64, a.data(), 1}, {"b", ColumnType::Float64, b.data(), 1},
                     {"c", ColumnType::Skip, nullptr, 1}},
                   change, {}),
      FileError);
  }
}

TEST_F(TestTextRows, StopsWhenAsked)
{
  TextCursor cursor(write("rows", "1\n2\n"));
  EXPECT_THROW(mote::readRows(cursor, 2, {{"a"}}, {}, [](double) { return false; }), FileError);
}

} // namespace
