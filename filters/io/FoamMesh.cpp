#include "FoamMesh.h"

#include "FileError.h"
#include "TextFile.h"
#include "WholeFile.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

namespace mote
{

namespace
{

/// Goes through a file of lists, in text or in bytes, packed or not.
class ListFile
{
public:
  explicit ListFile(const std::string& path)
    : file_(path)
    , text_(file_.bytes())
  {
    this->readHead();
  }

  bool isBinary() const { return isBinary_; }
  const std::string& kind() const { return kind_; }

  /// The next list of labels: calls visit(label); returns how many.
  template <class Visit>
  std::int64_t labels(const Visit& visit)
  {
    const std::int64_t count = this->beginList();
    if (isBinary_ && count > this->left() / labelBytes_)
      this->failAtEnd();
    for (std::int64_t i = 0; i < count; ++i)
      visit(isBinary_ ? this->rawLabel() : this->number());
    this->expect(')');
    return count;
  }

  /// The next list of places, of which only the number is told.
  std::int64_t places()
  {
    const std::int64_t count = this->beginList();
    if (isBinary_ && count > this->left() / (3 * scalarBytes_))
      this->failAtEnd();
    return count;
  }

  /// The faces of a list in text, "4(0 1 2 3)": calls visit(label); returns how many.
  template <class Visit>
  std::int64_t faces(const Visit& visit)
  {
    const std::int64_t count = this->beginList();
    for (std::int64_t i = 0; i < count; ++i)
    {
      const std::int64_t corners = this->number();
      this->expect('(');
      for (std::int64_t k = 0; k < corners; ++k)
        visit(this->number());
      this->expect(')');
    }
    return count;
  }

  /// The patches of a boundary: each a name and what stands in braces.
  void patches()
  {
    const std::int64_t count = this->beginList();
    for (std::int64_t i = 0; i < count; ++i)
    {
      this->skip();
      const std::size_t begin = at_;
      while (at_ < text_.size() && isOfWord(text_[at_]))
        ++at_;
      const std::string name(text_.substr(begin, at_ - begin));
      this->skip();
      if (name.empty() || at_ == text_.size() || text_[at_] != '{')
        this->fail("the patch '" + name + "' has no entries in braces");
      // Entries have no braces of their own, but for rare ones.
      for (int depth = 0; at_ < text_.size(); ++at_)
      {
        depth += text_[at_] == '{' ? 1 : text_[at_] == '}' ? -1 : 0;
        if (depth == 0)
          break;
      }
      this->expect('}');
    }
    this->expect(')');
  }

  /// The lists of values in a field, for which memory is taken before they are read: they must have
  /// room in the file, or, where they are of one value, "12{0}", at most as many as there are
  /// places.
  template <class Places>
  void valueLists(const Places& places)
  {
    constexpr std::string_view name = "List<";
    const std::size_t begin = at_;
    for (std::size_t at = text_.find(name, at_); at != text_.npos; at = text_.find(name, at + 1))
    {
      at_ = std::min(text_.find('>', at), text_.size() - 1) + 1;
      this->valueList(places);
    }
    at_ = begin;
  }

  /// One such list, such as the values of a cloud's particles. places() tells how many there may
  /// be.
  template <class Places>
  void valueList(const Places& places)
  {
    this->skip();
    std::int64_t count = 0;
    const char* const end = text_.data() + text_.size();
    const auto [stop, error] = std::from_chars(text_.data() + at_, end, count);
    if (error == std::errc::invalid_argument)
      return; // what is no number the reader finds itself
    const std::size_t number = at_;
    at_ = static_cast<std::size_t>(stop - text_.data());
    this->skip();
    const bool isOfOne = at_ < text_.size() && text_[at_] == '{';
    if (error != std::errc() || count < 0 || count > (isOfOne ? places() : this->left()))
      this->fail(
        std::string(isOfOne ? "there are not as many places as" : "the file has no room for") +
        " a list that says how long it is at byte " + std::to_string(number));
  }

  /// How many entries the list has that begins here; none where there is no number.
  std::int64_t length()
  {
    this->skip();
    std::int64_t count = 0;
    std::from_chars(text_.data() + at_, text_.data() + text_.size(), count);
    return std::clamp(count, std::int64_t{0}, this->left());
  }

  /// What a field has on the boundary, which must stand in braces where it is there.
  void boundaryField()
  {
    constexpr std::string_view name = "boundaryField";
    const std::size_t found = text_.rfind(name); // lists of values stand before it
    if (found == text_.npos || found < at_)
      return;
    at_ = found + name.size();
    if (at_ < text_.size() && isOfWord(text_[at_]))
      return; // another word
    this->skip();
    if (at_ == text_.size())
      this->failAtEnd();
    if (text_[at_] != '{')
      this->fail("what stands behind boundaryField is not in braces");
  }

