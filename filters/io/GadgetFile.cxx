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

/// Rows of a file, and where the first of them goes.
struct Rows
{
  std::uint64_t first = 0, count = 0, target = 0;
};

/// One file of a snapshot.
class GadgetPart
{
public:
  explicit GadgetPart(const std::string& path)
    : m_file(path)
    , m_bytes(m_file.bytes())
  {
    readBlocks();
    readHeader();
  }

  double time() const { return m_time; }
  double box() const { return m_box; }
  std::int32_t files() const { return m_files; } ///< of the snapshot
  std::uint64_t particles() const { return m_total; }
  bool has(const std::string& block) const { return blockNamed(block) != nullptr; }

  /// Stores rows of a block, of so many values a particle, in columns of which `targets` is the
  /// first: what the block does not have is not a number.
  void storeBlock(const std::string& name, std::size_t components, const Rows& rows,
    const TextColumn* targets) const
  {
    const Block* block = blockNamed(name);
    const bool areIds = name == "ID  ", isOfGas = name == "U   " || name == "RHO ";
    const std::uint64_t there = !block ? 0 : isOfGas ? m_counts[0] : m_total;
    const std::size_t bytes = block ? bytesOf(*block, there * components) : 0;
    for (std::uint64_t i = 0; i < rows.count; ++i)
      for (std::size_t c = 0; c < components; ++c)
      {
        const std::uint64_t value = (rows.first + i) * components + c;
        const std::uint64_t row = rows.target + i;
        if (rows.first + i >= there)
          storeNumber(targets[c], row, std::numeric_limits<double>::quiet_NaN());
        else if (areIds)
          storeNumber(targets[c], row, wholeAt(*block, bytes, value));
        else
          storeNumber(targets[c], row, realAt(*block, bytes, value));
      }
  }

  /// Stores the kinds and the masses of rows.
  void storeTypes(const Rows& rows, const TextColumn& types, const TextColumn& masses) const
  {
    const Block* own = blockNamed("MASS");
    const std::size_t bytes = own ? bytesOf(*own, m_ownMasses) : 4;
    std::uint64_t before = 0, ownBefore = 0; // particles of the kinds before
    for (std::size_t kind = 0; kind < kinds; ++kind)
    {
      const std::uint64_t begin = std::max(rows.first, before);
      const std::uint64_t end = std::min(rows.first + rows.count, before + m_counts[kind]);
      for (std::uint64_t i = begin; i < end; ++i)
      {
        const std::uint64_t row = rows.target + i - rows.first;
        storeNumber(types, row, kind);
        storeNumber(masses, row,
          m_masses[kind] != 0.0 ? m_masses[kind] : realAt(*own, bytes, ownBefore + i - before));
      }
      before += m_counts[kind];
      ownBefore += m_masses[kind] == 0.0 ? m_counts[kind] : 0;
    }
  }

private:
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

  std::int64_t wholeAt(const Block& block, std::size_t bytes, std::uint64_t value) const
  {
    const char* const at = block.bytes.data() + bytes * value;
    return bytes == 8 ? numberAt<std::int64_t>(at, m_isSwapped)
                      : std::int64_t{numberAt<std::uint32_t>(at, m_isSwapped)};
  }

  static std::size_t bytesOf(const Block& block, std::uint64_t values)
  {
    return block.bytes.size() == 8 * values ? 8 : 4;
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

/// The name of another file of a snapshot, by that of the first, snap_007.0 or snap_007.0.gadget;
/// empty where the name is not that of a first one.
std::string partOf(const std::string& first, int number)
{
  std::size_t mark = first.ends_with(".0") ? first.size() - 2 : first.rfind(".0.");
  if (mark == first.npos || first.find('/', mark) != first.npos)
    return {};
  std::string name = first;
  return name.replace(mark + 1, 1, std::to_string(number));
}

class Gadget final : public StepSource
{
public:
  explicit Gadget(const std::string& path)
    : m_path(path)
  {
    m_parts.push_back(std::make_unique<GadgetPart>(path));
    const int files = m_parts.front()->files();
    for (int number = 1; number < files && !partOf(path, number).empty(); ++number)
      addPart(partOf(path, number), files);
    for (const auto& part : m_parts)
      m_total += part->particles();
  }

  std::vector<double> times() const override { return {m_parts.front()->time()}; }

  std::string warning() const override
  {
    const int files = m_parts.front()->files();
    return files <= 1 || m_parts.size() > 1
             ? std::string()
             : m_path + ": this is one of the " + std::to_string(files) +
                 " files of a snapshot, and only its own particles are read; the first of them, "
                 "with .0 in its name, stands for all";
  }

  void read(const SourceRequest& request, vtkPolyData* output) override
  {
    struct Column
    {
      std::string block;
      std::size_t first, count;
    };
    RowLayout layout(m_total);
    layout.addPositions();
    std::vector<Column> columns = {{"POS ", 0, 3}};
    const std::size_t type = layout.add("type", ColumnType::Int32);
    const std::size_t mass = layout.add("mass", ColumnType::Float64);
    const auto add = [&](const char* block, const char* name, ColumnType kind, std::size_t count)
    {
      const auto has = [&](const auto& part) { return part->has(block); };
      if (std::any_of(m_parts.begin(), m_parts.end(), has))
        columns.push_back({block, layout.add(name, kind, count), count});
    };
    add("ID  ", "id", ColumnType::Int64, 1);
    add("VEL ", "v", ColumnType::Float64, 3);
    add("U   ", "u", ColumnType::Float64, 1);
    add("RHO ", "rho", ColumnType::Float64, 1);
    makePointRows(
      layout.rowsFor(request),
      [&](std::uint64_t first, std::uint64_t count, const std::vector<TextColumn>& targets,
        const RowsStored&)
      {
        std::uint64_t before = 0; // particles of the files before
        for (const auto& part : m_parts)
        {
          const std::uint64_t begin = std::max(first, before);
          const std::uint64_t end = std::min(first + count, before + part->particles());
          if (begin < end)
          {
            const Rows rows = {begin - before, end - begin, begin - first};
            for (const Column& column : columns)
              part->storeBlock(column.block, column.count, rows, &targets[column.first]);
            part->storeTypes(rows, targets[type], targets[mass]);
          }
          before += part->particles();
        }
        return RowsResult();
      },
      output);
    addTypeNames(gadgetTypeNames(), output);
    if (const double box = m_parts.front()->box(); box > 0)
      addBox({box, 0, 0, 0, box, 0, 0, 0, box}, {0, 0, 0}, "pp pp pp", output);
  }

private:
  void addPart(const std::string& name, int files)
  {
    m_parts.push_back(std::make_unique<GadgetPart>(name));
    if (m_parts.back()->files() != files)
      throw FileError(FileError::Kind::Malformed, name,
        "it does not say that it is one of " + std::to_string(files) +
          " files of a snapshot, as the first one does");
  }

  std::string m_path;
  std::vector<std::unique_ptr<GadgetPart>> m_parts;
  std::uint64_t m_total = 0;
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
