#include "FoamListFile.h"

#include "FileError.h"

#include <cstring>
#include <map>

namespace mote
{

namespace
{

bool isBlank(char c)
{
  return c == ' ' || (c >= '\t' && c <= '\r');
}

bool isDigit(char c)
{
  return c >= '0' && c <= '9';
}

bool isOfWord(char c)
{
  return !isBlank(c) && std::string_view("{}();\"/").find(c) == std::string_view::npos;
}

/// Behind blanks and comments.
std::size_t behindBlanks(std::string_view text, std::size_t at)
{
  while (at < text.size())
    if (isBlank(text[at]))
      ++at;
    else if (text.substr(at, 2) == "//")
      at = std::min(text.find('\n', at), text.size());
    else if (text.substr(at, 2) == "/*")
      at = text.find("*/", at) == text.npos ? text.size() : text.find("*/", at) + 2;
    else
      break;
  return at;
}

/// What an entry of the head says, "binary" of "format binary;".
std::string entry(std::string_view head, std::string_view name)
{
  std::size_t at = head.find(name);
  while (at != head.npos && at > 0 && !isBlank(head[at - 1]))
    at = head.find(name, at + 1);
  if (at == head.npos)
    return "";
  const std::size_t end = head.find(';', at);
  at = head.find_first_not_of(" \t\r\n", at + name.size());
  return at < end && end != head.npos ? std::string(head.substr(at, end - at)) : "";
}

} // namespace

FoamListFile::FoamListFile(const std::string& path)
  : file_(path)
  , text_(file_.bytes())
{
  this->readHead();
}

std::int64_t FoamListFile::places()
{
  const std::int64_t count = this->beginList();
  if (isBinary_ && count > this->left() / (3 * scalarBytes_))
    this->failAtEnd();
  return count;
}

bool FoamListFile::arePlaces(std::int64_t count)
{
  const auto takes = [&](char wanted)
  {
    while (at_ < text_.size() && isBlank(text_[at_]))
      ++at_;
    return at_ < text_.size() && text_[at_++] == wanted;
  };
  const auto takesNumber = [&]
  {
    while (at_ < text_.size() && isBlank(text_[at_]))
      ++at_;
    double value = 0.0;
    const char* const end = text_.data() + text_.size();
    const auto [stop, error] = std::from_chars(text_.data() + at_, end, value);
    at_ = static_cast<std::size_t>(stop - text_.data());
    return error == std::errc() && at_ < text_.size() && (isBlank(text_[at_]) || text_[at_] == ')');
  };
  if (isBinary_)
    at_ += static_cast<std::size_t>(count * 3 * scalarBytes_); // for which there is room
  for (std::int64_t i = 0; i < count && !isBinary_; ++i)
    if (!takes('(') || !takesNumber() || !takesNumber() || !takesNumber() || !takes(')'))
      return false;
  return hasWholeHead_ && takes(')');
}

void FoamListFile::patches()
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

std::int64_t FoamListFile::length()
{
  this->skip();
  std::int64_t count = 0;
  std::from_chars(text_.data() + at_, text_.data() + text_.size(), count);
  return std::clamp(count, std::int64_t{0}, this->left());
}

void FoamListFile::boundaryField()
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

/// Whether the file is a list of bytes, and not one of words, which patches and zones are.
bool FoamListFile::isRawList() const
{
  if (!isBinary_ || kind_ == "polyBoundaryMesh" || kind_ == "regIOobject")
    return false;
  const std::size_t at = behindBlanks(text_, at_);
  return at < text_.size() && isDigit(text_[at]);
}

/// How many bytes stand in the list that this bracket opens, of a field that is not in text: 0
/// where it opens another, -1 where the type is not known.
std::int64_t FoamListFile::rawBytes(std::size_t at) const
{
  const auto blanksBefore = [&](std::size_t end)
  {
    while (end > 0 && isBlank(text_[end - 1]))
      --end;
    return end;
  };
  const std::size_t numberEnd = blanksBefore(at);
  std::size_t number = numberEnd;
  while (number > 0 && isDigit(text_[number - 1]))
    --number;
  const std::size_t typeEnd = blanksBefore(number);
  if (number == numberEnd || typeEnd == 0 || text_[typeEnd - 1] != '>')
    return 0;
  constexpr std::size_t longest = 40;
  const std::size_t begin = typeEnd - std::min(typeEnd, longest);
  std::string_view type = text_.substr(begin, typeEnd - 1 - begin);
  type = type.substr(type.rfind('<') + 1); // all of it where there is none
  const std::map<std::string_view, std::int64_t> sizes = {{"scalar", scalarBytes_},
    {"vector", 3 * scalarBytes_}, {"sphericalTensor", scalarBytes_},
    {"symmTensor", 6 * scalarBytes_}, {"tensor", 9 * scalarBytes_}, {"label", labelBytes_},
    {"bool", 1}};
  const auto size = sizes.find(type);
  std::int64_t count = 0;
  const auto parsed = std::from_chars(text_.data() + number, text_.data() + numberEnd, count);
  if (size == sizes.end())
    return -1;
  return parsed.ec == std::errc() && count <= this->left() / size->second ? count * size->second
                                                                          : this->left();
}

void FoamListFile::requireShallow(bool headOnly) const
{
  constexpr int most = 100;
  const bool isRaw = this->isRawList();
  bool isGuessed = false; // behind bytes of which nobody knows how many they are
  int depth = 0;
  for (std::size_t at = 0; at < text_.size(); ++at)
  {
    const char c = text_[at];
    if (c == '(' && (headOnly || (isRaw && at >= at_)))
      return; // numbers follow
    if (!isGuessed && (c == '"' || c == '/'))
      at = this->behindText(at);
    else if (c == '{' || c == '(' || c == '[')
      ++depth;
    else if (c == '}' || c == ')' || c == ']')
      depth = std::max(depth - 1, 0);
    else if (isGuessed && (static_cast<unsigned char>(c) >= 127 || (c < ' ' && !isBlank(c))))
      depth = 0;
    if (depth > most)
      this->fail("its lists and entries lie in one another too deeply");
    const std::int64_t bytes = isBinary_ && c == '(' ? this->rawBytes(at) : 0;
    isGuessed = isGuessed || bytes < 0;
    at += static_cast<std::size_t>(std::max(bytes, std::int64_t{0}));
  }
}

void FoamListFile::fail(const std::string& sentence) const
{
  throw FileError(FileError::Kind::Malformed, file_.path(), sentence);
}

/// The last byte of a quoted text or a comment that begins here, or this byte.
std::size_t FoamListFile::behindText(std::size_t at) const
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

void FoamListFile::failAtEnd() const
{
  throw FileError(FileError::Kind::Truncated, file_.path(), "the file ends too early");
}

void FoamListFile::readHead()
{
  const std::size_t begin = text_.find("FoamFile");
  const std::size_t end = begin == text_.npos ? begin : text_.find('}', begin);
  if (end == text_.npos)
    this->fail("this is no file of OpenFOAM, or its head is damaged");
  const std::string_view head = text_.substr(begin, end - begin);
  isBinary_ = entry(head, "format") == "binary";
  kind_ = entry(head, "class");
  hasWholeHead_ = kind_ == "vectorField" && !entry(head, "object").empty() &&
                  !entry(head, "version").empty() && head.find("format") != head.npos;
  const std::string sizes = entry(head, "arch");
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

void FoamListFile::skip()
{
  at_ = behindBlanks(text_, at_);
}

std::int64_t FoamListFile::number()
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

void FoamListFile::expect(char wanted)
{
  this->skip();
  if (at_ == text_.size())
    this->failAtEnd();
  if (text_[at_] != wanted)
    this->fail(std::string("expected '") + wanted + "' at byte " + std::to_string(at_));
  ++at_;
}

/// How many a list has: "12 (".
std::int64_t FoamListFile::beginList()
{
  const std::int64_t count = this->number();
  // A label takes two characters at least.
  if (count < 0 || count > this->left())
    this->fail("a list cannot have " + std::to_string(count) + " entries");
  this->expect('(');
  return count;
}

std::int64_t FoamListFile::rawLabel()
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

} // namespace mote
