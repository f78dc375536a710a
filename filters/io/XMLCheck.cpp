#include "XMLCheck.h"

#include "FileError.h"
#include "MostArrays.h"
#include "TextFile.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

namespace mote
{

namespace
{

/// What stands in quotes behind a name in an element.
std::optional<std::string_view> attributeOf(std::string_view element, std::string_view name)
{
  for (std::size_t at = element.find(name); at != element.npos; at = element.find(name, at + 1))
  {
    const std::string_view rest = element.substr(at + name.size());
    const bool isWhole = at > 0 && (element[at - 1] == ' ' || element[at - 1] == '\n') &&
                         rest.size() > 1 && rest[0] == '=' && (rest[1] == '"' || rest[1] == '\'');
    if (isWhole)
      return rest.substr(2, rest.find(rest[1], 2) - 2);
  }
  return {};
}

/// The first bytes that a text in base64 stands for; fewer where it is none.
std::string fromBase64(std::string_view text, std::size_t count)
{
  constexpr std::string_view digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned value = 0;
  int bits = 0;
  for (const char c : text.substr(0, 2 * count + 256))
  {
    const std::size_t digit = digits.find(c);
    if (digit == digits.npos && (c == ' ' || c == '\n' || c == '\r' || c == '\t'))
      continue;
    if (digit == digits.npos || bytes.size() == count)
      break;
    value = (value << 6 | static_cast<unsigned>(digit)) & 0xffff;
    bits += 6;
    if (bits >= 8)
    {
      bits -= 8;
      bytes += static_cast<char>(value >> bits & 0xff);
    }
  }
  return bytes;
}

/// Throws FileError for a number below zero or above `most`.
void requireUpTo(const std::string& path, std::string_view element, const char* name, double most)
{
  const auto text = attributeOf(element, name);
  double value = 0.0;
  if (!text || text->empty())
    return;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
  if (error == std::errc::result_out_of_range ||
      (error == std::errc() && (value > most || value < 0.0)))
    throw FileError(FileError::Kind::Malformed, path,
      std::string(name) + " cannot be " + std::string(text->substr(0, 24)) + " in this file");
}

bool isKnownType(std::string_view type)
{
  constexpr std::array known = {"Float32", "Float64", "Int8", "UInt8", "Int16", "UInt16", "Int32",
    "UInt32", "Int64", "UInt64", "String", "Bit", "vtkIdType"};
  return std::find(known.begin(), known.end(), type) != known.end();
}

/// Whether a piece has nothing that arrays of this section could be of: readers pass over them.
bool isOfNothing(std::string_view piece, std::string_view section)
{
  const auto isNone = [&](const std::string& things)
  { return attributeOf(piece, "NumberOf" + things) == "0"; };
  if (section == "Points" || section == "PointData")
    return isNone("Points");
  if (section == "CellData" && !isNone("Cells"))
    return isNone("Verts") && isNone("Lines") && isNone("Strips") && isNone("Polys");
  return isNone(section == "CellData" ? "Cells" : std::string(section));
}

/// The name of an element, "Points" of "<Points>".
std::string_view nameOf(std::string_view element)
{
  return element.substr(1, element.find_first_of(" \n>", 1) - 1);
}

/// The elements of a text in XML, one after the other: their beginnings, ends, and those that are
/// both. Comments and the like are passed over. Throws FileError where they lie in one another more
/// deeply than any file of users', as readers free them by functions that call themselves until the
/// stack is full, and for declarations, which could make more elements of a few.
class Elements
{
public:
  Elements(std::string_view text, const std::string& path)
    : text_(text)
    , path_(path)
  {
  }

  /// Goes on to the next. Returns whether there is one.
  bool next()
  {
    for (begin_ = text_.find('<', end_); begin_ != text_.npos; begin_ = text_.find('<', end_))
    {
      const std::string_view rest = text_.substr(begin_);
      if (rest.starts_with("<!--"))
        this->passOver("-->");
      else if (rest.starts_with("<![CDATA["))
        this->passOver("]]>");
      else if (rest.starts_with("<?"))
        this->passOver("?>");
      else if (rest.starts_with("<!"))
        throw FileError(FileError::Kind::Malformed, path_, "declarations of XML are not read");
      else
        return this->take(rest), true;
    }
    return false;
  }
  /// With "<" and without ">".
  std::string_view element() const { return text_.substr(begin_, end_ - 1 - begin_); }
  /// Behind it.
  std::size_t end() const { return end_; }

private:
  static constexpr int mostDepth = 100;

