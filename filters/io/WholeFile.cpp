#include "WholeFile.h"

#include "GzipStream.h"

namespace mote
{

WholeFile::WholeFile(const std::string& path)
  : m_file(path)
{
  if (!m_file.isGzip())
    return;
  GzipStream stream(m_file);
  std::string part(std::size_t{1} << 20, '\0');
  while (const std::size_t count = stream.read(part.data(), part.size()))
    m_inflated.append(part.data(), count);
}

} // namespace mote
