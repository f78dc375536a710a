/**
 * A file that appears under its name complete or not at all.
 */

#ifndef MoteAtomicFile_h
#define MoteAtomicFile_h

#include <cstddef>
#include <string>

namespace mote::imaging
{

/**
 * Whether a regular file of this name can be made or replaced, as far as can be seen without
 * writing. Throws ImageError with the reason if not.
 */
void checkWritable(const std::string& name);

/**
 * Writes into a temporary file in the folder of `name`; commit() renames it to `name`. What is not
 * committed is removed. Where `name` is a symbolic link, the file that it points to is
 * replaced and the link stays; a file that is replaced passes its permissions on.
 *
 * Every function throws ImageError with a sentence that names the file: the folder is missing or
 * read-only, the disk is full, `name` is a folder or a device.
 */
class AtomicFile
{
public:
  explicit AtomicFile(const std::string& name);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(const unsigned char* data, std::size_t size);
  void commit();

private:
  void remove();

  std::string m_name;          // as the user gave it, for messages
  std::string m_targetName;    // with links resolved
  std::string m_temporaryName; // empty when there is nothing left to remove
  int m_descriptor = -1;
};

} // namespace mote::imaging

#endif
