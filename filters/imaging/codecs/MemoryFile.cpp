#include "MemoryFile.h"

#include <algorithm>
#include <cstring>

namespace mote::imaging
{

std::size_t MemoryFile::read(void* to, std::size_t size)
{
  const std::size_t count = pread(to, size, m_pos);
  m_pos += static_cast<std::int64_t>(count);
  return count;
}

std::size_t MemoryFile::write(const void* from, std::size_t size)
{
  const std::size_t count = pwrite(from, size, m_pos);
  m_pos += static_cast<std::int64_t>(count);
  return count;
}

std::size_t MemoryFile::pread(void* to, std::size_t size, std::int64_t offset)
{
  if (offset < 0 || static_cast<std::size_t>(offset) >= m_bytes.size())
    return 0;
  const std::size_t count = std::min(size, m_bytes.size() - static_cast<std::size_t>(offset));
  std::memcpy(to, m_bytes.data() + offset, count);
  return count;
}

std::size_t MemoryFile::pwrite(const void* from, std::size_t size, std::int64_t offset)
{
  if (offset < 0)
    return 0;
  const std::size_t end = static_cast<std::size_t>(offset) + size;
  if (size > 0 && end > m_bytes.size())
    m_bytes.resize(end);
  if (size > 0)
    std::memcpy(m_bytes.data() + offset, from, size);
  return size;
}

} // namespace mote::imaging
