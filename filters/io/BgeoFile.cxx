#include "BgeoFile.h"

#include "FileError.h"
#include "NumberAt.h"
#include "WholeFile.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <bit>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace mote
{
namespace
{

constexpr std::string_view magic = "Bgeo", newMagic = "\x7fNSJ";
constexpr bool isSwapped = std::endian::native == std::endian::little; // files are big-endian
constexpr std::size_t wordBytes = 4;

/// Houdini's numbers of the types.
enum AttributeType : std::int32_t
{
  Float = 0,
  Int = 1,
  Text = 4, ///< the number of a word in a list
  Vector = 5
};

struct Attribute
{
  std::string name;
  std::int32_t type = Float;
  std::size_t components = 0;
  std::size_t place = 0; ///< of its first word in a point
  std::vector<std::string> words;
  std::size_t column = 0; ///< where it goes
};

class Bgeo final : public StepSource
{
public:
  explicit Bgeo(const std::string& path)
    : m_file(path)
    , m_bytes(m_file.bytes())
  {
    if (m_bytes.starts_with(newMagic))
      throw FileError(FileError::Kind::OtherFormat, path,
        "this is the .bgeo of Houdini 12 and later, which is not read here: "
        "have it written as .bhclassic");
    if (!m_bytes.starts_with(magic))
      throw FileError(FileError::Kind::OtherFormat, path, "this is no .bgeo file");
    readHeader();
  }

  std::vector<double> times() const override { return {0.0}; }

  std::string warning() const override
  {
    return m_primitives <= 1 ? std::string()
                             : m_file.path() + ": of this file the points are read, and none of " +
                                 "the " + std::to_string(m_primitives) + " primitives";
  }

  void read(const SourceRequest& request, vtkPolyData* output) override
  {
    RowLayout layout(m_points);
    layout.addPositions();
    std::vector<Attribute> attributes = m_attributes;
    for (Attribute& attribute : attributes)
    {
      attribute.column = layout.add(attribute.name,
        attribute.type == Int                                 ? ColumnType::Int32
        : attribute.type == Text && attribute.components == 1 ? ColumnType::String
        : attribute.type == Text                              ? ColumnType::Int32
                                                              : ColumnType::Float32,
        attribute.components);
    }
    makePointRows(
      layout.rowsFor(request),
      [&](std::uint64_t first, std::uint64_t count, const std::vector<TextColumn>& targets,
        const RowsStored&)
      {
        tbb::parallel_for(tbb::blocked_range<std::uint64_t>(0, count, 4096),
          [&](const tbb::blocked_range<std::uint64_t>& range)
          {
            for (std::uint64_t row = range.begin(); row != range.end(); ++row)
              store(first + row, row, attributes, targets);
          });
        return RowsResult();
      },
      output);
  }

private:
  [[noreturn]] void fail(FileError::Kind kind, const std::string& sentence) const
  {
    throw FileError(kind, m_file.path(), sentence);
  }

  /// The next bytes of the file.
  const char* take(std::size_t count)
  {
    if (m_bytes.size() - m_at < count)
      fail(FileError::Kind::Truncated, "the file ends too early: it is truncated");
    m_at += count;
    return m_bytes.data() + m_at - count;
  }

  template <class Number>
  Number takeNumber()
  {
    return numberAt<Number>(take(sizeof(Number)), isSwapped);
  }

  std::string takeText()
  {
    const auto length = takeNumber<std::uint16_t>();
    return {take(length), length};
  }

  std::uint64_t takeCount()
  {
    const auto count = takeNumber<std::int32_t>();
    if (count < 0)
      fail(FileError::Kind::Malformed, "a number of its header is negative");
    return static_cast<std::uint64_t>(count);
  }

  void readHeader()
  {
    m_at = magic.size();
    take(1); // 'V'
    const auto version = takeNumber<std::int32_t>();
    if (version != 5)
      fail(FileError::Kind::OtherFormat,
        "this is a .bgeo of version " + std::to_string(version) + ", and only 5 is read");
    m_points = takeCount();
    m_primitives = takeCount();
    takeCount(); // groups of points
    takeCount(); // groups of primitives
    const std::uint64_t attributes = takeCount();
    for (int other = 0; other < 3; ++other)
      takeCount();    // attributes of vertices, of primitives and of the whole
    m_pointWords = 4; // the place and its weight
    for (std::uint64_t i = 0; i < attributes; ++i)
      readAttribute();
    if (m_pointWords > m_bytes.size() / wordBytes)
      fail(
        FileError::Kind::Malformed, "its attributes have more values than the file has room for");
    if (m_points > (m_bytes.size() - m_at) / (wordBytes * m_pointWords))
      fail(FileError::Kind::Truncated, "the file ends within its points: it is truncated");
  }

  void readAttribute()
  {
    Attribute attribute;
    attribute.name = takeText();
    attribute.components = takeNumber<std::uint16_t>();
    attribute.type = takeNumber<std::int32_t>();
    attribute.place = m_pointWords;
    m_pointWords += attribute.components;
    switch (attribute.type)
    {
    case Float:
    case Int:
    case Vector:
      take(wordBytes * attribute.components); // what points have unless they say otherwise
      break;
    case Text:
      for (std::uint64_t word = 0, count = takeCount(); word < count; ++word)
        attribute.words.push_back(takeText());
      break;
    default:
      fail(FileError::Kind::Malformed,
        "its attribute '" + attribute.name +
          "' is of a type that is not known: " + std::to_string(attribute.type));
    }
    if (attribute.components > 0)
      m_attributes.push_back(std::move(attribute));
  }

  void store(std::uint64_t point, std::uint64_t row, const std::vector<Attribute>& attributes,
    const std::vector<TextColumn>& targets) const
  {
    const char* const words = m_bytes.data() + m_at + point * m_pointWords * wordBytes;
    for (std::size_t axis = 0; axis < 3; ++axis)
      storeNumber(targets[axis], row, numberAt<float>(words + wordBytes * axis, isSwapped));
    for (const Attribute& attribute : attributes)
      for (std::size_t c = 0; c < attribute.components; ++c)
      {
        const char* const word = words + wordBytes * (attribute.place + c);
        const TextColumn& target = targets[attribute.column + c];
        const auto whole = numberAt<std::int32_t>(word, isSwapped);
        if (target.type == ColumnType::String)
          storeText(target, row,
            whole >= 0 && static_cast<std::size_t>(whole) < attribute.words.size()
              ? std::string_view(attribute.words[static_cast<std::size_t>(whole)])
              : std::string_view());
        else if (attribute.type == Int || attribute.type == Text)
          storeNumber(target, row, whole);
        else
          storeNumber(target, row, numberAt<float>(word, isSwapped));
      }
  }

  WholeFile m_file;
  std::string_view m_bytes;
  std::size_t m_at = 0; ///< in the end where the first point is
  std::uint64_t m_points = 0, m_primitives = 0;
  std::size_t m_pointWords = 0;
  std::vector<Attribute> m_attributes;
};

} // namespace

bool looksLikeBgeo(std::string_view beginning)
{
  return beginning.starts_with("BgeoV") || beginning.starts_with(newMagic);
}

std::unique_ptr<StepSource> openBgeo(const std::string& path)
{
  return std::make_unique<Bgeo>(path);
}

} // namespace mote
