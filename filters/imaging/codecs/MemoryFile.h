/**
 * A file in memory for OpenImageIO to write.
 */

#ifndef MoteMemoryFile_h
#define MoteMemoryFile_h

#include <OpenImageIO/filesystem.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mote::imaging
{

/**
 * Can also be read while it is written, which OpenImageIO's own IOVecOutput cannot: libtiff reads
 * its directories back to link them, and makes broken files without a word if that fails.
 */
class MemoryFile : public OIIO::Filesystem::IOProxy
{
public:
  MemoryFile()
    : IOProxy("", Write)
  {
  }
  const char* proxytype() const override { return "memory"; }
  std::size_t read(void* to, std::size_t size) override;
  std::size_t write(const void* from, std::size_t size) override;
  std::size_t pread(void* to, std::size_t size, std::int64_t offset) override;
  std::size_t pwrite(const void* from, std::size_t size, std::int64_t offset) override;
  std::size_t size() const override { return m_bytes.size(); }

  std::vector<unsigned char> takeBytes() { return std::move(m_bytes); }

private:
  std::vector<unsigned char> m_bytes;
};

} // namespace mote::imaging

#endif
