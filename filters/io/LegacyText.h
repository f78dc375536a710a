#ifndef MoteLegacyText_h
#define MoteLegacyText_h

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace mote
{

/// Goes through the words and values of a legacy file of VTK as its readers do. Its functions throw
/// FileError where the file has not what they ask for.
class LegacyText
{
protected:
  using Size = std::uint64_t;

  /// No count of a file is above this: its product with 100,000 components of 64 bits fits into
  /// Size.
  static constexpr Size mostValues = Size{1} << 40;

  /// How values of a type are stored.
  struct ValueType
  {
    Size bits = 0; ///< in binary files; 0 for strings
    bool isWhole = false;
  };

  LegacyText(const std::string& path, std::string_view text)
    : m_path(path)
    , m_text(text)
  {
  }

  static std::string lowerCase(std::string_view word);
  static std::string quoted(std::string_view word);

  [[noreturn]] void fail(const std::string& sentence) const;
  [[noreturn]] void failTruncated(const std::string& what) const;

  std::string_view nextLine();
  /// The next word; empty at the file's end.
  std::string_view nextWord();
  std::string_view requireWord(const char* what);
  /// Moves past the next word if it is this keyword.
  bool passWord(const char* keyword);
  Size requireCount(const char* what);
  ValueType requireType();

  /// What the file is short of is told before anything is read.
  void checkValues(Size count, const ValueType& type);
  void checkNumbers(Size count, bool whole);
  /// Behind it values begin, of binary files.
  void passLineEnd();
  /// One of a list of whole numbers, which checkValues() has been through, of 32 or 64 bits where
  /// it is not in text. mostValues stands for those below zero.
  Size nextInteger(Size bits = 32);

  const std::string& m_path;
  std::string_view m_text;
  std::size_t m_at = 0;
  bool m_isText = true;

private:
  void passStrings(Size count);
  Size stringLength();
};

} // namespace mote

#endif
