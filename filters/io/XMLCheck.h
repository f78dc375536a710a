#ifndef MoteXMLCheck_h
#define MoteXMLCheck_h

#include <string>

namespace mote
{

/// Throws FileError where the elements of a VTK XML file, or of the files that it names, have
/// numbers that cannot be: points or cells that the file has no room for, whatever packs them, and
/// indices or components by the million. VTK 9.1's readers take memory for them, or never end.
void checkVTKXML(const std::string& path);

/// Throws FileError where packed values of a VTK XML file say that they take, or stand for, more
/// bytes than the file has room for, or where they do not begin in it. VTK 9.1's readers take
/// memory for what they say. Other files that it names are not looked at.
void checkVTKXMLValues(const std::string& path);

/// Throws FileError where elements of XML lie in one another more than a hundred deep, which
/// nothing but damage has: libraries free them by functions that call themselves until the stack is
/// full. checkVTKXML() does that, too.
void checkXMLDepth(const std::string& path);

} // namespace mote

#endif
