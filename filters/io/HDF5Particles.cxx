#include "HDF5Particles.h"

#include "HDF5Steps.h"

#include "FileError.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <limits>
#include <set>

namespace mote
{
namespace
{

/// Rows that are converted at a time.
constexpr std::uint64_t blockRows = std::uint64_t{1} << 16;

/// An array of all kinds of particles.
struct Merged
{
  std::string name;
  std::size_t components = 1;
  bool isWhole = true;
  std::size_t first = 0; ///< its first column
};

class HDF5Particles final : public StepSource
{
public:
  explicit HDF5Particles(const std::string& path)
  {
    m_files.push_back(std::make_unique<HDF5File>(path));
    m_steps = findHDF5Steps(*m_files.front());
    if (m_steps.files > 1)
      addOtherFiles(path);
  }

  std::vector<double> times() const override
  {
    std::vector<double> times;
    for (const HDF5Step& step : m_steps.steps)
      times.push_back(step.time);
    return times;
  }

  std::string warning() const override
  {
    return m_steps.files == m_files.size()
             ? std::string()
             : m_files.front()->path() + ": this is one of the " + std::to_string(m_steps.files) +
                 " files of a snapshot, and only its own particles are read; the first one, "
                 "with .0 in its name, stands for all";
  }

  void read(const SourceRequest& request, vtkPolyData* output) override
  {
    const HDF5Step& step = m_steps.steps[request.step];
    std::uint64_t particles = 0;
    for (const HDF5Kind& kind : step.kinds)
      particles += kind.particles;
    RowLayout layout(particles);
    layout.addPositions();
    const bool hasTypes = m_steps.hasKinds;
    const std::size_t types = hasTypes ? layout.add("type", ColumnType::Int32) : 0;
    std::vector<Merged> arrays = merge(step);
    std::erase_if(arrays, [&](const Merged& array) { return hasTypes && array.name == "type"; });
    for (Merged& array : arrays)
      array.first = layout.add(
        array.name, array.isWhole ? ColumnType::Int64 : ColumnType::Float64, array.components);
    makePointRows(
      layout.rowsFor(request),
      [&](std::uint64_t first, std::uint64_t count, const std::vector<TextColumn>& targets,
        const RowsStored&)
      {
        std::uint64_t before = 0; // particles of the kinds before
        for (const HDF5Kind& kind : step.kinds)
        {
          const std::uint64_t begin = std::max(first, before);
          const std::uint64_t end = std::min(first + count, before + kind.particles);
          for (std::uint64_t at = begin; at < end; at += blockRows)
          {
            const Rows rows = {at - before, std::min(blockRows, end - at), at - first};
            readKind(kind, rows, arrays, targets);
            for (std::uint64_t i = 0; hasTypes && i < rows.count; ++i)
              storeNumber(targets[types], rows.target + i, kind.type);
            if (request.progress &&
                !request.progress(static_cast<double>(at - first) / static_cast<double>(count)))
              throw FileError(
                FileError::Kind::Aborted, m_files.front()->path(), "reading was aborted");
          }
          before += kind.particles;
        }
        return RowsResult();
      },
      output);
    if (hasTypes)
    {
      std::map<int, std::string> names;
      for (const HDF5Kind& kind : step.kinds)
        names[kind.type] = kind.name;
      addTypeNames(names, output);
    }
    if (step.box)
      addBox(*step.box, {0, 0, 0}, "pp pp pp", output);
  }

private:
  /// Rows of a kind, and where they go.
  struct Rows
  {
    std::uint64_t first = 0, count = 0, target = 0;
  };

  /// The first file of a snapshot, snap_007.0.hdf5, stands for all.
  void addOtherFiles(const std::string& path)
  {
    const std::size_t mark = path.rfind(".0.");
    if (mark == path.npos || path.find('/', mark) != path.npos || m_steps.steps.size() != 1)
      return;
    HDF5Step& step = m_steps.steps.front();
    for (std::uint64_t number = 1; number < m_steps.files; ++number)
    {
      std::string name = path;
      name.replace(mark + 1, 1, std::to_string(number));
      m_files.push_back(std::make_unique<HDF5File>(name));
      const HDF5Steps own = findHDF5Steps(*m_files.back());
      if (own.files != m_steps.files || own.steps.size() != 1)
        throw FileError(FileError::Kind::Malformed, name,
          "it does not say that it is one of " + std::to_string(m_steps.files) +
            " files of a snapshot, as the first one does");
      for (HDF5Kind kind : own.steps.front().kinds)
      {
        kind.file = number;
        step.kinds.push_back(std::move(kind));
      }
    }
    std::stable_sort(step.kinds.begin(), step.kinds.end(),
      [](const HDF5Kind& a, const HDF5Kind& b) { return a.type < b.type; });
  }

