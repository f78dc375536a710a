#ifndef MoteGzipStream_h
#define MoteGzipStream_h

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace mote
{

class TextFile;

/// Inflates a gzip file from beginning to end, and again from any place it has been at.
///
/// Deflated data have no random access, so a snapshot keeps a copy of zlib's whole state (some
/// 40 KiB, mostly the last 32 KiB of text): restoring one costs nothing, where starting over would
/// inflate all that lies before. Files of several gzip members (`cat a.gz b.gz`) are one text.
class GzipStream
{
public:
  struct State; // zlib's, whose header stays out of this one

  /// A place in the stream that can be returned to, by this or another stream over the same file.
  struct Snapshot
  {
    std::uint64_t textOffset = 0; ///< bytes of text before it
    std::uint64_t fileOffset = 0; ///< bytes of the file before it
    bool finished = false;
    std::shared_ptr<const State> state;
  };

  /// The file must be gzip, and outlive the stream.
  explicit GzipStream(const TextFile& file);
  ~GzipStream();
  GzipStream(const GzipStream&) = delete;
  GzipStream& operator=(const GzipStream&) = delete;

  /// Inflates up to `count` bytes into `out` and returns how many; 0 means the end. Throws
  /// FileError when the data are damaged or end too early, after all that lies before has been
  /// handed out.
  std::size_t read(char* out, std::size_t count);

  Snapshot snapshot() const;
  void restore(const Snapshot& snapshot);

  std::uint64_t textOffset() const { return m_textOffset; } ///< bytes of text inflated so far
  std::uint64_t fileOffset() const;                         ///< bytes of the file that they took

private:
  bool fillInput();
  void nextMember();
  void inflateMore();

  const TextFile& m_file;
  std::unique_ptr<State> m_state;
  std::vector<unsigned char> m_input;
  std::uint64_t m_inputOffset = 0; ///< in the file, of the first byte after m_input
  std::uint64_t m_textOffset = 0;
  bool m_finished = false;
};

} // namespace mote

#endif
