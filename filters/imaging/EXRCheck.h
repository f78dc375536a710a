#ifndef MoteEXRCheck_h
#define MoteEXRCheck_h

#include <cstdint>
#include <string>

namespace mote::imaging
{

/// The most bytes, and pixels, that a file of so many bytes may announce: the best packer makes a
/// byte of some thousand equal ones.
std::uint64_t mostOf(std::uint64_t fileBytes);

/// Throws ImageError for an OpenEXR file whose header announces more than the file can hold, for
/// which the library would take memory. Says nothing about files of other kinds.
void checkEXR(const std::string& fileName);

} // namespace mote::imaging

#endif
