#include "GadgetFile.h"

#include "FileError.h"
#include "NumberAt.h"
#include "WholeFile.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mote
{
namespace
{

constexpr std::size_t headerBytes = 256;
constexpr std::size_t kinds = 6;

/// A record of Fortran: its length stands before and behind it.
struct Block
{
  std::string name;
  std::string_view bytes;
};

class Gadget final : public StepSource
{
public:
  explicit Gadget(const std::string& path)
    : m_file(path)
    , m_bytes(m_file.bytes())
  {
    readBlocks();
    readHeader();
  }

  std::vector<double> times() const override { return {m_time}; }

  std::string warning() const override
  {
    return m_files <= 1 ? std::string()
                        : m_file.path() + ": this is one of the " + std::to_string(m_files) +
                            " files of a snapshot, and only its own particles are read";
  }

  void read(const SourceRequest& request, vtkPolyData* output) override
  {
    RowLayout layout(m_total);
    std::vector<Column> columns;
    const auto add = [&](const char* block, const char* name, ColumnType type, std::size_t count)
    {
      if (const Block* found = blockNamed(block))
        columns.push_back(
          {found, std::string(name).empty() ? 0 : layout.add(name, type, count), count});
    };
    layout.addPositions();
    add("POS ", "", ColumnType::Float64, 3);
    const std::size_t type = layout.add("type", ColumnType::Int32);
    const std::size_t mass = layout.add("mass", ColumnType::Float64);
    add("ID  ", "id", ColumnType::Int64, 1);
    add("VEL ", "v", ColumnType::Float64, 3);
    add("U   ", "u", ColumnType::Float64, 1);
    add("RHO ", "rho", ColumnType::Float64, 1);
    makePointRows(
      layout.rowsFor(request),
      [&](std::uint64_t first, std::uint64_t count, const std::vector<TextColumn>& targets,
        const RowsStored&)
      {
        for (const Column& column : columns)
          store(column, first, count, targets);
        storeTypes(targets[type], targets[mass], first, count);
        return RowsResult();
      },
      output);
    addTypeNames(gadgetTypeNames(), output);
    if (m_box > 0)
      addBox({m_box, 0, 0, 0, m_box, 0, 0, 0, m_box}, {0, 0, 0}, "pp pp pp", output);
  }

private:
  /// Values of a block, and the columns that they go to.
  struct Column
  {
    const Block* block = nullptr;
    std::size_t first = 0, count = 1;
  };

  [[noreturn]] void fail(FileError::Kind kind, const std::string& sentence) const
  {
    throw FileError(kind, m_file.path(), sentence);
  }

  std::uint32_t lengthAt(std::size_t at) const
  {
    if (m_bytes.size() - at < 4)
      fail(FileError::Kind::Truncated, "the file ends within a block: it is truncated");
    return numberAt<std::uint32_t>(m_bytes.data() + at, m_isSwapped);
  }

  std::string_view recordAt(std::size_t& at) const
  {
    const std::uint32_t length = lengthAt(at);
    if (m_bytes.size() - at < std::size_t{length} + 8)
      fail(FileError::Kind::Truncated, "the file ends within a block: it is truncated");
    if (lengthAt(at + 4 + length) != length)
      fail(FileError::Kind::Malformed, "the lengths before and behind a block differ");
    const std::string_view record = m_bytes.substr(at + 4, length);
    at += std::size_t{length} + 8;
    return record;
  }

  void readBlocks()
  {
    if (m_bytes.size() < 4)
      fail(FileError::Kind::Truncated, "the file is empty");
    const std::uint32_t first = lengthAt(0);
    m_isSwapped = first != headerBytes && first != 8;
    const bool isNamed = lengthAt(0) == 8;
    std::size_t at = 0;
    while (at < m_bytes.size())
    {
      std::string name;
      if (isNamed)
        name = std::string(recordAt(at).substr(0, 4));
      if (isNamed && at == m_bytes.size())
        fail(FileError::Kind::Truncated, "the file ends where a block should be: it is truncated");
      m_blocks.push_back({name, recordAt(at)});
    }
    if (m_blocks.front().bytes.size() != headerBytes)
      fail(FileError::Kind::Malformed, "its header is not of 256 bytes");
    if (!isNamed)
      for (const char* usual : {"HEAD", "POS ", "VEL ", "ID  "})
        if (m_named < m_blocks.size())
          m_blocks[m_named++].name = usual;
  }

  void readHeader()
  {
    const char* const head = m_blocks.front().bytes.data();
    for (std::size_t kind = 0; kind < kinds; ++kind)
    {
      m_counts[kind] = numberAt<std::uint32_t>(head + 4 * kind, m_isSwapped);
      m_masses[kind] = numberAt<double>(head + 24 + 8 * kind, m_isSwapped);
      m_total += m_counts[kind];
      m_ownMasses += m_masses[kind] == 0.0 ? m_counts[kind] : 0;
    }
    m_time = numberAt<double>(head + 72, m_isSwapped);
    m_files = numberAt<std::int32_t>(head + 124, m_isSwapped);
    m_box = numberAt<double>(head + 128, m_isSwapped);
    if (!std::isfinite(m_time) || !std::isfinite(m_box))
      fail(FileError::Kind::Malformed, "the time or the box of its header is no number");
    nameOptional();
    require("POS ", m_total, 3, true);
    require("VEL ", m_total, 3, false);
    require("ID  ", m_total, 1, false);
    require("MASS", m_ownMasses, 1, m_ownMasses > 0);
    require("U   ", m_counts[0], 1, false);
    require("RHO ", m_counts[0], 1, false);
  }

  /// Blocks without names: masses where particles have their own, then those of gas.
  void nameOptional()
  {
    if (m_named == 0)
      return;
    std::vector<const char*> usual;
    if (m_ownMasses > 0)
      usual.push_back("MASS");
    if (m_counts[0] > 0)
      usual.insert(usual.end(), {"U   ", "RHO "});
    for (const char* name : usual)
      if (m_named < m_blocks.size())
        m_blocks[m_named++].name = name;
  }

  const Block* blockNamed(const std::string& name) const
  {
    const auto found = std::find_if(
      m_blocks.begin(), m_blocks.end(), [&](const Block& block) { return block.name == name; });
    return found == m_blocks.end() ? nullptr : &*found;
  }

  /// That a block holds so many values of four bytes or of eight.
  void require(const std::string& name, std::uint64_t particles, std::size_t each, bool isNeeded)
  {
    const Block* block = blockNamed(name);
    const std::uint64_t values = particles * each;
    if (!block && isNeeded)
      fail(FileError::Kind::Malformed, "it has no block '" + name + "'");
    if (block && block->bytes.size() != 4 * values && block->bytes.size() != 8 * values)
      fail(FileError::Kind::Malformed,
        "its block '" + name + "' of " + std::to_string(block->bytes.size()) +
          " bytes does not hold " + std::to_string(values) + " values");
  }

  double realAt(const Block& block, std::size_t bytes, std::uint64_t value) const
  {
    const char* const at = block.bytes.data() + bytes * value;
    return bytes == 8 ? numberAt<double>(at, m_isSwapped)
                      : static_cast<double>(numberAt<float>(at, m_isSwapped));
  }

  static std::size_t bytesOf(const Block& block, std::uint64_t values)
  {
    return block.bytes.size() == 8 * values ? 8 : 4;
  }

  void store(const Column& column, std::uint64_t first, std::uint64_t count,
    const std::vector<TextColumn>& targets) const
  {
    const Block& block = *column.block;
    const bool areIds = block.name == "ID  ";
    const bool isOfGas = block.name == "U   " || block.name == "RHO ";
    const std::uint64_t there = isOfGas ? m_counts[0] : m_total;
    const std::size_t bytes = bytesOf(block, there * column.count);
    for (std::uint64_t i = 0; i < count; ++i)
      for (std::size_t c = 0; c < column.count; ++c)
      {
        const std::uint64_t value = (first + i) * column.count + c;
        const TextColumn& target = targets[column.first + c];
        if (first + i >= there)
          storeNumber(target, i, std::numeric_limits<double>::quiet_NaN());
        else if (!areIds)
          storeNumber(target, i, realAt(block, bytes, value));
        else if (bytes == 8)
          storeNumber(
            target, i, numberAt<std::int64_t>(block.bytes.data() + 8 * value, m_isSwapped));
        else
          storeNumber(
            target, i, numberAt<std::uint32_t>(block.bytes.data() + 4 * value, m_isSwapped));
      }
  }

  void storeTypes(const TextColumn& types, const TextColumn& masses, std::uint64_t first,
    std::uint64_t count) const
  {
    const Block* own = blockNamed("MASS");
    const std::size_t bytes = own ? bytesOf(*own, m_ownMasses) : 4;
    std::uint64_t before = 0, ownBefore = 0; // particles of the kinds before
    for (std::size_t kind = 0; kind < kinds; ++kind)
    {
      const std::uint64_t begin = std::max(first, before);
      const std::uint64_t end = std::min(first + count, before + m_counts[kind]);
      for (std::uint64_t i = begin; i < end; ++i)
      {
        storeNumber(types, i - first, kind);
        storeNumber(masses, i - first,
          m_masses[kind] != 0.0 ? m_masses[kind] : realAt(*own, bytes, ownBefore + i - before));
      }
      before += m_counts[kind];
      ownBefore += m_masses[kind] == 0.0 ? m_counts[kind] : 0;
    }
  }

  WholeFile m_file;
  std::string_view m_bytes;
  bool m_isSwapped = false;
  std::vector<Block> m_blocks;
  std::size_t m_named = 0; ///< blocks without names that have got one
  std::array<std::uint64_t, kinds> m_counts{};
  std::array<double, kinds> m_masses{}; ///< 0 for particles that have their own
  std::uint64_t m_total = 0, m_ownMasses = 0;
  double m_time = 0, m_box = 0;
  std::int32_t m_files = 1;
};

} // namespace

const std::map<int, std::string>& gadgetTypeNames()
{
  static const std::map<int, std::string> names = {
    {0, "gas"}, {1, "halo"}, {2, "disk"}, {3, "bulge"}, {4, "stars"}, {5, "boundary"}};
  return names;
}

bool looksLikeGadget(std::string_view beginning)
{
  if (beginning.size() < 4)
    return false;
  for (const bool swapped : {false, true})
  {
    const auto length = numberAt<std::uint32_t>(beginning.data(), swapped);
    if (length == headerBytes || (length == 8 && beginning.substr(4, 4) == "HEAD"))
      return true;
  }
  return false;
}

std::unique_ptr<StepSource> openGadget(const std::string& path)
{
  return std::make_unique<Gadget>(path);
}

} // namespace mote
