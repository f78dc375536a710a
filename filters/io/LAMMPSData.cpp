#include "LAMMPSData.h"

#include "ParseNumber.h"
#include "TextRows.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

namespace mote
{
namespace
{

using Names = std::vector<std::string>;

/// Columns of the lines of atoms, by their style.
const std::pair<const char*, Names> styles[] = {
  {"atomic", {"id", "type", "x", "y", "z"}},
  {"body", {"id", "type", "bodyflag", "mass", "x", "y", "z"}},
  {"bpm/sphere", {"id", "mol", "type", "diameter", "density", "x", "y", "z"}},
  {"charge", {"id", "type", "q", "x", "y", "z"}},
  {"dipole", {"id", "type", "q", "x", "y", "z", "mux", "muy", "muz"}},
  {"dpd", {"id", "type", "theta", "x", "y", "z"}},
  {"edpd", {"id", "type", "temperature", "cv", "x", "y", "z"}},
  {"electron", {"id", "type", "q", "spin", "eradius", "x", "y", "z"}},
  {"ellipsoid", {"id", "type", "ellipsoidflag", "density", "x", "y", "z"}},
  {"full", {"id", "mol", "type", "q", "x", "y", "z"}},
  {"line", {"id", "mol", "type", "lineflag", "density", "x", "y", "z"}},
  {"mdpd", {"id", "type", "rho", "x", "y", "z"}},
  {"molecular", {"id", "mol", "type", "x", "y", "z"}},
  {"peri", {"id", "type", "volume", "density", "x", "y", "z"}},
  {"sph", {"id", "type", "rho", "esph", "cv", "x", "y", "z"}},
  {"sphere", {"id", "type", "diameter", "density", "x", "y", "z"}},
  {"spin", {"id", "type", "x", "y", "z", "spx", "spy", "spz", "sp"}},
  {"tdpd", {"id", "type", "x", "y", "z"}},
  {"template", {"id", "mol", "type", "template", "atom", "x", "y", "z"}},
  {"tri", {"id", "mol", "type", "triangleflag", "density", "x", "y", "z"}},
};

/// The columns of a style; empty for one that is not known. Those of a hybrid one begin like those
/// of "atomic"; so do those of "tdpd", and concentrations follow.
Names columnsOf(const std::string& style)
{
  const std::string known = style == "angle" || style == "bond" ? "molecular"
                            : style == "hybrid"                 ? "atomic"
                                                                : style;
  const auto found = std::find_if(
    std::begin(styles), std::end(styles), [&](const auto& one) { return one.first == known; });
  return found == std::end(styles) ? Names() : found->second;
}

bool isInteger(const std::string& text)
{
  std::int64_t value = 0;
  const char* const end = parseInteger(text.c_str(), value);
  return end && *end == '\0';
}

/// The style of a line of atoms that does not say it.
std::string guessedStyle(const Names& values)
{
  const bool isThird = values.size() > 2 && isInteger(values[2]);
  switch (values.size())
  {
  case 5:
  case 8:
    return "atomic";
  case 6:
  case 9:
    return isThird ? "molecular" : "charge";
  case 7:
  case 10:
    return isThird ? "full" : "sphere";
  default:
    return "";
  }
}

/// A line without its comment and the blanks around it.
std::string_view bare(std::string_view line)
{
  line = line.substr(0, line.find('#'));
  while (!line.empty() && endsToken(line.back()))
    line.remove_suffix(1);
  while (!line.empty() && endsToken(line.front()))
    line.remove_prefix(1);
  return line;
}

/// What a comment says behind `mark`, up to a comma or its end: "timestep = 5, units = metal".
std::string saidIn(std::string_view comment, std::string_view mark)
{
  const std::size_t at = comment.find(mark);
  if (at == comment.npos)
    return "";
  std::string_view rest = comment.substr(at + mark.size());
  return std::string(bare(rest.substr(0, rest.find(','))));
}

/// Reads the file from its beginning to its end.
class DataFile
{
public:
  DataFile(const std::string& path, const Progress& progress)
    : m_cursor(path, TextCursor::OpenEnd::Accept)
    , m_progress(progress)
  {
  }