  [[noreturn]] void failAsCut() const
  {
    throw FileError(FileError::Kind::Truncated, path_,
      "the file ends within '" + std::string(text_.substr(begin_, 24)) + "'");
  }
  void passOver(std::string_view last)
  {
    const std::size_t at = text_.find(last, begin_);
    if (at == text_.npos)
      this->failAsCut();
    end_ = at + last.size();
  }
  void take(std::string_view rest)
  {
    std::size_t at = rest.find_first_of(">\"'");
    while (at != rest.npos && rest[at] != '>')
    {
      at = rest.find(rest[at], at + 1); // the other quotation mark
      at = at == rest.npos ? at : rest.find_first_of(">\"'", at + 1);
    }
    if (at == rest.npos)
      this->failAsCut();
    end_ = begin_ + at + 1;
    if (rest.starts_with("</"))
      --depth_;
    else if (rest[at - 1] != '/' && ++depth_ > mostDepth)
      throw FileError(
        FileError::Kind::Malformed, path_, "elements of XML lie in one another too deeply");
  }

  std::string_view text_;
  std::string path_;
  std::size_t begin_ = 0, end_ = 0;
  int depth_ = 0;
};

/// The type and the number of components of arrays, by what has them and their names.
using Arrays = std::map<std::string, std::string>;

/// Goes through the elements of a file, and of those that it names.
class Check
{
public:
  Check(const std::string& path, const Arrays& promised)
    : path_(path)
    , promised_(promised)
  {
  }

  void run(int depth)
  {
    this->runValues(true);
    const TextFile file(path_);
    const std::string_view text = file.text();
    most_ = std::max(1e6, mostPerByte * static_cast<double>(text.size()));
    for (Elements elements(text, path_); elements.next();)
    {
      const std::string_view element = elements.element().substr(0, 4096);
      if (element.starts_with("<AppendedData"))
        return; // what follows are bytes
      this->numbers(element);
      this->extents(element);
      this->array(element);
      for (const char* name : {"file", "Source"})
        if (const auto other = attributeOf(element, name); other && depth < 2)
          this->follow(std::string(*other), depth);
    }
  }

  /// Goes through the values that are packed, of this file alone: of all arrays, or of those of the
  /// whole file, which VTK reads to know its time.
  void runValues(bool ofFileAlone)
  {
    const TextFile file(path_);
    const std::string_view text = file.text();
    most_ = std::max(1e6, mostPerByte * static_cast<double>(text.size()));
    std::vector<std::uint64_t> offsets; // of appended values
    std::string_view piece, section;
    bool isPacked = false;
    for (Elements elements(text, path_); elements.next();)
    {
      const std::string_view element = elements.element().substr(0, 4096);
      const std::size_t end = elements.end();
      if (element.starts_with("<VTKFile"))
      {
        isPacked = attributeOf(element, "compressor").has_value();
        isLong_ = attributeOf(element, "header_type") == "UInt64";
        isBigEndian_ = attributeOf(element, "byte_order") == "BigEndian";
      }
      if (!isPacked)
        return;
      if (const std::string_view name = nameOf(element); name == "Piece")
        piece = element;
      else if (!name.ends_with("Array") && !name.starts_with('/'))
        section = name;
      const bool isMet = ofFileAlone ? section == "FieldData" : !isOfNothing(piece, section);
      if (isMet && attributeOf(element, "format") == "appended")
        offsets.push_back(this->offsetIn(element));
      if (isMet && attributeOf(element, "format") == "binary")
        this->packed(text.substr(end), true);
      if (element.starts_with("<AppendedData"))
        return this->appended(
          text.substr(end), attributeOf(element, "encoding") == "base64", offsets);
    }
  }

private:
  // The best packer leaves a byte of some thousand equal ones.
  static constexpr double mostPerByte = 4096.0;

  void numbers(std::string_view element) const
  {
    for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfVerts", "NumberOfLines",
           "NumberOfStrips", "NumberOfPolys", "NumberOfTuples"})
      requireUpTo(path_, element, name, most_);
    requireUpTo(path_, element, "NumberOfComponents", 1e5);
    requireUpTo(path_, element, "index", 1e6);
  }

