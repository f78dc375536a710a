#ifndef MoteXMLNames_h
#define MoteXMLNames_h

#include "vtkXMLUtilities.h"

#include <sstream>
#include <string>

namespace mote
{

/// A text of any characters as it stands in an attribute of an XML file.
inline std::string xmlEncoded(const std::string& text)
{
  std::ostringstream encoded;
  vtkXMLUtilities::EncodeString(text.c_str(), VTK_ENCODING_UTF_8, encoded, VTK_ENCODING_UTF_8, 1);
  return encoded.str();
}

} // namespace mote

#endif