  LAMMPSFrame read()
  {
    m_frame.start = m_cursor.place();
    m_frame.hasComments = true;
    std::string_view line;
    if (m_cursor.nextLine(line))
      this->readTitle(line);
    std::string section;
    while (section.empty() && m_cursor.nextLine(line))
      section = this->readHeaderLine(line);
    while (!section.empty())
      section = this->readSection(section);
    if (!m_frame.columns)
      this->refuse("the file has no section 'Atoms'");
    if (m_frame.box.known && !m_frame.box.general)
      this->setBox();
    return std::move(m_frame);
  }

private:
  [[noreturn]] void refuse(
    const std::string& sentence, FileError::Kind kind = FileError::Kind::Malformed) const
  {
    throw FileError(kind, m_cursor.path(), sentence, m_cursor.line());
  }

  void report()
  {
    if (m_progress && !m_progress(m_cursor.fraction()))
      throw FileError(FileError::Kind::Aborted, m_cursor.path(), "reading was aborted");
  }

  void readTitle(std::string_view line);
  std::string readHeaderLine(std::string_view line);
  std::string readSection(const std::string& name);
  void readAtoms(std::string_view comment);
  void readVelocities();
  void passRows(const char* what);
  std::string passLines();
  double number(const Names& words, std::size_t at) const;
  void setBox();

