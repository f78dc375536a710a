#include "Text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>

namespace mote::app
{

namespace
{

std::string formatted(const char* format, double value)
{
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

} // namespace

std::string withThousands(std::int64_t value)
{
  std::string digits = std::to_string(value);
  const std::size_t first = value < 0 ? 1 : 0;
  for (std::size_t i = digits.size(); i > first + 3; i -= 3)
    digits.insert(i - 3, 1, ',');
  return digits;
}

std::string counted(std::int64_t count, const std::string& thing)
{
  return withThousands(count) + " " + thing + (count == 1 ? "" : "s");
}

std::string asBytes(double bytes)
{
  const char* const units[] = {"B", "kB", "MB", "GB", "TB"};
  int unit = 0;
  for (; bytes >= 999.5 && unit < 4; ++unit)
    bytes /= 1000.0;
  return formatted(unit > 0 && bytes < 9.95 ? "%.1f " : "%.0f ", bytes) + units[unit];
}

std::string asDuration(double seconds)
{
  if (seconds < 0.0995)
    return formatted(seconds < 0.00095 ? "%.1f ms" : "%.0f ms", 1000.0 * seconds);
  if (seconds < 99.95)
    return formatted(seconds < 9.95 ? "%.2f s" : "%.1f s", seconds);
  const auto whole = static_cast<long long>(std::min(std::round(seconds), 1e15));
  const auto two = [](long long large, const char* its, long long small, const char* own)
  { return std::to_string(large) + its + std::to_string(small) + own; };
  return whole < 6000 ? two(whole / 60, " min ", whole % 60, " s")
                      : two(whole / 3600, " h ", whole % 3600 / 60, " min");
}

std::string stepText(int step, int steps)
{
  return steps > 1 ? "step " + std::to_string(step + 1) + "/" + std::to_string(steps) + ", " : "";
}

std::string asNumber(double value, int digits)
{
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*g", digits, value);
  return buffer;
}

std::string baseName(const std::string& path)
{
  namespace fs = std::filesystem;
  fs::path file = path;
  std::error_code error;
  const fs::path name = file.filename();
  if (!path.empty() && (name.empty() || name == "." || name == ".."))
    file = (fs::current_path(error) / file / ".").lexically_normal().parent_path();
  return file.filename().string();
}

std::string joined(const std::vector<std::string>& words, const std::string& separator)
{
  std::string text;
  for (const std::string& word : words)
    text += (text.empty() ? "" : separator) + word;
  return text;
}

std::vector<std::string> shortestEnds(const std::vector<std::vector<std::string>>& paths)
{
  const auto endOf = [](const std::vector<std::string>& path, std::size_t count) {
    return joined({path.end() - std::ptrdiff_t(std::min(count, path.size())), path.end()}, "/");
  };
  std::vector<std::string> ends(paths.size());
  std::vector<std::size_t> counts(paths.size(), 1);
  for (bool isChanged = true; isChanged;)
  {
    isChanged = false;
    std::map<std::string, int> known;
    for (std::size_t i = 0; i < paths.size(); ++i)
      ++known[ends[i] = endOf(paths[i], counts[i])];
    for (std::size_t i = 0; i < paths.size(); ++i)
      if (known[ends[i]] > 1 && counts[i] < paths[i].size())
      {
        ++counts[i];
        isChanged = true;
      }
  }
  return ends;
}

std::string oneLine(std::string text)
{
  for (char& c : text)
    c = static_cast<unsigned char>(c) < ' ' || c == '\x7f' ? '?' : c;
  return text;
}

std::string wrapped(const std::string& text, std::size_t columns)
{
  std::string all, line;
  std::istringstream lines(text);
  for (bool first = true; std::getline(lines, line); first = false)
  {
    all += first ? "" : "\n";
    while (line.size() > columns)
    {
      std::size_t end = line.rfind(' ', columns);
      if (end == line.npos || end == 0)
        end = line.find(' ', columns);
      if (end == line.npos)
        break;
      all += line.substr(0, end) + "\n";
      line.erase(0, end + 1);
    }
    all += line;
  }
  return all;
}

std::string inQuotes(const std::string& word, char separator)
{
  if (word.find_first_of(std::string("\"\n") + separator) == std::string::npos)
    return word;
  std::string text = "\"";
  for (const char c : word)
    text.append(c == '"' ? 2 : 1, c);
  return text.append("\"");
}

std::string lowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool parseNumber(const std::string& text, double& value)
{
  if (text.empty() || std::isspace(static_cast<unsigned char>(text.front())))
    return false;
  char* end = nullptr;
  value = std::strtod(text.c_str(), &end);
  return *end == '\0' && std::isfinite(value);
}

} // namespace mote::app
