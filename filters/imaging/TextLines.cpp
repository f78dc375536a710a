#include "TextLines.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace mote::imaging
{
namespace
{

/// Words of a line; a unit in brackets, "(km s⁻¹)", is one as long as it fits.
std::vector<std::string> splitWords(TextFont& font, const std::string& text, int size, double width)
{
  std::istringstream stream(text);
  std::vector<std::string> words;
  std::string open; // the beginning of a bracket that is not closed yet
  for (std::string word; stream >> word;)
  {
    const std::string whole = open.empty() ? word : open + " " + word;
    const bool begins = open.empty() && (word[0] == '(' || word[0] == '[');
    const bool ends = word.find_first_of(")]") != std::string::npos;
    if ((begins || !open.empty()) && !ends)
    {
      open = whole;
    }
    else
    {
      words.push_back(whole);
      open.clear();
    }
  }
  if (!open.empty())
    words.push_back(open);
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    const std::size_t space = words[i].find(' ');
    if (space != std::string::npos && font.width(words[i], size) > width)
    {
      words.insert(words.begin() + i + 1, words[i].substr(space + 1));
      words[i].resize(space);
    }
  }
  return words;
}

std::vector<std::string> breakLines(TextFont& font, const std::string& text, int size, double width)
{
  std::vector<std::string> lines;
  std::istringstream paragraphs(text);
  for (std::string paragraph; std::getline(paragraphs, paragraph);)
  {
    if (font.width(paragraph, size) <= width)
    {
      lines.push_back(paragraph); // with all its spaces
      continue;
    }
    std::string line;
    for (const std::string& word : splitWords(font, paragraph, size, width))
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
    return text;
  // How many bytes of the beginning fit, found by halving; a cut never splits a character.
  const auto beginning = [&](std::size_t bytes)
  {
    while (bytes > 0 && (static_cast<unsigned char>(text[bytes]) & 0xc0) == 0x80)
      --bytes;
    return text.substr(0, bytes) + "\u2026";
  };
  std::size_t fitting = 0;
  for (std::size_t tooMany = text.size(); tooMany - fitting > 1;)
  {
    const std::size_t middle = (fitting + tooMany) / 2;
    (font.width(beginning(middle), size) <= width ? fitting : tooMany) = middle;
  }
  const std::string cut = beginning(fitting);
  return font.width(cut, size) <= width ? cut : "";
}

TextLines wrapText(TextFont& font, const std::string& text, int size, double width, int most)
{
  TextLines result;
  const int smallest = std::min(size, std::max(8, static_cast<int>(std::lround(0.7 * size))));
  for (result.size = size;; --result.size)
  {
    result.lines = breakLines(font, text, result.size, width);
    const bool fits =
      static_cast<int>(result.lines.size()) <= most &&
      std::all_of(result.lines.begin(), result.lines.end(),
        [&](const std::string& line) { return font.width(line, result.size) <= width; });
    if (fits || result.size <= smallest)
      break;
  }
  if (static_cast<int>(result.lines.size()) > most)
  {
    result.lines.resize(most);
    result.lines.back() += "\u2026";
  }
  for (std::string& line : result.lines)
    line = cutText(font, line, result.size, width);
  return result;
}

} // namespace mote::imaging
