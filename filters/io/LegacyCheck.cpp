#include "LegacyCheck.h"

#include "FileError.h"
#include "LegacyText.h"
#include "MostArrays.h"
#include "TextFile.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <map>
#include <set>
#include <string_view>
#include <vector>

namespace mote
{
namespace
{

bool isBlank(char c)
{
  return c == ' ' || (c >= '\t' && c <= '\r');
}

/// Takes the numbers of a cell in turn, and tells whether they are a polyhedron: how many faces,
/// and for each how many points, and which.
class FacesOfCell
{
public:
  explicit FacesOfCell(std::uint64_t points)
    : m_points(points)
  {
  }
  void take(std::uint64_t number)
  {
    if (!m_isBegun)
      m_faces = number, m_isBegun = true;
    else if (m_left > 0)
      --m_left, m_isWrong = m_isWrong || number >= m_points;
    else if (m_faces > 0)
      --m_faces, m_left = number;
    else
      m_isWrong = true;
  }
  bool isPolyhedron() const { return m_isBegun && m_faces == 0 && m_left == 0 && !m_isWrong; }

private:
  std::uint64_t m_points, m_faces = 0, m_left = 0;
  bool m_isBegun = false, m_isWrong = false;
};

/// Goes through a file as VTK's readers do.
class LegacyChecker : LegacyText
{
public:
  LegacyChecker(const std::string& path, std::string_view text)
    : LegacyText(path, text)
  {
  }

  void check() { checkSet(0); }

private:
  /// Three lines, of which the third says whether values are text or bytes.
  void checkHead()
  {
    const std::string_view first = nextLine();
    constexpr std::string_view begin = "# vtk DataFile Version ";
    if (!first.starts_with(begin))
      throw FileError(FileError::Kind::OtherFormat, m_path, "is no VTK legacy file");
    // As VTK reads it: what is no version is taken for an old one.
    int major = 0, minor = 0;
    const std::string version(first.substr(begin.size()));
    const bool isTold = std::sscanf(version.c_str(), "%d.%d", &major, &minor) == 2;
    m_hasOffsets = isTold && major >= 5;
    if (nextLine().size() > 255)
      fail("its title is longer than 255 bytes");
    const std::string_view format = requireWord("ASCII or BINARY");
    m_isText = lowerCase(format) == "ascii";
    if (!m_isText && lowerCase(format) != "binary")
      fail("expected ASCII or BINARY, found " + quoted(format));
    nextLine();
  }

  /// A whole file, or one of the files that a file of blocks holds.
  void checkSet(int depth)
  {
    checkHead();
    std::string keyword = lowerCase(nextWord());
    while (keyword == "field" || keyword == "metadata")
    {
      checkKeyword(keyword);
      keyword = lowerCase(nextWord());
    }
    if (keyword.empty() || (depth > 0 && keyword == "endchild"))
      return; // fields alone
    if (keyword != "dataset")
      fail("expected DATASET, found " + quoted(keyword));
    static const std::set<std::string> known = {"polydata", "structured_points", "structured_grid",
      "rectilinear_grid", "unstructured_grid", "multiblock"};
    const std::string kind = lowerCase(requireWord("the kind of the data set"));
    if (!known.contains(kind))
      throw FileError(FileError::Kind::OtherFormat, m_path,
        quoted(kind) + " is no kind of data set that is read from VTK legacy files");
    while (!(keyword = lowerCase(nextWord())).empty() && !(depth > 0 && keyword == "endchild"))
    {
      if (kind == "multiblock" && keyword == "children")
        checkChildren();
      else if (kind == "multiblock" && keyword == "child")
        checkChild(depth);
      else
        checkKeyword(keyword);
    }
  }

  void checkChildren()
  {
    const Size count = requireCount("the number of blocks");
    if (count > m_text.size())
      fail("the file has no room for " + std::to_string(count) + " blocks");
  }

  void checkChild(int depth)
  {
    constexpr int deepest = 100;
    if (depth == deepest)
      fail("its blocks are more than " + std::to_string(deepest) + " levels deep");
    nextLine(); // the block's type and name
    const bool isText = m_isText;
    checkSet(depth + 1);
    m_isText = isText;
  }

  void checkKeyword(const std::string& keyword)
  {
    if (checkStructure(keyword) || checkAttribute(keyword))
      return;
    if (keyword == "metadata")
      passMetadata();
    else
      fail("the word " + quoted(keyword) + " is no keyword of VTK legacy files here");
  }

