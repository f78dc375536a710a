#include "TextLines.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace mote::imaging
{
namespace
{

std::vector<std::string> breakLines(TextFont& font, const std::string& text, int size, double width)
{
  std::vector<std::string> lines;
  std::istringstream paragraphs(text);
  for (std::string paragraph; std::getline(paragraphs, paragraph);)
  {
    std::istringstream words(paragraph);
    std::string line;
    for (std::string word; words >> word;)
    {
      const std::string longer = line.empty() ? word : line + " " + word;
      if (!line.empty() && font.width(longer, size) > width)
      {
        lines.push_back(line);
        line = word;
      }
      else
      {
        line = longer;
      }
    }
    lines.push_back(line);
  }
  return lines;
}

} // namespace

std::string cutText(TextFont& font, const std::string& text, int size, double width)
{
  if (font.width(text, size) <= width)
  {
    return text;
  }
  std::string cut = text;
  while (!cut.empty())
  {
    while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xc0) == 0x80)
    {
      cut.pop_back(); // the tail of a character in UTF-8
    }
    cut.resize(cut.size() - std::min<std::size_t>(1, cut.size()));
    if (font.width(cut + "\u2026", size) <= width)
    {
      return cut + "\u2026";
    }
  }
  return "";
}

TextLines wrapText(TextFont& font, const std::string& text, int size, double width, int most)
{
  TextLines result;
  const int smallest = std::min(size, std::max(8, static_cast<int>(std::lround(0.7 * size))));
  for (result.size = size;; --result.size)
  {
    result.lines = breakLines(font, text, result.size, width);
    const bool fits = static_cast<int>(result.lines.size()) <= most &&
                      std::all_of(result.lines.begin(), result.lines.end(),
                                  [&](const std::string& line)
                                  { return font.width(line, result.size) <= width; });
    if (fits || result.size <= smallest)
    {
      break;
    }
  }
  if (static_cast<int>(result.lines.size()) > most)
  {
    result.lines.resize(most);
    result.lines.back() += "\u2026";
  }
  for (std::string& line : result.lines)
  {
    line = cutText(font, line, result.size, width);
  }
  return result;
}

} // namespace mote::imaging
