#include "EnSightSource.h"

#include "FileError.h"

#include <algorithm>
#include <charconv>
#include <cstring>

namespace mote
{

namespace
{

constexpr std::size_t textLength = 80;
constexpr std::string_view blanks = " \t\r\n";

std::string_view trimmed(std::string_view text)
{
  text = text.substr(0, text.find('\0'));
  const std::size_t first = text.find_first_not_of(blanks);
  return first == text.npos ? std::string_view()
                            : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Takes a number off a line; whether there was one.
template <class T>
bool takeNumber(std::string_view& line, T& value)
{
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  if (line.starts_with('+'))
    line.remove_prefix(1);
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), value);
  const bool isNumber = error != std::errc::invalid_argument &&
                        (std::is_floating_point_v<T> || error != std::errc::result_out_of_range);
  line.remove_prefix(static_cast<std::size_t>(end - line.data()));
  return isNumber && (line.empty() || blanks.find(line.front()) != blanks.npos);
}

} // namespace

EnSightForm formOfEnSight(const std::string& geometryPath)
{
  const std::string beginning = readBeginning(geometryPath, textLength);
  const std::size_t mark = beginning.find("Fortran Binary");
  return beginning.starts_with("C Binary")     ? EnSightForm::C
         : mark != beginning.npos && mark <= 4 ? EnSightForm::Fortran
                                               : EnSightForm::Lines;
}

EnSightSource::EnSightSource(const std::string& path, EnSightForm form)
  : file_(path)
  , text_(file_.text())
  , form_(form)
{
}

void EnSightSource::fail(const std::string& sentence) const
{
  throw FileError(FileError::Kind::Malformed, file_.path(), sentence, lines_);
}

void EnSightSource::failAtEnd(const std::string& what) const
{
  throw FileError(
    FileError::Kind::Truncated, file_.path(), "the file ends too early, within " + what);
}

/// The next line that says something; empty at the end of the file.
std::string_view EnSightSource::line()
{
  while (at_ < text_.size())
  {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    const std::string_view found = trimmed(text_.substr(at_, end - at_));
    at_ = std::min(end + 1, text_.size());
    ++lines_;
    if (!found.empty() && found.front() != '#')
      return found;
  }
  return {};
}

std::int32_t EnSightSource::wordAt(const char* at) const
{
  std::uint32_t word = 0;
  std::memcpy(&word, at, sizeof word);
  if (isSwapped_)
    word = word >> 24 | (word >> 8 & 0xff00u) | (word << 8 & 0xff0000u) | word << 24;
  return static_cast<std::int32_t>(word);
}

const char* EnSightSource::bytes(std::int64_t count, const std::string& what)
{
  const std::int64_t around = form_ == EnSightForm::Fortran ? 4 : 0;
  if (count > this->left() - 2 * around)
    this->failAtEnd(what);
  const char* const found = text_.data() + at_ + around;
  if (around > 0 && (this->wordAt(found - 4) != count || this->wordAt(found + count) != count))
    this->fail("a record of " + what + " has another length than " + std::to_string(count));
  at_ += static_cast<std::size_t>(count + 2 * around);
  return found;
}

std::optional<std::string> EnSightSource::text()
{
  if (form_ == EnSightForm::Lines)
  {
    const std::string_view found = this->line();
    return found.empty() ? std::nullopt : std::optional<std::string>(found);
  }
  if (this->left() == 0)
    return std::nullopt;
  if (form_ == EnSightForm::Fortran && !isKnown_ && this->left() > 4)
  {
    isKnown_ = true;
    isSwapped_ = this->wordAt(text_.data() + at_) != static_cast<int>(textLength);
  }
  return std::string(trimmed({this->bytes(textLength, "a text"), textLength}));
}

void EnSightSource::passDescription()
{
  if (form_ != EnSightForm::Lines)
  {
    this->text();
    return;
  }
  const std::size_t end = text_.find('\n', at_);
  at_ = end == text_.npos ? text_.size() : end + 1;
  ++lines_;
}

std::string EnSightSource::requiredText(const std::string& what)
{
  const std::optional<std::string> found = this->text();
  if (!found)
    this->failAtEnd(what);
  return *found;
}

std::int64_t EnSightSource::whole(const std::string& what)
{
  if (form_ != EnSightForm::Lines && !isKnown_ && this->left() >= 4)
  {
    // The first number is that of a part, which is small.
    isKnown_ = true;
    const std::int32_t word = this->wordAt(text_.data() + at_);
    isSwapped_ = word < 0 || word > 0xffff;
  }
  std::int64_t value = 0;
  this->wholes(1, 1, what, [&](std::int64_t found) { value = found; });
  return value;
}

void EnSightSource::wholes(
  std::int64_t rows, std::int64_t perRow, const std::string& what, const Visit& visit)
{
  constexpr std::int64_t most = std::int64_t{1} << 40; // products stay numbers
  if (rows < 0 || perRow < 0 || rows > most || perRow > 100'000)
    this->fail("there cannot be " + std::to_string(rows) + " rows of " + what);
  if (form_ != EnSightForm::Lines)
  {
    const char* const found = this->bytes(4 * rows * perRow, what);
    for (std::int64_t i = 0; visit && i < rows * perRow; ++i)
      visit(this->wordAt(found + 4 * i));
    return;
  }
  for (std::int64_t row = 0; row < rows && perRow > 0; ++row)
  {
    std::string_view rest = this->line();
    if (rest.empty())
      this->failAtEnd(what);
    for (std::int64_t i = 0; i < perRow; ++i)
    {
      std::int64_t value = 0;
      if (!takeNumber(rest, value))
        this->fail("expected " + std::to_string(perRow) + " whole number" +
                   (perRow == 1 ? "" : "s") + " of " + what);
      if (visit)
        visit(value);
    }
  }
}

void EnSightSource::numbers(std::int64_t count, const std::string& what)
{
  if (form_ != EnSightForm::Lines)
  {
    if (count < 0 || count > this->left() / 4)
      this->failAtEnd(what);
    this->bytes(4 * count, what);
    return;
  }
  for (std::int64_t i = 0; i < count; ++i)
  {
    std::string_view rest = this->line();
    if (rest.empty())
      this->failAtEnd(what);
    double value = 0.0;
    if (!takeNumber(rest, value))
      this->fail("expected a number of " + what);
  }
}

} // namespace mote
