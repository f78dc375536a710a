#ifndef MoteFoamListFile_h
#define MoteFoamListFile_h

#include "WholeFile.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>

namespace mote
{

/// Goes through a file of OpenFOAM, which is of lists and entries, in text or in bytes, packed or
/// not.
class FoamListFile
{
public:
  /// Reads the head. Throws FileError where there is none, and what else may be thrown for a file.
  explicit FoamListFile(const std::string& path);

  bool isBinary() const { return isBinary_; }
  const std::string& kind() const { return kind_; } ///< its class, such as labelList

  /// The next list of labels: calls visit(label); returns how many.
  template <class Visit>
  std::int64_t labels(const Visit& visit)
  {
    const std::int64_t count = this->beginList();
    if (isBinary_ && count > this->left() / labelBytes_)
      this->failAtEnd();
    for (std::int64_t i = 0; i < count; ++i)
      visit(isBinary_ ? this->rawLabel() : this->number());
    this->expect(')');
    return count;
  }

  /// The next list of places, of which only the number is told.
  std::int64_t places();
  /// Whether so many places follow, with nothing else among them, and the head is whole.
  bool arePlaces(std::int64_t count);

  /// The faces of a list in text, "4(0 1 2 3)": calls visit(label); returns how many.
  template <class Visit>
  std::int64_t faces(const Visit& visit)
  {
    const std::int64_t count = this->beginList();
    for (std::int64_t i = 0; i < count; ++i)
    {
      const std::int64_t corners = this->number();
      this->expect('(');
      for (std::int64_t k = 0; k < corners; ++k)
        visit(this->number());
      this->expect(')');
    }
    return count;
  }

  /// The patches of a boundary: each a name and what stands in braces.
  void patches();

  /// The lists of values in a field, for which memory is taken before they are read: they must have
  /// room in the file, or, where they are of one value, "12{0}", at most as many as there are
  /// places.
  template <class Places>
  void valueLists(const Places& places)
  {
    constexpr std::string_view name = "List<";
    const std::size_t begin = at_;
    for (std::size_t at = text_.find(name, at_); at != text_.npos; at = text_.find(name, at + 1))
    {
      at_ = std::min(text_.find('>', at), text_.size() - 1) + 1;
      this->valueList(places);
    }
    at_ = begin;
  }

  /// One such list, such as the values of a cloud's particles. places() tells how many there may
  /// be.
  template <class Places>
  void valueList(const Places& places)
  {
    this->skip();
    std::int64_t count = 0;
    const char* const end = text_.data() + text_.size();
    const auto [stop, error] = std::from_chars(text_.data() + at_, end, count);
    if (error == std::errc::invalid_argument)
      return; // what is no number the reader finds itself
    const std::size_t number = at_;
    at_ = static_cast<std::size_t>(stop - text_.data());
    this->skip();
    const bool isOfOne = at_ < text_.size() && text_[at_] == '{';
    if (error != std::errc() || count < 0 || count > (isOfOne ? places() : this->left()))
      this->fail(
        std::string(isOfOne ? "there are not as many places as" : "the file has no room for") +
        " a list that says how long it is at byte " + std::to_string(number));
  }

  /// How many entries the list has that begins here; none where there is no number.
  std::int64_t length();

  /// What a field has on the boundary, which must stand in braces where it is there.
  void boundaryField();

  /// Braces and brackets that lie in one another more deeply than in any case, which the reader
  /// goes through by functions that call themselves until the stack is full.
  void requireShallow(bool headOnly = false) const;

  /// Throws FileError of this file.
  [[noreturn]] void fail(const std::string& sentence) const;

private:
  [[noreturn]] void failAtEnd() const;
  void readHead();
  bool isRawList() const;
  std::int64_t rawBytes(std::size_t at) const;
  std::size_t behindText(std::size_t at) const;
  std::int64_t left() const { return static_cast<std::int64_t>(text_.size() - at_); }
  void skip();
  std::int64_t number();
  void expect(char wanted);
  std::int64_t beginList();
  std::int64_t rawLabel();

  WholeFile file_;
  std::string_view text_;
  std::size_t at_ = 0;
  bool isBinary_ = false;
  std::string kind_;
  bool hasWholeHead_ = false;
  std::int64_t labelBytes_ = 4, scalarBytes_ = 8;
};

} // namespace mote

#endif
