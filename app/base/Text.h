#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mote::app
{

/// 84270 as "84,270".
std::string withThousands(std::int64_t value);

/// "84,270 particles", "1 particle".
std::string counted(std::int64_t count, const std::string& thing);

/// A count of bytes with a decimal unit: "1.7 MB".
std::string asBytes(double bytes);

/// Seconds with a sensible unit: "35 ms", "2.41 s".
std::string asDuration(double seconds);

/// "step 3/7, " of the third of seven time steps; nothing of one alone.
std::string stepText(int step, int steps);

/// The shortest text with up to `digits` digits: "0.000125", "3000", "1.2e+20".
std::string asNumber(double value, int digits = 6);

/// The file's name without its folders; of a folder such as "run/" or "." its own name.
std::string baseName(const std::string& path);

/// `separator` between the words.
std::string joined(const std::vector<std::string>& words, const std::string& separator);

/// For each path the shortest end that no other has, with "/" between its words: all of it where
/// another path is the same.
std::vector<std::string> shortestEnds(const std::vector<std::vector<std::string>>& paths);

/// A text without line breaks and other control characters, which words of a command line may hold:
/// a question mark stands for each.
std::string oneLine(std::string text);

/// Lines of at most so many characters, broken between words; lines that fit stay as they are.
std::string wrapped(const std::string& text, std::size_t columns);

/// A word as a cell of a table whose cells this character separates: with quotation marks where
/// the word holds it, a quotation mark or the end of a line.
std::string inQuotes(const std::string& word, char separator);

/// Lower-case copy (ASCII).
std::string lowerCase(std::string text);

/// Whether all of the text is one finite number, and which.
bool parseNumber(const std::string& text, double& value);

} // namespace mote::app