  using Extent = std::array<std::int64_t, 6>;

  [[noreturn]] void failAtExtent(std::string_view text) const
  {
    throw FileError(FileError::Kind::Malformed, path_,
      "an extent cannot be '" + std::string(text.substr(0, 72)) + "' in this file");
  }

  /// First and last index on each axis; none where something else stands there, which the reader
  /// finds.
  std::optional<Extent> extentIn(std::string_view element, std::string_view name) const
  {
    const auto text = attributeOf(element, name);
    if (!text)
      return {};
    Extent extent{};
    const char* at = text->data();
    const char* const end = at + text->size();
    for (std::int64_t& number : extent)
    {
      while (at < end && (*at == ' ' || (*at >= '\t' && *at <= '\r')))
        ++at;
      const auto [stop, error] = std::from_chars(at, end, number);
      if (error == std::errc::invalid_argument)
        return {};
      constexpr std::int64_t most = std::int64_t{1} << 30;
      if (error != std::errc() || number < -most || number > most)
        this->failAtExtent(*text);
      at = stop;
    }
    return extent;
  }

  /// The extents of grids: VTK takes memory for the whole one, and copies pieces into it.
  void extents(std::string_view element)
  {
    if (const auto whole = this->extentIn(element, "WholeExtent"))
    {
      whole_ = whole;
      double points = 1.0;
      for (std::size_t axis = 0; axis < 3; ++axis)
        points *= static_cast<double>(
          std::max<std::int64_t>((*whole)[2 * axis + 1] - (*whole)[2 * axis] + 1, 0));
      if (!element.starts_with("<P") && points > most_) // whose pieces are elsewhere
        this->failAtExtent(*attributeOf(element, "WholeExtent"));
    }
    const auto piece = this->extentIn(element, "Extent");
    for (std::size_t axis = 0; axis < 3 && piece && whole_; ++axis)
    {
      const std::int64_t first = (*piece)[2 * axis], last = (*piece)[2 * axis + 1];
      if (first <= last && (first < (*whole_)[2 * axis] || last > (*whole_)[2 * axis + 1]))
        this->failAtExtent(*attributeOf(element, "Extent"));
    }
  }

