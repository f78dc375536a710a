// Writing a .mote file: what all kinds share.

#include "detail/FileWriter.h"

#include "Error.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>

namespace mote
{

Extremes::Extremes(int components)
  : ranges(static_cast<std::size_t>(components) + 1,
      {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()})
{
}

void Extremes::add(const ArrayView& values, std::size_t first, std::size_t last)
{
  for (std::size_t i = first; i < last; ++i)
    for (std::size_t k = 0; k < ranges.size(); ++k)
    {
      const bool whole = k + 1 == ranges.size();
      const double v = values.value(i, whole ? ArrayView::magnitude : static_cast<int>(k));
      if (std::isfinite(v))
        ranges[k] = {std::min(ranges[k][0], v), std::max(ranges[k][1], v)};
      finite = finite && std::isfinite(v);
    }
}

void Extremes::add(const Extremes& other)
{
  for (std::size_t k = 0; k < ranges.size(); ++k)
    ranges[k] = {
      std::min(ranges[k][0], other.ranges[k][0]), std::max(ranges[k][1], other.ranges[k][1])};
  finite = finite && other.finite;
}

Extremes extremesOf(const ArrayView& values)
{
  return tbb::parallel_reduce(
    tbb::blocked_range<std::size_t>(0, values.count(), 1 << 12), Extremes(values.components()),
    [&](const tbb::blocked_range<std::size_t>& range, Extremes found)
    {
      found.add(values, range.begin(), range.end());
      return found;
    },
    [](Extremes a, const Extremes& b)
    {
      a.add(b);
      return a;
    });
}

void copyTuple(unsigned char* to, const unsigned char* from, std::size_t size)
{
  if (size == 4)
    std::memcpy(to, from, 4);
  else if (size == 8)
    std::memcpy(to, from, 8);
  else
    std::memcpy(to, from, size);
}

void checkArrays(const std::vector<NamedArray>& arrays, std::uint64_t tuples, const char* many,
  const std::string& taken)
{
  std::set<std::string> names;
  for (const NamedArray& array : arrays)
  {
    const std::string quoted = "\"" + array.name + "\"";
    if (array.name.empty())
      throw Error("An array needs a name to be written.");
    if (!names.insert(array.name).second || array.name == taken)
      throw Error("Two arrays are named " + quoted + ".");
    if (array.values.count() != tuples || bytesOf(array.values.type()) == 0)
      throw Error("The array " + quoted + " has " + std::to_string(array.values.count()) +
                  " values for " + std::to_string(tuples) + ' ' + many + '.');
  }
}

void FileWriter::begin(const std::vector<unsigned char>& header, std::uint64_t total)
{
  file_.write(header.data(), header.size());
  place_ = header.size();
  total_ = total + header.size();
}

bool FileWriter::put(const void* data, std::size_t size)
{
  file_.write(data, size);
  place_ += size;
  return !progress_ || progress_(std::min(1.0, double(place_) / double(total_)));
}

FileSection FileWriter::section(std::uint64_t bytes)
{
  static constexpr std::array<unsigned char, FileSection::alignment> nothing{};
  if (const std::uint64_t over = place_ % FileSection::alignment; over > 0)
    this->put(nothing.data(), FileSection::alignment - over);
  return {place_, bytes};
}

bool FileWriter::putArray(FileTableRow& row)
{
  FileSection& section = row.entry.section;
  section = this->section(section.bytes);
  const ArrayView& values = row.array.values;
  complete(row, extremesOf(values));
  return section.bytes == 0 || this->put(values.data(), section.bytes);
}

void FileWriter::end(const std::vector<unsigned char>& header)
{
  file_.rewrite(0, header.data(), header.size());
  file_.commit();
}

void complete(FileTableRow& row, const Extremes& found)
{
  row.array.ranges = found.ranges;
  row.array.finite = found.finite;
  row.entry.finite = found.finite;
}

} // namespace mote
