#pragma once

#include <cstdint>
#include <string>

namespace mote
{

/// A file as memory that can be read. Its pages come in when they are first read, and go again when
/// memory is short, so that neither time nor memory depends on the size of the file.
///
/// The file must not be made shorter while it is mapped: reading what is no longer there ends the
/// process. To replace it by another of the same name (as AtomicFile does) is safe.
class MappedFile
{
public:
  /// How pages come in.
  enum class Paging
  {
    Ahead, ///< those beside them too, which are wanted soon; but of files larger than memory:
    Single ///< one by one
  };

  /// Throws Error where the file is missing, unreadable, or not a regular file.
  explicit MappedFile(const std::string& name, Paging paging = Paging::Ahead);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  const std::string& name() const { return name_; }
  std::uint64_t size() const { return size_; }
  /// Null for an empty file.
  const unsigned char* data() const { return data_; }
  Paging paging() const { return paging_; }
  /// Has the system read a part that will be wanted, whose begin is that of a page, in one go.
  void fetch(std::uint64_t offset, std::uint64_t bytes) const;

private:
  std::string name_;
  std::uint64_t size_ = 0;
  const unsigned char* data_ = nullptr;
  Paging paging_;
};

} // namespace mote
