#include "PDBCheck.h"

#include "FileError.h"
#include "ParseNumber.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>

namespace mote
{
namespace
{

// Columns of the format (wwPDB, Atomic Coordinate Entry Format 3.3), from 0.
constexpr std::size_t CoordinatesBegin = 30;
constexpr std::size_t CoordinateWidth = 8;
constexpr std::size_t CoordinatesEnd = 54;
constexpr std::size_t ElementEnd = 78; ///< only an optional charge follows
constexpr std::size_t MasterAtoms = 50;
constexpr std::size_t MasterWidth = 5;

/// What has been seen of a file.
struct Walk
{
  const std::string& path;
  std::uint64_t line = 0;
  std::int64_t atoms = 0;

  [[noreturn]] void refuse(
    FileError::Kind kind, const std::string& sentence, std::size_t column = 0) const
  {
    throw FileError(kind, this->path, sentence, this->line, column);
  }
};

/// The name of a record: its first word of up to six characters, in upper case.
std::string recordName(std::string_view line)
{
  std::string name;
  for (const char c : line.substr(0, 6))
    if (!endsToken(c))
      name.push_back(static_cast<char>(std::toupper(static_cast<unsigned char>(c))));
    else if (!name.empty())
      break;
  return name;
}

/// The columns of a field without blanks around the value, and with an end for the parsers.
std::string field(std::string_view line, std::size_t begin, std::size_t width)
{
  std::string_view text = line.substr(std::min(begin, line.size()), width);
  const std::size_t first = text.find_first_not_of(' ');
  text = first == text.npos ? std::string_view() : text.substr(first);
  return std::string(text.substr(0, text.find_last_not_of(' ') + 1));
}

void checkAtom(const Walk& walk, std::string_view line)
{
  if (line.size() < CoordinatesEnd)
  {
    walk.refuse(FileError::Kind::Malformed,
      "the record of an atom ends after " + std::to_string(line.size()) +
        " columns, and its coordinates take " + std::to_string(CoordinatesEnd));
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t begin = CoordinatesBegin + axis * CoordinateWidth;
    const std::string text = field(line, begin, CoordinateWidth);
    double value = 0;
    const char* const end = parseDouble(text.c_str(), value);
    if (!end || *end != '\0')
    {
      std::string sentence = "expected a number for '";
      sentence.append(1, static_cast<char>('x' + axis))
        .append("', found '")
        .append(text)
        .append("'");
      walk.refuse(FileError::Kind::Malformed, sentence, begin + 1);
    }
  }
}

/// A last line without a line end may still be whole.
void checkOpenEnd(const Walk& walk, const std::string& record, std::string_view line)
{
  if (record != "END" && line.size() < ElementEnd)
  {
    walk.refuse(FileError::Kind::Truncated,
      "the last line has no line end, so the file may have been cut short");
  }
}

/// MASTER counts the atoms, in entries of several models often those of the first one only.
void checkMaster(const Walk& walk, std::string_view line)
{
  const std::string text = field(line, MasterAtoms, MasterWidth);
  std::int64_t count = 0;
  const char* const end = parseInteger(text.c_str(), count);
  // More atoms are no sign of a cut: programs that add hydrogens leave the record as it was.
  if (end && *end == '\0' && walk.atoms < count)
  {
    walk.refuse(FileError::Kind::Truncated, "the MASTER record counts " + std::to_string(count) +
                                              " atoms, but the file has " +
                                              std::to_string(walk.atoms));
  }
}

/// The time in a title, "Protein in water t= 10.00000 step= 5000".
std::optional<double> timeIn(std::string_view title)
{
  const std::size_t at = title.rfind("t=");
  if (at == title.npos)
    return {};
  const std::string text = field(title, at + 2, 32) + '\n';
  double value = 0;
  const char* const end = parseDouble(text.c_str(), value);
  return end && endsToken(*end) ? std::optional(value) : std::nullopt;
}

/// The box of a record CRYST1, of three lengths and the angles between b and c, a and c, a and b.
/// None for 1 by 1 by 1, which stands for no box, and for what is no box.
std::optional<std::array<double, 9>> boxIn(std::string_view line)
{
  constexpr std::array<std::size_t, 7> begins = {6, 15, 24, 33, 40, 47, 54};
  constexpr std::size_t groupWidth = 11;
  if (const std::string group = field(line, begins[6], groupWidth);
      !group.empty() && group != "P 1")
    return {};
  std::array<double, 6> values{};
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const std::string text = field(line, begins[i], begins[i + 1] - begins[i]);
    const char* const end = parseDouble(text.c_str(), values[i]);
    if (!end || *end != '\0' || !(values[i] > 0.0 && values[i] < 1e9))
      return {};
  }
  const auto [a, b, c, alpha, beta, gamma] = values;
  if (a == 1.0 && b == 1.0 && c == 1.0)
    return {};
  // A right angle has a cosine of 0, and not nearly so.
  const auto cosine = [](double degrees)
  { return degrees == 90.0 ? 0.0 : std::cos(degrees * std::numbers::pi / 180.0); };
  const double cosGamma = cosine(gamma), sinGamma = std::sqrt(1.0 - cosGamma * cosGamma);
  const double x = cosine(beta), y = (cosine(alpha) - x * cosGamma) / sinGamma;
  const double height = 1.0 - x * x - y * y;
  if (!(sinGamma > 1e-6 && height > 1e-6)) // or flat
    return {};
  return std::array<double, 9>{
    a, 0.0, 0.0, b * cosGamma, b * sinGamma, 0.0, c * x, c * y, c * std::sqrt(height)};
}

/// Tells models apart, record by record.
class Models
{
public:
  /// A line of the text from `begin` to `end`.
  void add(const std::string& record, std::string_view line, std::size_t begin, std::size_t end)
  {
    if (record == "ATOM" || record == "HETATM")
      hasAtoms_ = true;
    else if (record == "TITLE")
      present_.time = timeIn(line);
    else if (record == "CRYST1")
      present_.box = boxIn(line);
    else if (record == "MODEL" && found_.models.empty() && !isBegun_)
    {
      found_.head = present_.begin = begin;
      isBegun_ = true;
    }
    last_ = end;
    if (record == "ENDMDL" || record == "END")
      this->close();
  }
  PDBModels found()
  {
    this->close();
    // What follows the last one, such as bonds, is looked at with it.
    if (!found_.models.empty())
      found_.models.back().end = last_;
    return found_;
  }

private:
  void close()
  {
    if (hasAtoms_)
    {
      present_.end = last_;
      found_.models.push_back(present_);
      present_ = {last_, 0, {}, present_.box}; // said once, it holds for all
    }
    hasAtoms_ = false;
  }

