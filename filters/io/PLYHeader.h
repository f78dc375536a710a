#ifndef MotePLYHeader_h
#define MotePLYHeader_h

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace mote
{

class TextCursor;

/// What a PLY file says of itself before its values.
struct PLYHeader
{
  enum class Format
  {
    Text,
    LittleEndian,
    BigEndian
  };

  enum class Type
  {
    None,
    Signed,
    Unsigned,
    Float
  };

  struct Number
  {
    Type type = Type::None;
    std::size_t bytes = 0;
  };

  /// One value, or a list of values after their number.
  struct Property
  {
    std::string name;
    Number count; ///< of a list; None for one value
    Number value;
    bool isList() const { return count.type != Type::None; }
  };

  struct Element
  {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;

    const Property* find(const std::string& property) const;
    bool hasLists() const;
    std::size_t bytes() const; ///< of one element without lists
  };

  Format format = Format::Text;
  std::vector<Element> elements;

  const Element* find(const std::string& element) const;
};

/// Longest line of text, in bytes, as of VTK's reader.
constexpr std::size_t longestPLYLine = 4000;

/// Reads the header at the beginning of a file, which the cursor is then behind. Throws FileError:
/// OtherFormat where the file begins otherwise, Malformed, with the line, for what is not of the
/// format, or is of the format and not read.
PLYHeader readPLYHeader(TextCursor& cursor);

} // namespace mote

#endif