  /// Where an array begins among those that are appended.
  std::uint64_t offsetIn(std::string_view element) const
  {
    const std::string_view text = attributeOf(element, "offset").value_or("0");
    std::uint64_t offset = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), offset);
    if (error != std::errc() || end != text.data() + text.size())
      throw FileError(FileError::Kind::Malformed, path_,
        "the offset '" + std::string(text.substr(0, 24)) + "' is no whole number");
    return offset;
  }

  void appended(
    std::string_view bytes, bool isBase64, const std::vector<std::uint64_t>& offsets) const
  {
    const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
    this->requireHead(offsets.empty() || (begin != bytes.npos && bytes[begin] == '_'));
    for (const std::uint64_t offset : offsets)
    {
      this->requireHead(offset < bytes.size() - begin - 1);
      this->packed(bytes.substr(begin + 1 + offset), isBase64);
    }
  }

  void requireHead(bool isThere) const
  {
    if (!isThere)
      throw FileError(FileError::Kind::Malformed, path_,
        "packed values do not begin with how many bytes they are, or the file ends before them");
  }

  /// The head of packed values: the number of blocks, how many bytes each and the last stand for,
  /// and how many each takes, for all of which VTK takes memory.
  void packed(std::string_view bytes, bool isBase64) const
  {
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    if (isBase64 && first != bytes.npos && bytes[first] == '<')
      return; // of no values
    const auto heads = [&](std::size_t count)
    {
      const std::size_t width = isLong_ ? 8 : 4;
      const std::string head =
        isBase64 ? fromBase64(bytes, count * width) : std::string(bytes.substr(0, count * width));
      this->requireHead(head.size() >= count * width); // else VTK takes what memory held before
      std::vector<std::uint64_t> numbers(count);
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < width; ++k)
          numbers[i] = numbers[i] << 8 | static_cast<unsigned char>(
                                           head[i * width + (isBigEndian_ ? k : width - 1 - k)]);
      return numbers;
    };
    const auto require = [&](bool holds, std::uint64_t number, const char* what)
    {
      if (!holds)
        throw FileError(FileError::Kind::Malformed, path_,
          "the file has no room for " + std::to_string(number) + what);
    };
    const std::uint64_t blocks = heads(1)[0];
    require(blocks <= bytes.size(), blocks, " blocks of packed values");
    const std::vector<std::uint64_t> numbers = heads(3 + blocks);
    require(blocks > 0 || numbers[2] == 0, numbers[2], " packed bytes in no block");
    require(blocks == 0 || numbers[1] > 0, blocks, " blocks of no bytes");
    for (std::size_t i = 1; blocks > 0 && i < numbers.size(); ++i)
      require(i < 3 ? static_cast<double>(numbers[i]) <= most_ : numbers[i] <= bytes.size(),
        numbers[i], " packed bytes");
  }

  /// What a file says of the arrays of its pieces, these must have: they are copied byte by byte.
  void array(std::string_view element)
  {
    const bool isArray = element.starts_with("<DataArray") || element.starts_with("<PDataArray");
    if (!isArray && !element.starts_with("</") && !element.starts_with("<InformationKey"))
    {
      const std::string_view name = nameOf(element);
      isPromise_ = name == "PPoints" || name == "PPointData" || name == "PCellData";
      section_ = name.substr(isPromise_ ? 1 : 0);
    }
    if (element.starts_with("<Piece"))
      arrayCount_ = 0;
    hasTimes_ = hasTimes_ || attributeOf(element, "TimeValues");
    if (!isArray)
      return;
    if (++arrayCount_ > mostArrays)
      throw FileError(FileError::Kind::Malformed, path_, tooMany("arrays"));
    if (element.starts_with("<DataArray") && !attributeOf(element, "type"))
      throw FileError(FileError::Kind::Malformed, path_, "an array does not say its type");
    if (!hasTimes_ && attributeOf(element, "TimeStep"))
      throw FileError(
        FileError::Kind::Malformed, path_, "an array is of a time step, and there are no times");
    if (!isPromise_ && element.find("format") == element.npos)
      throw FileError(FileError::Kind::Malformed, path_, "an array does not say its format");
    if (const auto type = attributeOf(element, "type"); type && !isKnownType(*type))
      throw FileError(FileError::Kind::Malformed, path_,
        "an array is of '" + std::string(type->substr(0, 24)) + "', which is no type of VTK files");
    const auto valueOf = [&](const char* name, const char* usual)
    { return std::string(attributeOf(element, name).value_or(usual)); };
    const bool isOfPoints = section_ == "Points";
    const std::string components = valueOf("NumberOfComponents", "1");
    if (isOfPoints && components != "3")
      throw FileError(FileError::Kind::Malformed, path_, "points have three components");
    const std::string key = section_ + ' ' + (isOfPoints ? "" : valueOf("Name", ""));
    const std::string form = valueOf("type", "") + " with " + components + " components";
    if (isPromise_)
      arrays_[key] = form;
    else if (const auto found = promised_.find(key);
             found != promised_.end() && found->second != form)
      throw FileError(FileError::Kind::Malformed, path_,
        "an array of " + key + " is of " + form + ", and " + found->second +
          " is what the file of all pieces says");
  }

  void follow(const std::string& name, int depth) const
  {
    const auto beside = std::filesystem::path(path_).parent_path() / name;
    requireNoStream(beside.string());
    std::error_code error;
    if (std::filesystem::is_regular_file(beside, error))
      Check(beside.string(), arrays_).run(depth + 1);
  }

  std::string path_;
  const Arrays& promised_;
  Arrays arrays_;
  double most_ = 0.0;
  std::optional<Extent> whole_;
  bool isLong_ = false, isBigEndian_ = false;
  std::size_t arrayCount_ = 0; ///< of a piece
  bool hasTimes_ = false;
  std::string section_;
  bool isPromise_ = false; ///< the section's arrays are those of pieces
};

} // namespace

void checkXMLDepth(const std::string& path)
{
  const TextFile file(path);
  Elements elements(file.text(), path);
  while (elements.next())
    continue;
}

void checkVTKXML(const std::string& path)
{
  const Arrays none;
  Check(path, none).run(0);
}

void checkVTKXMLValues(const std::string& path)
{
  const Arrays none;
  Check(path, none).runValues(false);
}

} // namespace mote