  PDBModels found_;
  PDBModel present_;
  bool hasAtoms_ = false, isBegun_ = false;
  std::size_t last_ = 0;
};

} // namespace

void requireFewBonds(std::string_view model, const std::string& path)
{
  constexpr std::uint64_t mostPairs = 50'000'000;
  // Two atoms within a cell of half an angstrom are a bond, whatever they are.
  std::vector<std::array<std::int64_t, 3>> cells;
  for (std::size_t begin = 0; begin < model.size();)
  {
    const std::size_t end = std::min(model.find('\n', begin), model.size());
    const std::string_view line = model.substr(begin, end - begin);
    begin = end + 1;
    if (const std::string record = recordName(line); record != "ATOM" && record != "HETATM")
      continue;
    auto& cell = cells.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      double value = 0;
      parseDouble(
        field(line, CoordinatesBegin + axis * CoordinateWidth, CoordinateWidth).c_str(), value);
      cell[axis] = static_cast<std::int64_t>(std::floor(std::clamp(2.0 * value, -1e15, 1e15)));
    }
  }
  if (cells.size() * cells.size() / 2 <= mostPairs)
    return;
  std::sort(cells.begin(), cells.end());
  std::uint64_t pairs = 0, before = 0;
  for (std::size_t i = 1; i < cells.size(); ++i)
  {
    before = cells[i] == cells[i - 1] ? before + 1 : 0;
    pairs += before;
  }
  if (pairs > mostPairs)
    throw FileError(FileError::Kind::Malformed, path,
      "atoms lie so close together that there are more than 50 million bonds; coordinates of PDB "
      "are "
      "in angstroms");
}

std::string PDBModels::textOf(std::string_view text, std::size_t model) const
{
  const PDBModel& one = models[model];
  return std::string(text.substr(0, head)) +
         std::string(text.substr(one.begin, one.end - one.begin));
}

PDBModels checkPDB(std::string_view text, const std::string& path)
{
  Walk walk{path};
  Models models;
  std::string_view rest = text;
  while (!rest.empty())
  {
    ++walk.line;
    const std::size_t begin = text.size() - rest.size();
    const std::size_t end = rest.find('\n');
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == rest.npos ? rest.size() : end + 1);
    line = line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
    const std::string record = recordName(line);
    if (end == std::string_view::npos)
      checkOpenEnd(walk, record, line);
    if (record == "ATOM" || record == "HETATM")
    {
      checkAtom(walk, line);
      ++walk.atoms;
    }
    else if (record == "MASTER")
    {
      checkMaster(walk, line);
    }
    models.add(record, line, begin, text.size() - rest.size());
  }
  return models.found();
}

} // namespace mote
