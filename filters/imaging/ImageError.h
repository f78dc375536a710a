/**
 * The exception that the plain parts of this module throw, and that its classes report.
 */

#ifndef MoteImageError_h
#define MoteImageError_h

#include <stdexcept>
#include <string>

namespace mote::imaging
{

/**
 * One sentence for the user, and its vtkErrorCode.
 */
class ImageError : public std::runtime_error
{
public:
  ImageError(unsigned long code, const std::string& sentence)
    : std::runtime_error(sentence)
    , m_code(code)
  {
  }
  unsigned long code() const { return m_code; }

private:
  unsigned long m_code;
};

} // namespace mote::imaging

#endif