  /// Information about arrays, up to an empty line.
  void passMetadata()
  {
    nextLine();
    std::string_view line;
    do
      line = nextLine();
    while (!std::all_of(line.begin(), line.end(), isBlank));
  }

  bool checkStructure(const std::string& keyword)
  {
    static const std::map<std::string, std::size_t> numbers = {
      {"origin", 3}, {"spacing", 3}, {"aspect_ratio", 3}};
    static const std::set<std::string> lists = {
      "vertices", "lines", "polygons", "triangle_strips", "cells"};
    static const std::set<std::string> coordinates = {
      "x_coordinates", "y_coordinates", "z_coordinates"};
    if (keyword == "dimensions")
      checkDimensions();
    else if (keyword == "points")
    {
      m_points = requireCount("the number of points");
      checkValues(3 * m_points, requireType());
    }
    else if (coordinates.contains(keyword))
    {
      const Size count = requireCount("the number of coordinates");
      checkValues(count, requireType());
    }
    else if (lists.contains(keyword))
      checkCells();
    else if (keyword == "cell_types")
      checkTypes();
    else if (const auto found = numbers.find(keyword); found != numbers.end())
      checkNumbers(found->second, false);
    else
      return false;
    return true;
  }

  void checkDimensions()
  {
    Size points = 1;
    for (int axis = 0; axis < 3; ++axis)
      points = std::min(mostValues, points * std::max<Size>(requireCount("three dimensions"), 1));
    // Any values of them take a bit at least.
    if (points > std::max<Size>(1'000'000, 8 * m_text.size()))
      fail("the file has no room for values at " + std::to_string(points) + " points");
  }

  /// A list of cells: their numbers of points with these points, or offsets and points apart.
  void checkCells()
  {
    const Size cells = requireCount("the number of cells");
    const Size values = requireCount("the size of the list of cells");
    m_offsets.clear();
    if (m_hasOffsets)
      return checkCellsApart(cells, values);
    m_cellsAt = m_at;
    checkValues(values, {32, true});
    const std::size_t end = m_at;
    m_at = m_cellsAt;
    passLineEnd();
    Size left = values;
    for (Size cell = 0; cell < cells; ++cell)
    {
      const Size points = left > 0 ? nextInteger() : 0;
      if (left == 0 || points > left - 1)
        fail("the cells do not fill the list of " + std::to_string(values) + " numbers");
      left -= points + 1;
      for (Size i = 0; i < points; ++i)
        nextInteger();
    }
    if (left > 0)
      fail("the list of cells has " + std::to_string(left) + " numbers too many");
    m_at = end;
    m_cells = cells;
  }

  /// One offset more than there are cells, from 0 to the number of values.
  void checkCellsApart(Size count, Size values)
  {
    if (!passWord("offsets"))
      fail("expected OFFSETS");
    const ValueType ofOffsets = requireType();
    const std::size_t offsetsAt = m_at;
    checkValues(count, ofOffsets);
    if (!passWord("connectivity"))
      fail("expected CONNECTIVITY");
    const ValueType ofPoints = requireType();
    m_cellsAt = m_at;
    m_cellBits = ofPoints.bits;
    checkValues(values, ofPoints);
    const std::size_t end = m_at;
    for (const ValueType& type : {ofOffsets, ofPoints})
      if (!type.isWhole || (type.bits != 32 && type.bits != 64))
        fail("cells are of whole numbers of 32 or 64 bits");
    m_offsets.resize(count);
    m_at = offsetsAt;
    passLineEnd();
    for (Size& offset : m_offsets)
      offset = nextInteger(ofOffsets.bits);
    if (count > 0 && (m_offsets.front() != 0 || m_offsets.back() != values ||
                       !std::is_sorted(m_offsets.begin(), m_offsets.end())))
      fail("the offsets of cells do not ascend from 0 to " + std::to_string(values));
    m_at = end;
    m_cells = count > 0 ? count - 1 : 0;
  }

