#ifndef MoteImageCheck_h
#define MoteImageCheck_h

#include <cstdint>
#include <string>

namespace mote::imaging
{

/// The most bytes, and pixels, that a file of so many bytes may announce: packers make a byte of
/// some thousand equal ones, those of OpenEXR of some ten thousand in a flat image.
std::uint64_t mostOf(std::uint64_t fileBytes);

/// Throws ImageError for an OpenEXR or PNG file whose header announces more than the file can hold,
/// or is not of the form for which the libraries take memory as it says. Says nothing about files
/// of other kinds.
void checkImage(const std::string& fileName);

} // namespace mote::imaging

#endif
