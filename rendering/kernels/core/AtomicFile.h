#pragma once

#include "Error.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace mote
{

/// Why a file could not be written, in a sentence that names it.
class WriteError : public Error
{
public:
  enum class Kind
  {
    CannotOpen, ///< the folder is missing or read-only, `name` is a folder or a device
    NoSpace     ///< the disk is full, or a quota or limit used up
  };
  WriteError(Kind kind, const std::string& sentence)
    : Error(sentence)
    , kind_(kind)
  {
  }
  Kind kind() const { return kind_; }

private:
  Kind kind_;
};

/// Whether a regular file of this name can be made or replaced, as far as can be seen without
/// writing. Throws WriteError with the reason if not.
void checkWritable(const std::string& name);

/// Throws a WriteError that says what the system's error `error` means for the file `name`.
[[noreturn]] void throwWriteError(const std::string& name, int error);

/// Opens a new file, to be read and written, in the folder of the file `beside`. It has no name,
/// and is gone when it is closed. Throws WriteError.
int openNameless(const std::string& beside);

/// Brings the file `written` to the disk and gives it the name `name` then, in place of what is
/// there. Both are in one folder. Throws WriteError.
void moveIntoPlace(const std::string& written, const std::string& name);

/// A file that appears under its name complete or not at all.
///
/// Writes into a file in the folder of `name` that has no name, or a temporary one where the file
/// system knows no other; commit() gives it its name. What is not committed is removed. Where
/// `name` is a symbolic link, the file that it points to is replaced and the link stays; a file
/// that is replaced passes its permissions on.
///
/// Every function throws WriteError.
class AtomicFile
{
public:
  explicit AtomicFile(const std::string& name);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Appends.
  void write(const void* data, std::size_t size);
  /// Overwrites what was written from `offset` on.
  void rewrite(std::uint64_t offset, const void* data, std::size_t size);
  /// A name under which a library may open the file, and write it in place of write(), until
  /// commit(). It may not remove it.
  std::string openName() const;
  void commit();

private:
  void open();
  int giveName();
  void remove();
  template <typename Put>
  void putAll(const void* data, std::size_t size, const Put& put);

  std::string name_;          ///< as the user gave it, for messages
  std::string targetName_;    ///< with links resolved
  std::string temporaryName_; ///< empty while there is nothing to remove
  int descriptor_ = -1;
};

} // namespace mote
