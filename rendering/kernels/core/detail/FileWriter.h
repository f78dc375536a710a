#pragma once

#include "../AtomicFile.h"
#include "../Progress.h"
#include "FileHeader.h"

#include <string>

namespace mote
{

/// The extremes of an array's finite values.
struct Extremes
{
  std::vector<FileArray::Range> ranges; ///< of each component, then of the magnitude
  bool finite = true;

  explicit Extremes(int components);
  void add(const ArrayView& values, std::size_t first, std::size_t last);
  void add(const Extremes& other);
};

/// Looks in parallel.
Extremes extremesOf(const ArrayView& values);

/// Copies whole tuples: the size of one is known to the compiler where it is a usual one.
void copyTuple(unsigned char* to, const unsigned char* from, std::size_t size);

/// Throws Error where an array has no name or that of another, of `taken` too, or not `tuples`
/// tuples of numbers, each for one of what `many` names.
void checkArrays(const std::vector<NamedArray>& arrays, std::uint64_t tuples, const char* many,
  const std::string& taken);

/// A .mote file that is written section by section. Throws WriteError where it cannot be.
class FileWriter
{
public:
  /// `header` is what stands there until end(), and as long.
  FileWriter(const std::string& name, const Progress& progress)
    : progress_(progress)
    , file_(name)
  {
  }

  /// To be called first; `total` bytes are to follow, for the progress.
  void begin(const std::vector<unsigned char>& header, std::uint64_t total);
  /// False where progress stopped it.
  bool put(const void* data, std::size_t size);
  /// Fills up to the next page, where a section of so many bytes begins.
  FileSection section(std::uint64_t bytes);
  /// A section of an array as it is, whose row it completes.
  bool putArray(FileTableRow& row);
  std::uint64_t place() const { return place_; } ///< bytes written
  /// With the header as it has become.
  void end(const std::vector<unsigned char>& header);

private:
  const Progress& progress_;
  AtomicFile file_;
  std::uint64_t place_ = 0, total_ = 0;
};

/// Tells a row what was found in its values.
void complete(FileTableRow& row, const Extremes& found);

} // namespace mote