  /// Types of cells. Where there are polyhedra, VTK tells their faces apart before anything else is
  /// looked at.
  void checkTypes()
  {
    constexpr Size polyhedron = 42;
    const Size count = requireCount("the number of cells");
    const std::size_t begin = m_at;
    checkValues(count, {32, true});
    const std::size_t end = m_at;
    m_at = begin;
    passLineEnd();
    std::vector<Size> polyhedra;
    for (Size cell = 0; cell < count; ++cell)
      if (nextInteger() == polyhedron)
        polyhedra.push_back(cell);
    if (!polyhedra.empty())
      checkFaces(polyhedra);
    m_at = end;
  }

  /// Goes through the list of cells again.
  void checkFaces(const std::vector<Size>& polyhedra)
  {
    m_at = m_cellsAt;
    passLineEnd();
    auto next = polyhedra.begin();
    for (Size cell = 0; cell < m_cells && next != polyhedra.end(); ++cell)
    {
      const Size points = m_hasOffsets ? m_offsets[cell + 1] - m_offsets[cell] : nextInteger();
      FacesOfCell faces(m_points);
      for (Size i = 0; i < points; ++i)
        faces.take(nextInteger(m_hasOffsets ? m_cellBits : 32));
      if (cell != *next)
        continue;
      if (!faces.isPolyhedron())
        break;
      ++next;
    }
    if (next != polyhedra.end())
      fail("the faces of the polyhedron in cell " + std::to_string(*next) + " do not fit its list");
  }

  bool checkAttribute(const std::string& keyword)
  {
    static const std::map<std::string, Size> components = {{"vectors", 3}, {"normals", 3},
      {"tensors", 9}, {"tensors6", 6}, {"global_ids", 1}, {"pedigree_ids", 1}, {"edge_flags", 1}};
    if (keyword == "point_data" || keyword == "cell_data")
      m_arrays = 0, m_tuples = requireCount("the number of values");
    else if (keyword == "scalars")
      checkScalars();
    else if (keyword == "color_scalars")
      checkColors(m_tuples);
    else if (keyword == "lookup_table")
      checkColors(4);
    else if (keyword == "texture_coordinates")
    {
      requireWord("a name");
      const Size each = requireCount("the number of texture coordinates");
      checkValues(m_tuples * std::min<Size>(each, 4), requireType());
    }
    else if (keyword == "field")
      checkField();
    else if (const auto found = components.find(keyword); found != components.end())
    {
      requireWord("a name");
      checkValues(m_tuples * found->second, requireType());
    }
    else
      return false;
    if (++m_arrays > mostArrays)
      fail(tooMany("arrays"));
    return true;
  }

  void checkScalars()
  {
    requireWord("a name");
    const ValueType type = requireType();
    Size each = 1;
    if (!passWord("lookup_table"))
    {
      each = requireCount("the number of components");
      if (!passWord("lookup_table"))
        fail("expected LOOKUP_TABLE");
    }
    requireWord("the name of a table of colours");
    if (each < 1 || each > 100'000)
      fail("there are no scalars of " + std::to_string(each) + " components");
    checkValues(m_tuples * each, type);
  }

  /// Colours: numbers from 0 to 1 in text, a byte each otherwise.
  void checkColors(Size colors)
  {
    requireWord("a name");
    const Size each = requireCount("the number of colours or components");
    if (each > 100'000)
      fail("there are no " + std::to_string(each) + " colours or components");
    checkValues(colors * each, {8, false});
  }

  void checkField()
  {
    requireWord("a name");
    const Size arrays = requireCount("the number of arrays");
    m_arrays += std::min<Size>(arrays, mostArrays);
    for (Size array = 0; array < arrays; ++array)
    {
      if (passWord("metadata"))
        passMetadata();
      if (requireWord("the name of an array") == "NULL_ARRAY")
        continue;
      const Size each = requireCount("the number of components");
      const Size tuples = requireCount("the number of values");
      if (each > 100'000)
        fail("there is no array of " + std::to_string(each) + " components");
      checkValues(each * tuples, requireType());
    }
  }

  Size m_points = 0;    ///< that there are
  Size m_cells = 0;     ///< of the last list
  Size m_cellBits = 32; ///< of its points, where they are apart
  std::size_t m_cellsAt = 0;
  std::vector<Size> m_offsets;
  bool m_hasOffsets = false;       ///< of the lists of cells
  Size m_tuples = 0, m_arrays = 0; ///< of the attributes that follow
};

} // namespace

void checkLegacyVTK(const std::string& path)
{
  const TextFile file(path);
  if (!file.isGzip())
    LegacyChecker(path, file.text()).check();
}

} // namespace mote