  /// Braces and brackets that lie in one another more deeply than in any case, which the reader
  /// goes through by functions that call themselves until the stack is full.
  void requireShallow(bool headOnly = false) const
  {
    constexpr int most = 100;
    int depth = 0;
    for (std::size_t at = 0; at < text_.size(); ++at)
    {
      const char c = text_[at];
      if (headOnly && c == '(')
        return; // numbers follow
      if (!isBinary_ && (c == '"' || c == '/'))
        at = this->behindText(at);
      else if (c == '{' || c == '(' || c == '[')
        ++depth;
      else if (c == '}' || c == ')' || c == ']')
        depth = std::max(depth - 1, 0);
      else if (isBinary_ && isOfBytes(c))
        depth = 0; // of values
      if (depth > most)
        this->fail("its lists and entries lie in one another too deeply");
    }
  }

  [[noreturn]] void fail(const std::string& sentence) const
  {
    throw FileError(FileError::Kind::Malformed, file_.path(), sentence);
  }

private:
  static bool isOfBytes(char c)
  {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 127 || (byte < ' ' && std::isspace(byte) == 0);
  }

  /// The last byte of a quoted text or a comment that begins here, or this byte.
  std::size_t behindText(std::size_t at) const
  {
    const std::string_view two = text_.substr(at, 2);
    std::size_t end = at;
    if (two == "//")
      end = text_.find('\n', at);
    else if (two == "/*")
      end = text_.find("*/", at + 2);
    else if (two.front() == '"')
      for (end = at + 1; end < text_.size() && text_[end] != '"'; ++end)
        end += text_[end] == '\\' ? 1 : 0;
    return std::min(two == "/*" && end != text_.npos ? end + 1 : end, text_.size() - 1);
  }

  static bool isOfWord(char c)
  {
    return !std::isspace(static_cast<unsigned char>(c)) &&
           std::string_view("{}();\"/").find(c) == std::string_view::npos;
  }

  [[noreturn]] void failAtEnd() const
  {
    throw FileError(FileError::Kind::Truncated, file_.path(), "the file ends too early");
  }

  std::int64_t left() const { return static_cast<std::int64_t>(text_.size() - at_); }

  /// What an entry of the head says, "binary" of "format binary;".
  std::string entry(std::string_view head, std::string_view name) const
  {
    std::size_t at = head.find(name);
    while (at != head.npos && at > 0 && !std::isspace(static_cast<unsigned char>(head[at - 1])))
      at = head.find(name, at + 1);
    if (at == head.npos)
      return "";
    const std::size_t end = head.find(';', at);
    at = head.find_first_not_of(" \t\r\n", at + name.size());
    return at < end && end != head.npos ? std::string(head.substr(at, end - at)) : "";
  }

  void readHead()
  {
    const std::size_t begin = text_.find("FoamFile");
    const std::size_t end = begin == text_.npos ? begin : text_.find('}', begin);
    if (end == text_.npos)
      this->fail("this is no file of OpenFOAM, or its head is damaged");
    const std::string_view head = text_.substr(begin, end - begin);
    isBinary_ = this->entry(head, "format") == "binary";
    kind_ = this->entry(head, "class");
    const std::string sizes = this->entry(head, "arch");
    const auto bytesOf = [&](const std::string& name, std::int64_t usual)
    {
      const std::size_t at = sizes.find(name);
      if (at == std::string::npos)
        return usual;
      const std::string digits = sizes.substr(at + name.size(), 2);
      if (isBinary_ && digits != "32" && digits != "64")
        this->fail("numbers of '" + sizes + "' are not read");
      return digits == "64" ? std::int64_t{8} : std::int64_t{4};
    };
    labelBytes_ = bytesOf("label=", 4);
    scalarBytes_ = bytesOf("scalar=", 8);
    at_ = end + 1;
  }

  /// Over blanks and comments.
  void skip()
  {
    while (at_ < text_.size())
      if (std::isspace(static_cast<unsigned char>(text_[at_])))
        ++at_;
      else if (text_.substr(at_, 2) == "//")
        at_ = std::min(text_.find('\n', at_), text_.size());
      else if (text_.substr(at_, 2) == "/*")
        at_ = text_.find("*/", at_) == text_.npos ? text_.size() : text_.find("*/", at_) + 2;
      else
        return;
  }

  std::int64_t number()
  {
    this->skip();
    if (at_ == text_.size())
      this->failAtEnd();
    std::int64_t value = 0;
    const char* const begin = text_.data() + at_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (error != std::errc())
      this->fail("expected a whole number at byte " + std::to_string(at_));
    at_ += static_cast<std::size_t>(end - begin);
    return value;
  }

  void expect(char wanted)
  {
    this->skip();
    if (at_ == text_.size())
      this->failAtEnd();
    if (text_[at_] != wanted)
      this->fail(std::string("expected '") + wanted + "' at byte " + std::to_string(at_));
    ++at_;
  }

  /// How many a list has: "12 (".
  std::int64_t beginList()
  {
    const std::int64_t count = this->number();
    // A label takes two characters at least.
    if (count < 0 || count > this->left())
      this->fail("a list cannot have " + std::to_string(count) + " entries");
    this->expect('(');
    return count;
  }

