#ifndef MoteTextCursor_h
#define MoteTextCursor_h

#include "GzipStream.h"
#include "TextFile.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace mote
{

/// Called now and then with the share of the work that is done, 0 to 1; false asks to stop.
using Progress = std::function<bool(double)>;

/// Reads the text of a plain or gzip file forwards, by lines or by blocks of whole lines.
///
/// Every view it hands out ends with a line end, so that a parser needs no other bound, and lives
/// until the next call that is not const. A plain file is one view of its memory map; gzip text
/// passes through a buffer.
class TextCursor
{
public:
  /// What to do about a last line without a line end.
  enum class OpenEnd
  {
    Reject, ///< throw: programs that end every line have been interrupted
    Accept
  };

  /// A place that another cursor over the same, unchanged file can be sent to.
  struct Place
  {
    std::uint64_t offset = 0; ///< bytes of text before it
    std::uint64_t line = 1;   ///< the number of the line that begins there, from 1
    std::shared_ptr<const GzipStream::Snapshot> snapshot; ///< gzip only: at or before it
  };

  /// Opens a file; see TextFile for what it throws.
  explicit TextCursor(const std::string& path, OpenEnd openEnd = OpenEnd::Reject);

  const std::string& path() const { return m_file.path(); }
  std::uint64_t line() const { return m_line; } ///< the number of the next line, from 1
  std::uint64_t offset() const;                 ///< bytes of text before it
  double fraction() const;                      ///< of the file, 0 to 1

  /// The next line without its line end ("\n" or "\r\n"); false at the end of the text.
  bool nextLine(std::string_view& line);
  /// The same without moving on.
  bool peekLine(std::string_view& line);

  /// Whole lines from here on, about `bytes` and never fewer than one; empty at the end. Does not
  /// move on: advance does.
  std::string_view block(std::size_t bytes);
  /// Moves on past `lines` whole lines that take `bytes` of the last block.
  void advance(std::size_t bytes, std::uint64_t lines);

  Place place() const;
  void seek(const Place& place);

private:
  bool fill();
  void fillFromStream();
  void takeSnapshot();
  void acceptOpenEnd(std::string_view rest);
  [[noreturn]] void failChanged() const;

  TextFile m_file;
  OpenEnd m_openEnd;
  std::unique_ptr<GzipStream> m_stream; ///< gzip only
  std::vector<char> m_buffer;           ///< gzip: text in [0, m_filled)
  std::size_t m_filled = 0;
  /// gzip: a snapshot at or before the window, and the next one, which the window has yet to pass.
  std::shared_ptr<const GzipStream::Snapshot> m_snapshot, m_nextSnapshot;
  std::string m_lastLine; ///< an accepted last line, with its line end added
  bool m_atEnd = false;   ///< nothing follows the window

  const char* m_position = nullptr; ///< the window of whole lines: [m_position, m_end)
  const char* m_end = nullptr;
  const char* m_origin = nullptr; ///< where m_originOffset is; at or before m_position
  std::uint64_t m_originOffset = 0;
  std::uint64_t m_line = 1;
};

/// How often a byte occurs in a text, and a second one, in one pass at memory speed.
struct ByteCounts
{
  std::uint64_t first = 0;
  std::uint64_t second = 0;
};
ByteCounts countBytes(std::string_view text, char first, char second);

} // namespace mote

#endif
