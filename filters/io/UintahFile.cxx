#include "UintahFile.h"

#include "FileError.h"
#include "NumberAt.h"
#include "TextFile.h"
#include "XMLCheck.h"

#include "kernels/core/MappedFile.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLUtilities.h"

#include <algorithm>
#include <bit>
#include <filesystem>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <utility>
#include <zlib.h>

namespace mote
{
namespace
{

using Element = vtkXMLDataElement;

/// Of ParticleVariable<...>.
struct ValueType
{
  const char* name;
  ColumnType column;
  std::size_t components;
  std::size_t bytes; ///< of a component
};

const ValueType* valueTypeOf(const std::string& variable)
{
  static const std::vector<ValueType> types = {{"double", ColumnType::Float64, 1, 8},
    {"float", ColumnType::Float32, 1, 4}, {"int", ColumnType::Int32, 1, 4},
    {"long64", ColumnType::Int64, 1, 8}, {"Point", ColumnType::Float64, 3, 8},
    {"Vector", ColumnType::Float64, 3, 8}, {"Matrix3", ColumnType::Float64, 9, 8}};
  for (const ValueType& type : types)
    if (variable == "ParticleVariable<" + std::string(type.name) + ">")
      return &type;
  return nullptr;
}

/// The values of a variable for the particles of a patch and a material.
struct Block
{
  const ValueType* type = nullptr;
  std::string file;
  std::uint64_t begin = 0, end = 0, particles = 0;
  std::string compression;
};

/// The particles of a patch and a material, and their values by the names of the variables.
struct Group
{
  int material = 0;
  std::uint64_t first = 0, count = 0;
  std::map<std::string, Block> blocks;
};

/// The numbers of a step's files.
struct Encoding
{
  bool swapped = false;
  std::size_t sizeBytes = 8; ///< of the length before gzip data
};

struct Step
{
  Encoding encoding;
  std::vector<Group> groups;
  std::map<std::string, const ValueType*> variables;
  std::uint64_t particles = 0;
};

std::string attributeOf(Element* element, const char* name)
{
  const char* value = element->GetAttribute(name);
  return value ? value : "";
}

/// The text of an element, without blanks at its ends.
std::string textOf(Element* element)
{
  const char* data = element ? element->GetCharacterData() : nullptr;
  const std::string text = data ? data : "";
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == text.npos ? std::string()
                            : text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::string textIn(Element* element, const char* name)
{
  return textOf(element->FindNestedElementWithName(name));
}

class Uintah final : public StepSource
{
public:
  explicit Uintah(const std::string& path)
    : m_path(path)
    , m_folder(std::filesystem::path(path).parent_path())
  {
    const auto root = parsed(path);
    if (textIn(root, "outputFormat") == "PIDX")
      throw FileError(FileError::Kind::OtherFormat, path,
        "this archive was written with PIDX, which is not read here");
    if (const std::string name = textIn(root, "ParticlePosition"); !name.empty())
      m_position = name;
    m_encoding = encodingOf(root, {});
    Element* steps = root->FindNestedElementWithName("timesteps");
    for (int i = 0; steps && i < steps->GetNumberOfNestedElements(); ++i)
      addStep(steps->GetNestedElement(i));
    if (m_steps.empty())
      throw FileError(FileError::Kind::Malformed, path, "it lists no time steps");
  }

  std::vector<double> times() const override
  {
    std::vector<double> times;
    for (const auto& [time, href] : m_steps)
      times.push_back(time);
    return times;
  }

  void read(const SourceRequest& request, vtkPolyData* output) override
  {
    const Step step =
      stepOf(std::next(m_steps.begin(), static_cast<std::ptrdiff_t>(request.step))->second);
    RowLayout layout(step.particles);
    layout.addPositions();
    const std::size_t material = layout.add("material", ColumnType::Int32);
    std::map<std::string, std::size_t> columns = {{m_position, 0}};
    for (const auto& [name, type] : step.variables)
      if (name != m_position)
        columns[name] =
          layout.add(name == "material" ? "material_" : name, type->column, type->components);
    makePointRows(
      layout.rowsFor(request),
      [&](std::uint64_t first, std::uint64_t count, const std::vector<TextColumn>& targets,
        const RowsStored&)
      {
        tbb::parallel_for(std::size_t{0}, step.groups.size(),
          [&](std::size_t i)
          {
            const Group& group = step.groups[i];
            const std::uint64_t begin = std::max(first, group.first);
            const std::uint64_t end = std::min(first + count, group.first + group.count);
            if (begin >= end)
              return;
            for (std::uint64_t row = begin; row < end; ++row)
              storeNumber(targets[material], row - first, group.material);
            Files files;
            for (const auto& [name, type] : step.variables)
              store(step, group, name, {begin, end, first}, files, &targets[columns.at(name)]);
          });
        return RowsResult();
      },
      output);
  }

private:
  /// Rows that are stored, of all of the step, and the one that `targets` begin with.
  struct Rows
  {
    std::uint64_t begin, end, origin;
  };
  /// Those that are open: mostly all values of a group are in one.
  using Files = std::map<std::string, std::unique_ptr<const MappedFile>>;

  [[noreturn]] static void fail(
    FileError::Kind kind, const std::string& file, const std::string& sentence)
  {
    throw FileError(kind, file, sentence);
  }

  static vtkSmartPointer<Element> parsed(const std::string& file)
  {
    checkXMLDepth(file);
    auto root = vtkSmartPointer<Element>::Take(vtkXMLUtilities::ReadElementFromFile(file.c_str()));
    if (!root)
      fail(
        FileError::Kind::Truncated, file, "this is no whole XML file: it is truncated or damaged");
    return root;
  }

  template <class Number>
  static Number numberIn(const std::string& file, const std::string& text, const char* what)
  {
    Number number{};
    std::istringstream stream(text);
    stream.imbue(std::locale::classic());
    if (!(stream >> number))
      fail(FileError::Kind::Malformed, file,
        std::string("its ") + what + " '" + text + "' is no number");
    return number;
  }

  static Encoding encodingOf(Element* root, Encoding encoding)
  {
    Element* meta = root->FindNestedElementWithName("Meta");
    if (!meta)
      return encoding;
    if (const std::string order = textIn(meta, "endianness"); !order.empty())
      encoding.swapped = (order == "big_endian") == (std::endian::native == std::endian::little);
    if (const std::string bits = textIn(meta, "nBits"); !bits.empty())
      encoding.sizeBytes = bits == "32" ? 4 : 8;
    return encoding;
  }

  void addStep(Element* element)
  {
    const std::string href = attributeOf(element, "href");
    if (href.empty())
      return;
    m_steps[numberIn<double>(m_path, attributeOf(element, "time"), "time")] = href;
  }

  Step stepOf(const std::string& href) const
  {
    const std::filesystem::path file = m_folder / href;
    const auto root = parsed(file.string());
    Step step;
    step.encoding = encodingOf(root, m_encoding);
    const std::filesystem::path folder = file.parent_path(), list = folder / "data.xml";
    std::error_code none;
    const bool isApart = std::filesystem::exists(list, none);
    const auto other = isApart ? parsed(list.string()) : root;
    Element* data = other->GetName() == std::string("Data")
                      ? other.Get()
                      : other->FindNestedElementWithName("Data");
    if (!data)
      fail(
        FileError::Kind::Malformed, (isApart ? list : file).string(), "it names no files of data");
    std::map<std::pair<std::string, std::pair<int, int>>, Group> groups;
    for (int i = 0; i < data->GetNumberOfNestedElements(); ++i)
      if (const std::string name = attributeOf(data->GetNestedElement(i), "href");
          !name.empty() && name != "global.xml")
        addFile(folder / name, groups);
    for (auto& [key, group] : groups)
    {
      const auto position = group.blocks.find(m_position);
      if (position == group.blocks.end() || position->second.particles == 0)
        continue;
      if (position->second.type->components != 3)
        fail(FileError::Kind::Malformed, file.string(), "its particles' positions are no points");
      group.first = step.particles;
      group.count = position->second.particles;
      step.particles += group.count;
      for (const auto& [name, block] : group.blocks)
        step.variables.try_emplace(name, block.type);
      step.groups.push_back(std::move(group));
    }
    step.variables.try_emplace(m_position, valueTypeOf("ParticleVariable<Point>"));
    return step;
  }

  /// The variables of particles that a file of XML tells of.
  void addFile(const std::filesystem::path& file,
    std::map<std::pair<std::string, std::pair<int, int>>, Group>& groups) const
  {
    const std::string name = file.string();
    const auto root = parsed(name);
    for (int i = 0; i < root->GetNumberOfNestedElements(); ++i)
    {
      Element* element = root->GetNestedElement(i);
      const ValueType* type = valueTypeOf(attributeOf(element, "type"));
      const std::string particles = textIn(element, "numParticles");
      if (!type || particles.empty())
        continue;
      Block block;
      block.type = type;
      block.file = (file.parent_path() / textIn(element, "filename")).string();
      block.begin = numberIn<std::uint64_t>(name, textIn(element, "start"), "start");
      block.end = numberIn<std::uint64_t>(name, textIn(element, "end"), "end");
      block.particles = numberIn<std::uint64_t>(name, particles, "number of particles");
      block.compression = textIn(element, "compression");
      const auto material = numberIn<int>(name, textIn(element, "index"), "index");
      const auto patch = numberIn<int>(name, textIn(element, "patch"), "patch");
      check(block, name);
      Group& group = groups[{name, {patch, material}}];
      group.material = material;
      group.blocks[textIn(element, "variable")] = block;
    }
  }

  /// That a block may hold what it says: else a damaged file could ask for any amount of memory.
  static void check(const Block& block, const std::string& name)
  {
    constexpr std::uint64_t mostDeflated = 1100; // zlib does not pack closer
    const std::uint64_t each = block.type->components * block.type->bytes;
    std::error_code error;
    const std::uint64_t size = std::filesystem::file_size(block.file, error);
    if (error)
      fail(
        FileError::Kind::NotFound, name, "there is no file '" + block.file + "', which it names");
    const bool isPlain = block.compression.empty() || block.compression == "none";
    if (!isPlain && block.compression != "gzip")
      fail(FileError::Kind::OtherFormat, name,
        "its particles are compressed as '" + block.compression + "', which is not read here");
    if (block.begin > block.end || block.end > size)
      fail(FileError::Kind::Truncated, block.file,
        "the file ends before what " + name + " says is in it: it is truncated");
    const std::uint64_t length = block.end - block.begin;
    const std::uint64_t most = isPlain ? length : length * mostDeflated;
    if (block.particles > most / each || (isPlain && block.particles * each != length))
      fail(FileError::Kind::Malformed, name,
        "it says that " + std::to_string(length) + " bytes hold " +
          std::to_string(block.particles) + " values of " + std::to_string(each) + " bytes each");
  }

  static std::string inflated(
    const Block& block, const unsigned char* bytes, std::size_t count, const Encoding& encoding)
  {
    const std::size_t wanted =
      static_cast<std::size_t>(block.particles) * block.type->components * block.type->bytes;
    std::string values(wanted, '\0');
    uLongf length = wanted;
    const std::size_t head = encoding.sizeBytes;
    if (count < head ||
        uncompress(reinterpret_cast<Bytef*>(values.data()), &length, bytes + head, count - head) !=
          Z_OK ||
        length != wanted)
      fail(FileError::Kind::Malformed, block.file, "its gzip data are damaged");
    return values;
  }

  void store(const Step& step, const Group& group, const std::string& name, const Rows& rows,
    Files& files, const TextColumn* targets) const
  {
    const std::size_t components = step.variables.at(name)->components;
    const auto found = group.blocks.find(name);
    const bool isThere = found != group.blocks.end() &&
                         found->second.type == step.variables.at(name) &&
                         found->second.particles == group.count;
    if (!isThere)
    {
      for (std::uint64_t row = rows.begin; row < rows.end; ++row)
        for (std::size_t c = 0; c < components; ++c)
          storeNumber(targets[c], row - rows.origin, std::numeric_limits<double>::quiet_NaN());
      return;
    }
    const Block& block = found->second;
    std::unique_ptr<const MappedFile>& open = files[block.file];
    if (!open)
      open = std::make_unique<const MappedFile>(block.file);
    const MappedFile& file = *open;
    if (file.size() < block.end)
      fail(FileError::Kind::Truncated, block.file, "the file has become shorter");
    const unsigned char* const bytes = file.data() + block.begin;
    const std::size_t count = block.end - block.begin;
    const bool isGzip = block.compression == "gzip";
    const std::string values =
      isGzip ? inflated(block, bytes, count, step.encoding) : std::string();
    const char* const from = isGzip ? values.data() : reinterpret_cast<const char*>(bytes);
    for (std::uint64_t row = rows.begin; row < rows.end; ++row)
      for (std::size_t c = 0; c < components; ++c)
        storeValue(targets[c], row - rows.origin, *block.type,
          from + ((row - group.first) * components + c) * block.type->bytes, step.encoding.swapped);
  }

  static void storeValue(const TextColumn& target, std::uint64_t row, const ValueType& type,
    const char* at, bool swapped)
  {
    switch (type.column)
    {
    case ColumnType::Int32:
      return storeNumber(target, row, numberAt<std::int32_t>(at, swapped));
    case ColumnType::Int64:
      return storeNumber(target, row, numberAt<std::int64_t>(at, swapped));
    case ColumnType::Float32:
      return storeNumber(target, row, numberAt<float>(at, swapped));
    default:
      return storeNumber(target, row, numberAt<double>(at, swapped));
    }
  }

  std::string m_path;
  std::filesystem::path m_folder;
  std::string m_position = "p.x";
  Encoding m_encoding;
  std::map<double, std::string> m_steps; ///< times and files, from the folder
};

} // namespace

bool looksLikeUintah(std::string_view beginning)
{
  return beginning.find("<Uintah_DataArchive") != beginning.npos;
}

std::unique_ptr<StepSource> openUintah(const std::string& path)
{
  return std::make_unique<Uintah>(path);
}

} // namespace mote