  std::int64_t rawLabel()
  {
    const char* const from = text_.data() + at_;
    at_ += static_cast<std::size_t>(labelBytes_);
    std::int32_t label = 0;
    std::int64_t longLabel = 0;
    if (labelBytes_ == 8)
      std::memcpy(&longLabel, from, sizeof longLabel);
    else
      std::memcpy(&label, from, sizeof label);
    return labelBytes_ == 8 ? longLabel : label;
  }

  WholeFile file_;
  std::string_view text_;
  std::size_t at_ = 0;
  bool isBinary_ = false;
  std::string kind_;
  std::int64_t labelBytes_ = 4, scalarBytes_ = 8;
};

/// How many faces there are, which name points below `points`.
std::int64_t checkFaces(ListFile& file, std::int64_t points)
{
  const auto requirePoint = [&](std::int64_t point)
  {
    if (point < 0 || point >= points)
      file.fail("a face names the point " + std::to_string(point) + ", and there are " +
                std::to_string(points));
  };
  if (!file.isBinary() || file.kind() != "faceCompactList")
    return file.isBinary() ? -1 : file.faces(requirePoint);
  std::int64_t last = -1;
  const std::int64_t begins = file.labels(
    [&](std::int64_t begin)
    {
      if (begin < last || (last < 0 && begin != 0))
        file.fail("the places where faces begin do not ascend from 0");
      last = begin;
    });
  const std::int64_t corners = file.labels(requirePoint);
  if (begins == 0 || last != corners)
    file.fail("the places where faces begin do not fit their corners");
  return begins - 1;
}

/// Throws FileError where the cells on one side of the faces do not fit them.
void checkCells(ListFile& file, bool isOwner, std::int64_t faces)
{
  const std::int64_t least = isOwner ? 0 : -1; // of faces that have none
  const std::int64_t count = file.labels(
    [&](std::int64_t cell)
    {
      if (cell < least || cell >= faces) // a mesh has more faces than cells
        file.fail("there is no cell " + std::to_string(cell));
    });
  if (isOwner ? count != faces : count > faces)
    file.fail(
      "there are " + std::to_string(count) + " cells for " + std::to_string(faces) + " faces");
}

/// A simulation that runs may take files away meanwhile.
bool isThere(const std::string& path)
{
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

} // namespace

std::optional<std::string> findFoamFile(const std::string& folder, const std::string& name)
{
  for (const std::string& one : {folder + "/" + name, folder + "/" + name + ".gz"})
    if (isThere(one))
      return one;
  return std::nullopt;
}

std::int64_t checkFoamMesh(const FoamMesh& mesh)
{
  if (const auto path = findFoamFile(mesh.faces, "boundary")) // looked at before others are missed
  {
    ListFile boundary(*path);
    boundary.requireShallow();
    boundary.patches();
  }
  for (const char* name : {"cellZones", "faceZones", "pointZones"})
    if (const auto path = findFoamFile(mesh.faces, name))
      ListFile(*path).requireShallow();
  const auto open = [](const std::string& folder, const char* name)
  {
    const auto path = findFoamFile(folder, name);
    auto file = path ? std::make_unique<ListFile>(*path) : nullptr;
    if (file)
      file->requireShallow(true);
    return file;
  };
  std::int64_t points = -1, faces = -1; // not known
  if (const auto file = open(mesh.points, "points"))
    points = file->places();
  std::int64_t most = points;
  if (const auto file = open(mesh.faces, "faces"); file && points >= 0)
  {
    faces = checkFaces(*file, points);
    most = std::max(most, faces < 0 ? file->length() : faces);
  }
  for (const char* name : {"owner", "neighbour"})
    if (const auto file = open(mesh.faces, name); file && faces >= 0)
      checkCells(*file, name[0] == 'o', faces);
  return most;
}

void checkFoamDepth(const std::string& path)
{
  if (isThere(path) && readBeginning(path, 2048).find("FoamFile") != std::string::npos)
    ListFile(path).requireShallow();
}

void checkFoamField(const std::string& path, std::int64_t places)
{
  const std::string beginning = isThere(path) ? readBeginning(path, 2048) : "";
  if (beginning.find("FoamFile") == beginning.npos || beginning.find("Field") == beginning.npos)
    return;
  ListFile field(path);
  field.valueLists([&] { return places; });
  field.boundaryField();
}

void checkFoamCloud(const std::string& path)
{
  const std::filesystem::path cloud = std::filesystem::path(path).parent_path();
  if (cloud.parent_path().filename() != "lagrangian" || !isThere(path) ||
      readBeginning(path, 2048).find("FoamFile") == std::string::npos)
    return;
  const auto particles = [&]
  {
    std::int64_t count = 0;
    for (const char* name : {"positions", "coordinates"})
      if (const auto file = findFoamFile(cloud.string(), name))
        count = std::max(count, ListFile(*file).length());
    return count;
  };
  ListFile(path).valueList(particles);
}

} // namespace mote
