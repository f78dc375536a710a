#ifndef MoteFileError_h
#define MoteFileError_h

#include <cstdint>
#include <stdexcept>
#include <string>

namespace mote
{

/// A text without line breaks and other control characters, which names out of files and folders
/// may hold: a question mark stands for each.
inline std::string oneLine(std::string text)
{
  for (char& c : text)
    c = static_cast<unsigned char>(c) < ' ' || c == '\x7f' ? '?' : c;
  return text;
}

/// What is wrong with a file, as one sentence that names the file and, where there is one, the line
/// and the column: "melt.dump, line 12, column 8: expected a number for 'vx', found 'abc'".
class FileError : public std::runtime_error
{
public:
  enum class Kind
  {
    NotFound,    ///< no such file
    CannotOpen,  ///< a directory, no permission, not a regular file
    OtherFormat, ///< readable, but of another format
    Truncated,   ///< the file ends too early
    Malformed,   ///< the format's rules are broken, or a column is missing
    Aborted      ///< not the file's fault: the caller asked to stop
  };

  /// `line` and `column` count from 1, the column in characters; 0 means that there is none.
  FileError(Kind kind, const std::string& file, const std::string& sentence, std::uint64_t line = 0,
    std::uint64_t column = 0)
    : std::runtime_error(compose(file, sentence, line, column))
    , m_kind(kind)
  {
  }

  Kind kind() const { return m_kind; }

private:
  static std::string compose(
    const std::string& file, const std::string& sentence, std::uint64_t line, std::uint64_t column)
  {
    std::string text = file;
    if (line > 0)
      text += ", line " + std::to_string(line);
    if (column > 0)
      text += ", column " + std::to_string(column);
    return oneLine(text + ": " + sentence);
  }

  Kind m_kind;
};

/// What is left of a sentence when the file's name, which a FileError puts before it, is taken off.
inline std::string withoutFile(const std::string& sentence, const std::string& file)
{
  return sentence.starts_with(oneLine(file) + ": ") ? sentence.substr(file.size() + 2) : sentence;
}

} // namespace mote

#endif
