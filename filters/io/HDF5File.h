#ifndef MoteHDF5File_h
#define MoteHDF5File_h

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mote
{

/// What is known of an array of an HDF5 file.
struct HDF5Array
{
  std::vector<std::uint64_t> dimensions;
  bool isWhole = false;  ///< whole numbers, of up to 64 bits
  bool isNumber = false; ///< these, or floating point
  bool isSigned = false;
  std::size_t bytes = 0; ///< of a number

  std::uint64_t rows() const { return dimensions.empty() ? 0 : dimensions.front(); }
  /// Of each row, where arrays have one dimension or two; else 0.
  std::uint64_t columns() const
  {
    return dimensions.size() == 1 ? 1 : dimensions.size() == 2 ? dimensions[1] : 0;
  }
};

/// An HDF5 file that is open for reading. Paths in it begin with "/". Throws FileError for files
/// that cannot be opened and values that cannot be read; HDF5 itself prints nothing.
class HDF5File
{
public:
  explicit HDF5File(const std::string& path);
  ~HDF5File();
  HDF5File(const HDF5File&) = delete;
  HDF5File& operator=(const HDF5File&) = delete;

  const std::string& path() const { return m_path; }

  /// The names of what a group holds, in alphabetical order; none where there is no such group.
  std::vector<std::string> namesIn(const std::string& group) const;
  bool isGroup(const std::string& name) const;
  /// None where there is no such array.
  std::optional<HDF5Array> array(const std::string& name) const;
  /// The numbers of an attribute of a group or an array; none where there is no such.
  std::vector<double> numbers(const std::string& of, const std::string& attribute) const;
  /// The text of an attribute; empty where there is no such.
  std::string text(const std::string& of, const std::string& attribute) const;
  bool hasAttribute(const std::string& of, const std::string& attribute) const;

  /// Rows [first, first + count) of an array of one dimension or two.
  void read(
    const std::string& name, std::uint64_t first, std::uint64_t count, double* values) const;
  void read(
    const std::string& name, std::uint64_t first, std::uint64_t count, std::int64_t* values) const;
  /// The same of an array of any dimensions, as numbers of the array's own type: float or double,
  /// or whole ones of as many bytes.
  void readAsStored(
    const std::string& name, std::uint64_t first, std::uint64_t count, void* values) const;

private:
  void readAs(std::int64_t memoryType, const std::string& name, std::uint64_t first,
    std::uint64_t count, void* values) const;
  void readSlab(std::int64_t memoryType, const std::string& name, const HDF5Array& known,
    std::uint64_t first, std::uint64_t count, void* values) const;
  [[noreturn]] void failToRead(const std::string& name) const;

  std::string m_path;
  std::int64_t m_file = -1;
  std::uint64_t m_bytes = 0;
};

} // namespace mote

#endif
