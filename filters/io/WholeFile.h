#ifndef MoteWholeFile_h
#define MoteWholeFile_h

#include "TextFile.h"

#include <string>
#include <string_view>

namespace mote
{

/// All bytes of a file: mapped, or, of a gzip file, inflated in memory.
class WholeFile
{
public:
  /// Throws FileError where the file cannot be opened or its gzip data are damaged.
  explicit WholeFile(const std::string& path);

  const std::string& path() const { return m_file.path(); }
  std::string_view bytes() const
  {
    return m_file.isGzip() ? std::string_view(m_inflated) : m_file.text();
  }

private:
  TextFile m_file;
  std::string m_inflated;
};

} // namespace mote

#endif
