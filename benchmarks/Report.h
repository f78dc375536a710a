#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace mote::bench
{

/// One measurement: keys and values in the order in which they are written.
using Value = std::variant<std::string, std::int64_t, double>;
using Record = std::vector<std::pair<std::string, Value>>;

/// Text in columns; the first row is the head. The first columns are words, the others numbers.
class Table
{
public:
  explicit Table(std::size_t words = 1)
    : words_(words)
  {
  }
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  std::string text() const;

private:
  std::size_t words_;
  std::vector<std::vector<std::string>> rows_;
};

/// A table, what stands above it and what below.
struct Section
{
  std::string title; ///< may be empty
  Table table{};
  std::vector<std::string> notes{};
};

/// What a suite hands back.
struct Report
{
  std::vector<Section> sections;
  std::vector<Record> records;
};

/// The section as it is printed.
std::string toText(const Section& section);

/// The records as a JSON array. Numbers that JSON cannot say become null.
std::string toJson(const std::vector<Record>& records);

/// printf into a string.
[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...);

/// One line of progress to stderr.
[[gnu::format(printf, 1, 2)]] void progress(const char* pattern, ...);

} // namespace mote::bench
