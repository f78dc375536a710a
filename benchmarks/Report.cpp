#include "Report.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace mote::bench
{

std::string Table::text() const
{
  std::vector<std::size_t> widths;
  for (const auto& row : rows_)
  {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t c = 0; c < row.size(); ++c)
      widths[c] = std::max(widths[c], row[c].size());
  }
  std::string out;
  for (const auto& row : rows_)
  {
    for (std::size_t c = 0; c < row.size(); ++c)
    {
      // Numbers stand under one another by their right end; what begins a row is words.
      const std::string gap(widths[c] - row[c].size(), ' ');
      const bool words = c < words_;
      out += (c > 0 ? "  " : "") + (words ? row[c] + gap : gap + row[c]);
    }
    out += '\n';
  }
  return out;
}

namespace
{

using Json = nlohmann::ordered_json;

struct ToJson
{
  Json operator()(const std::string& v) const { return v; }
  Json operator()(std::int64_t v) const { return v; }
  /// Six digits: more would be noise. What is not finite becomes null.
  Json operator()(double v) const { return std::isfinite(v) ? std::stod(format("%.6g", v)) : v; }
};

std::string formatList(const char* pattern, va_list list)
{
  va_list copy;
  va_copy(copy, list);
  const int size = std::vsnprintf(nullptr, 0, pattern, copy);
  va_end(copy);
  std::string out(static_cast<std::size_t>(std::max(size, 0)), '\0');
  std::vsnprintf(out.data(), out.size() + 1, pattern, list);
  return out;
}

} // namespace

std::string toText(const Section& section)
{
  std::string out = section.title.empty() ? "" : section.title + "\n\n";
  out += section.table.text();
  for (const std::string& note : section.notes)
    out += note + '\n';
  return out;
}

std::string toJson(const std::vector<Record>& records)
{
  std::string out = "[";
  for (std::size_t i = 0; i < records.size(); ++i)
  {
    Json line;
    for (const auto& [key, value] : records[i])
      line[key] = std::visit(ToJson(), value);
    out += (i > 0 ? ",\n  " : "\n  ") + line.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  return out + "\n]\n";
}

std::string format(const char* pattern, ...)
{
  va_list list;
  va_start(list, pattern);
  std::string out = formatList(pattern, list);
  va_end(list);
  return out;
}

void progress(const char* pattern, ...)
{
  va_list list;
  va_start(list, pattern);
  const std::string text = formatList(pattern, list);
  va_end(list);
  std::fprintf(stderr, "mote-bench: %s\n", text.c_str());
}

} // namespace mote::bench