  static std::vector<Merged> merge(const HDF5Step& step)
  {
    std::vector<Merged> arrays;
    for (const HDF5Kind& kind : step.kinds)
      for (const HDF5Field& field : kind.fields)
      {
        const auto found = std::find_if(arrays.begin(), arrays.end(),
          [&](const Merged& array) { return array.name == field.name; });
        if (found == arrays.end())
          arrays.push_back({field.name, field.components(), field.isWhole});
        else
          found->isWhole = found->isWhole && field.isWhole;
      }
    for (Merged& array : arrays)
      for (const HDF5Kind& kind : step.kinds)
      {
        const HDF5Field* field = kind.field(array.name);
        array.isWhole = array.isWhole && (kind.particles == 0 || field);
      }
    return arrays;
  }

  void readKind(const HDF5Kind& kind, const Rows& rows, const std::vector<Merged>& arrays,
    const std::vector<TextColumn>& targets) const
  {
    const HDF5File& file = *m_files[kind.file];
    readField(file, kind.positions, rows, targets, 0, false);
    if (!kind.offsets.parts.empty())
      readField(file, kind.offsets, rows, targets, 0, true);
    for (const Merged& array : arrays)
    {
      const HDF5Field* field = kind.field(array.name);
      if (field && field->components() == array.components)
        readField(file, *field, rows, targets, array.first, false);
      else
        for (std::size_t c = 0; c < array.components; ++c)
          for (std::uint64_t i = 0; i < rows.count; ++i)
            storeNumber(
              targets[array.first + c], rows.target + i, std::numeric_limits<double>::quiet_NaN());
    }
  }

  static void readField(const HDF5File& file, const HDF5Field& field, const Rows& rows,
    const std::vector<TextColumn>& targets, std::size_t column, bool isAdded)
  {
    for (const HDF5Part& part : field.parts)
    {
      const bool areWhole = !isAdded && !part.constant && targets[column].type == ColumnType::Int64;
      if (areWhole)
        readPart<std::int64_t>(file, part, rows, targets, column, isAdded);
      else
        readPart<double>(file, part, rows, targets, column, isAdded);
      column += part.columns;
    }
  }

  template <class Number>
  static void readPart(const HDF5File& file, const HDF5Part& part, const Rows& rows,
    const std::vector<TextColumn>& targets, std::size_t column, bool isAdded)
  {
    std::vector<Number> values(static_cast<std::size_t>(rows.count) * part.columns,
      part.constant ? static_cast<Number>(*part.constant) : Number{});
    if (!part.constant)
      file.read(part.array, rows.first, rows.count, values.data());
    for (std::size_t c = 0; c < part.columns; ++c)
    {
      const TextColumn& target = targets[column + c];
      for (std::uint64_t i = 0; i < rows.count; ++i)
      {
        const Number read = values[i * part.columns + c];
        const auto value = part.scale == 1.0 ? read : static_cast<Number>(part.scale * read);
        if (isAdded) // to positions
          static_cast<double*>(
            target.data)[static_cast<std::ptrdiff_t>(rows.target + i) * target.stride] +=
            static_cast<double>(value);
        else
          storeNumber(target, rows.target + i, value);
      }
    }
  }

  std::vector<std::unique_ptr<HDF5File>> m_files;
  HDF5Steps m_steps;
};

} // namespace

bool looksLikeHDF5(std::string_view beginning)
{
  return beginning.starts_with(std::string_view("\x89HDF\r\n\x1a\n", 8));
}

std::unique_ptr<StepSource> openHDF5Particles(const std::string& path)
{
  return std::make_unique<HDF5Particles>(path);
}

} // namespace mote
