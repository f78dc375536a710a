#ifndef MoteOpenMoteFile_h
#define MoteOpenMoteFile_h

#include "FileError.h"

#include "kernels/core/Error.h"

#include <memory>
#include <string>

namespace mote
{

/// Opens a .mote file of a kind. Throws FileError.
template <typename File>
std::shared_ptr<const File> openMoteFile(const std::string& name)
{
  try
  {
    return std::make_shared<const File>(name);
  }
  catch (const Error& error)
  {
    throw FileError(FileError::Kind::Malformed, name, withoutFile(error.what(), name));
  }
}

} // namespace mote

#endif
