#ifndef MoteEnSightSource_h
#define MoteEnSightSource_h

#include "TextFile.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace mote
{

/// How a file of EnSight Gold holds texts and numbers.
enum class EnSightForm
{
  Lines,
  C,      ///< bytes
  Fortran ///< bytes in records
};

/// The form of a geometry file, which says it; the files of values have the same.
EnSightForm formOfEnSight(const std::string& geometryPath);

/// Goes through a file of EnSight Gold, which holds texts, whole numbers and numbers. Throws
/// FileError where there is something else.
class EnSightSource
{
public:
  EnSightSource(const std::string& path, EnSightForm form);

  /// The next text: a line, or 80 characters, without blanks at its ends; none at the end of the
  /// file.
  std::optional<std::string> text();
  /// The same, where there must be one.
  std::string requiredText(const std::string& what);

  /// Passes over a description: a line, which may be blank, or 80 characters.
  void passDescription();

  /// One whole number.
  std::int64_t whole(const std::string& what);
  /// So many rows of as many whole numbers, one row a line.
  using Visit = std::function<void(std::int64_t)>;
  void wholes(
    std::int64_t rows, std::int64_t perRow, const std::string& what, const Visit& visit = {});
  /// So many numbers, one a line.
  void numbers(std::int64_t count, const std::string& what);

  /// Whether the file is text.
  bool isLines() const { return form_ == EnSightForm::Lines; }

  /// Ends with a sentence that says what is wrong here.
  [[noreturn]] void fail(const std::string& sentence) const;

private:
  std::string_view line();
  /// The next bytes, which are a record of its own in Fortran's form.
  const char* bytes(std::int64_t count, const std::string& what);
  std::int32_t wordAt(const char* at) const;
  std::int64_t left() const { return static_cast<std::int64_t>(text_.size() - at_); }
  [[noreturn]] void failAtEnd(const std::string& what) const;

  TextFile file_;
  std::string_view text_;
  std::size_t at_ = 0;
  std::uint64_t lines_ = 0;
  EnSightForm form_;
  bool isKnown_ = false;   ///< in which order bytes are
  bool isSwapped_ = false; ///< they are in the other order than this machine's
};

} // namespace mote

#endif