  TextCursor m_cursor;
  const Progress& m_progress;
  LAMMPSFrame m_frame;
  bool m_hasCount = false;
  double m_low[3] = {0, 0, 0}, m_high[3] = {0, 0, 0}, m_tilt[3] = {0, 0, 0};
};

void DataFile::readTitle(std::string_view line)
{
  const std::string step = saidIn(line, "timestep = ");
  if (isInteger(step))
    parseInteger(step.c_str(), m_frame.timestep);
  m_frame.units = saidIn(line, "units = ");
}

double DataFile::number(const Names& words, std::size_t at) const
{
  double value = 0.0;
  const char* const end = at < words.size() ? parseDouble(words[at].c_str(), value) : nullptr;
  if (!end || *end != '\0')
    throw FileError(FileError::Kind::Malformed, m_cursor.path(),
      "expected a number for the box, found '" + (at < words.size() ? words[at] : "") + "'",
      m_cursor.line() - 1);
  return value;
}

/// Returns the name of the section that begins in the line, and else nothing.
std::string DataFile::readHeaderLine(std::string_view line)
{
  const Names words = splitValues(bare(line));
  if (words.empty())
    return "";
  if (std::isalpha(static_cast<unsigned char>(words[0][0])))
    return std::string(line);
  const auto ends = [&](const Names& names)
  {
    return words.size() > names.size() &&
           std::equal(names.begin(), names.end(), words.end() - names.size());
  };
  constexpr const char* axes = "xyz";
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (const std::string name(1, axes[axis]); ends({name + "lo", name + "hi"}))
    {
      m_low[axis] = this->number(words, 0);
      m_high[axis] = this->number(words, 1);
      m_frame.box.known = true;
    }
  if (ends({"xy", "xz", "yz"}))
    for (std::size_t k = 0; k < 3; ++k)
      m_tilt[k] = this->number(words, k);
  LAMMPSBox& box = m_frame.box;
  const char* const vectors[] = {"avec", "bvec", "cvec"};
  for (std::size_t k = 0; k < 3; ++k)
    if (ends({vectors[k]}))
    {
      box.known = box.general = true;
      box.cell[k] = {this->number(words, 0), this->number(words, 1), this->number(words, 2)};
    }
  if (ends({"abc", "origin"}))
    box.origin = {this->number(words, 0), this->number(words, 1), this->number(words, 2)};
  if (words.size() == 2 && words[1] == "atoms")
  {
    std::int64_t atoms = -1;
    if (!isInteger(words[0]) || !parseInteger(words[0].c_str(), atoms) || atoms < 0)
      this->refuse("expected the number of atoms, found '" + words[0] + "'");
    m_frame.atoms = static_cast<std::uint64_t>(atoms);
    m_hasCount = true;
  }
  return "";
}

/// Passes a section whose first line was read; returns that of the next one, or nothing at the end.
std::string DataFile::readSection(const std::string& first)
{
  this->report();
  const std::string name(bare(first));
  std::string_view line;
  while (m_cursor.peekLine(line) && bare(line).empty())
    m_cursor.nextLine(line);
  const std::size_t comment = first.find('#');
  if (name == "Atoms")
    this->readAtoms(comment == first.npos ? "" : std::string_view(first).substr(comment + 1));
  else if (name == "Velocities" && m_hasCount)
    this->readVelocities();
  return this->passLines();
}

/// The lines up to the one that names the next section that is read, which is returned.
std::string DataFile::passLines()
{
  std::string_view line;
  for (std::uint64_t lines = 0; m_cursor.nextLine(line); ++lines)
  {
    if (lines % 1000000 == 0)
      this->report();
    if (const std::string_view name = bare(line); name == "Atoms" || name == "Velocities")
      return std::string(line);
  }
  return "";
}

/// Passes over as many lines as there are atoms.
void DataFile::passRows(const char* what)
{
  constexpr std::uint64_t most = 1000000;
  std::uint64_t done = 0;
  while (done < m_frame.atoms)
  {
    const std::uint64_t before = m_cursor.line();
    skipRows(m_cursor, std::min(most, m_frame.atoms - done));
    if (m_cursor.line() == before)
      this->refuse("the file announces " + std::to_string(m_frame.atoms) +
                     " atoms, but ends after " + std::to_string(done) + what + ": it is truncated",
        FileError::Kind::Truncated);
    done += m_cursor.line() - before;
    this->report();
  }
  std::string_view line;
  if (m_cursor.peekLine(line) && !bare(line).empty())
    this->refuse("the file announces " + std::to_string(m_frame.atoms) +
                 " atoms, but more follow: '" + std::string(line.substr(0, 40)) + "'");
}

void DataFile::readAtoms(std::string_view comment)
{
  if (!m_hasCount)
    this->refuse("the file does not say how many atoms there are before it lists them");
  m_frame.columnsLine = m_cursor.line();
  m_frame.rows = m_cursor.place();
  std::string_view line;
  Names values;
  if (m_frame.atoms > 0 && m_cursor.peekLine(line))
    values = splitValues(bare(line));
  const Names said = splitValues(bare(comment));
  std::string style = said.empty() ? "" : said[0];
  Names columns = columnsOf(style);
  if (columns.empty() && !style.empty())
    this->refuse("atoms of style '" + style + "' are not read");
  if (columns.empty())
    columns = columnsOf(style = m_frame.atoms > 0 ? guessedStyle(values) : "atomic");
  if (columns.empty() && m_frame.atoms > 0)
    this->refuse("lines of " + std::to_string(values.size()) +
                 " values need the atom style in the file, as in 'Atoms # full'");
  const std::size_t own = columns.size();
  const bool isOpen = style == "hybrid" || style == "tdpd"; // which may have any number more
  const bool hasImages = values.size() == own + 3;
  if (m_frame.atoms > 0 && values.size() != own && !hasImages && !(isOpen && values.size() > own))
    this->refuse("atoms of style '" + style + "' have " + std::to_string(own) + " or " +
                 std::to_string(own + 3) + " values, and here are " +
                 std::to_string(values.size()));
  if (hasImages && !isOpen)
    columns.insert(columns.end(), {"ix", "iy", "iz"});
  while (columns.size() < values.size())
    columns.push_back(unnamedColumn(columns.size() + 1, columns));
  const auto type = std::find(columns.begin(), columns.end(), "type");
  if (!values.empty() && !isInteger(values[static_cast<std::size_t>(type - columns.begin())]))
    *type = "typelabel";
  m_frame.columns = std::make_shared<const Names>(std::move(columns));
  this->passRows("");
}

void DataFile::readVelocities()
{
  std::string_view line;
  if (m_frame.atoms == 0 || !m_cursor.peekLine(line))
    return;
  m_frame.velocities = m_cursor.place();
  m_frame.velocityColumns = splitValues(bare(line)).size();
  if (m_frame.velocityColumns < 4)
    this->refuse(
      "velocities have 4 values or more, and here are " + std::to_string(m_frame.velocityColumns));
  this->passRows(" velocities");
}

void DataFile::setBox()
{
  LAMMPSBox& box = m_frame.box;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    box.origin[axis] = m_low[axis];
    box.cell[axis][axis] = m_high[axis] - m_low[axis];
  }
  box.cell[1][0] = m_tilt[0];
  box.cell[2][0] = m_tilt[1];
  box.cell[2][1] = m_tilt[2];
}

} // namespace

bool looksLikeLAMMPSData(std::string_view beginning)
{
  std::size_t at = beginning.find('\n'); // the first line is a title
  for (int line = 0; line < 50 && at < beginning.size(); ++line)
  {
    const std::size_t end = std::min(beginning.find('\n', at + 1), beginning.size());
    const Names words = splitValues(bare(beginning.substr(at + 1, end - at - 1)));
    if (words.size() == 2 && words[1] == "atoms" && isInteger(words[0]))
      return true;
    at = end;
  }
  return false;
}

LAMMPSFrame readLAMMPSDataHeader(const std::string& path, const Progress& progress)
{
  return DataFile(path, progress).read();
}

} // namespace mote
