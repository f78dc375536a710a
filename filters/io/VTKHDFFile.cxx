#include "VTKHDFFile.h"

#include "FileError.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <numeric>

namespace mote
{
namespace
{

const std::string root = "/VTKHDF/";
constexpr std::array<const char*, 4> topologies = {"Vertices", "Lines", "Polygons", "Strips"};

int vtkTypeOf(const HDF5Array& array)
{
  if (!array.isWhole)
    return array.bytes <= 4 ? VTK_FLOAT : VTK_DOUBLE;
  if (array.bytes <= 1)
    return array.isSigned ? VTK_SIGNED_CHAR : VTK_UNSIGNED_CHAR;
  if (array.bytes <= 2)
    return array.isSigned ? VTK_SHORT : VTK_UNSIGNED_SHORT;
  if (array.bytes <= 4)
    return array.isSigned ? VTK_INT : VTK_UNSIGNED_INT;
  return array.isSigned ? VTK_LONG_LONG : VTK_UNSIGNED_LONG_LONG;
}

std::uint64_t sumOf(const std::vector<std::uint64_t>& counts, std::size_t before)
{
  return std::accumulate(
    counts.begin(), counts.begin() + static_cast<std::ptrdiff_t>(before), std::uint64_t{0});
}

std::uint64_t componentsOf(const HDF5Array& array, std::size_t firstDimension)
{
  std::uint64_t components = 1;
  for (std::size_t i = firstDimension; i < array.dimensions.size(); ++i)
    components *= array.dimensions[i];
  return components;
}

/// Throws where the user wants no more.
void tell(const Progress& progress, double share, const std::string& path)
{
  if (progress && !progress(share))
    throw FileError(FileError::Kind::Aborted, path, "reading was aborted");
}

} // namespace

/// Cells of a kind, of the chosen parts one after the other.
struct VTKHDFFile::Topology
{
  vtkNew<vtkTypeInt64Array> offsets, corners;
  std::vector<std::uint64_t> cells; ///< of each part of the step, chosen or not
};

bool isVTKHDF(const std::string& path)
{
  try
  {
    return HDF5File(path).isGroup("/VTKHDF");
  }
  catch (const FileError&)
  {
    return false;
  }
}

VTKHDFFile::VTKHDFFile(const std::string& path)
  : m_file(path)
{
  if (!m_file.isGroup("/VTKHDF"))
    throw FileError(FileError::Kind::OtherFormat, path, "there is no group VTKHDF in it");
  const std::string type = m_file.text("/VTKHDF", "Type");
  m_type = type == "UnstructuredGrid" ? VTK_UNSTRUCTURED_GRID
           : type == "PolyData"       ? VTK_POLY_DATA
           : type == "ImageData"      ? VTK_IMAGE_DATA
                                      : -1;
  if (m_type < 0)
    throw FileError(FileError::Kind::OtherFormat, path,
      "VTKHDF files of the types UnstructuredGrid, PolyData and ImageData are read, and not '" +
        type.substr(0, 40) + "'");
  if (const auto values = m_file.array(root + "Steps/Values"))
  {
    if (values->dimensions.size() != 1 || values->rows() == 0 || values->rows() > 10'000'000)
      this->fail("the times of its steps are no list");
    m_times.resize(static_cast<std::size_t>(values->rows()));
    m_file.read(root + "Steps/Values", 0, values->rows(), m_times.data());
  }
}

void VTKHDFFile::fail(const std::string& sentence) const
{
  throw FileError(FileError::Kind::Malformed, m_file.path(), sentence);
}

std::uint64_t VTKHDFFile::offsetAt(
  const std::string& table, const Step& step, std::size_t column) const
{
  const std::string name = root + "Steps/" + table;
  const std::optional<HDF5Array> known = m_file.array(name);
  if (!known)
    return 0;
  const std::uint64_t columns = known->columns();
  if (columns <= column && columns > 0)
    return 0; // topologies that are not told
  std::vector<std::int64_t> values(static_cast<std::size_t>(columns));
  if (columns == 0 || columns > 16 || step.number >= known->rows())
    this->fail("'" + table + "' has no number for each step");
  m_file.read(name, step.number, 1, values.data());
  if (values[column] < 0)
    this->fail("'" + table + "' has numbers below zero");
  return static_cast<std::uint64_t>(values[column]);
}

VTKHDFFile::Step VTKHDFFile::stepAt(std::size_t number) const
{
  Step step;
  step.number = number;
  const std::optional<HDF5Array> points = m_file.array(root + "NumberOfPoints");
  const std::uint64_t all = points ? points->rows() : 0;
  step.parts = all;
  if (m_times.empty())
    return step;
  step.firstPart = this->offsetAt("PartOffsets", step);
  step.parts =
    m_file.array(root + "Steps/NumberOfParts") ? this->offsetAt("NumberOfParts", step) : 1;
  step.points = this->offsetAt("PointOffsets", step);
  for (std::size_t k = 0; k < topologies.size(); ++k)
  {
    step.cells[k] = this->offsetAt("CellOffsets", step, k);
    step.corners[k] = this->offsetAt("ConnectivityIdOffsets", step, k);
  }
  if (m_type != VTK_IMAGE_DATA && (step.firstPart > all || step.parts > all - step.firstPart))
    this->fail("a step has parts that are not there");
  return step;
}

/// How many of something each part of a step has.
std::vector<std::uint64_t> VTKHDFFile::counts(const std::string& name, const Step& step) const
{
  std::vector<std::int64_t> read(static_cast<std::size_t>(step.parts));
  m_file.read(root + name, step.firstPart, step.parts, read.data());
  if (std::any_of(read.begin(), read.end(), [](std::int64_t one) { return one < 0; }))
    this->fail("'" + name + "' has numbers below zero");
  return {read.begin(), read.end()};
}

std::vector<std::size_t> VTKHDFFile::partsOf(const Step& step, const Piece& piece) const
{
  std::vector<std::size_t> parts;
  for (std::size_t part = 0; part < step.parts; ++part)
    if (piece.isAll() ||
        static_cast<int>(part % static_cast<std::size_t>(piece.count)) == piece.number)
      parts.push_back(part);
  return parts;
}

/// Rows of an array one after the other, in its own type.
vtkSmartPointer<vtkDataArray> VTKHDFFile::rows(
  const std::string& name, const std::vector<Rows>& all) const
{
  const std::optional<HDF5Array> known = m_file.array(name);
  if (!known || !known->isNumber || known->dimensions.empty())
    this->fail("'" + name + "' is no array of numbers");
  const std::uint64_t components = componentsOf(*known, 1);
  if (components == 0 || components > 100'000)
    this->fail("'" + name + "' has " + std::to_string(components) + " components");
  std::uint64_t count = 0;
  for (const Rows& one : all)
  {
    if (one.first > known->rows() || one.count > known->rows() - one.first)
      this->fail("'" + name + "' has " + std::to_string(known->rows()) + " rows, which is too few");
    count += one.count;
  }
  vtkSmartPointer<vtkDataArray> array;
  array.TakeReference(vtkDataArray::CreateDataArray(vtkTypeOf(*known)));
  array->SetNumberOfComponents(static_cast<int>(components));
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  auto* to = static_cast<char*>(array->GetVoidPointer(0));
  for (const Rows& one : all)
  {
    m_file.readAsStored(name, one.first, one.count, to);
    to += one.count * components * static_cast<std::uint64_t>(array->GetDataTypeSize());
  }
  array->SetName(name.substr(name.rfind('/') + 1).c_str());
  return array;
}

/// The arrays of a group, of which an offset for a step may stand in place of `start`, from which
/// the rows were counted.
void VTKHDFFile::addArrays(const std::string& group, const Step& step, std::uint64_t start,
  const std::vector<Rows>& rows, vtkDataSetAttributes* to, const Progress& progress) const
{
  const std::vector<std::string> names = m_file.namesIn(root + group);
  for (const std::string& name : names)
  {
    const std::optional<HDF5Array> known = m_file.array(root + group + '/' + name);
    if (!known || !known->isNumber)
      continue; // texts
    std::vector<Rows> own = rows;
    const std::string table = group + "Offsets/" + name;
    if (!m_times.empty() && m_file.array(root + "Steps/" + table))
    {
      const std::uint64_t offset = this->offsetAt(table, step);
      for (Rows& one : own)
        one.first = one.first - start + offset;
    }
    to->AddArray(this->rows(root + group + '/' + name, own));
    tell(progress, 0.5, m_file.path());
  }
}

VTKHDFFile::Topology VTKHDFFile::topology(const std::string& group, std::size_t number,
  const Step& step, const std::vector<std::uint64_t>& points,
  const std::vector<std::size_t>& parts) const
{
  Topology found;
  found.cells.assign(static_cast<std::size_t>(step.parts), 0);
  found.offsets->InsertNextValue(0);
  if (!group.empty() && !m_file.isGroup(root + group.substr(0, group.size() - 1)))
    return found; // newer files leave out what they have none of
  found.cells = this->counts(group + "NumberOfCells", step);
  const std::vector<std::uint64_t> corners = this->counts(group + "NumberOfConnectivityIds", step);
  std::vector<std::int64_t> read;
  std::int64_t before = 0; // points of the parts before
  for (const std::size_t part : parts)
  {
    const std::uint64_t cells = found.cells[part], begin = found.corners->GetNumberOfValues();
    const auto readAll = [&](const char* name, std::uint64_t first, std::uint64_t count)
    {
      const std::optional<HDF5Array> known = m_file.array(root + group + name);
      if (!known || known->columns() != 1 || first > known->rows() || count > known->rows() - first)
        this->fail("'" + group + name + "' has too few numbers for its parts");
      read.resize(static_cast<std::size_t>(count));
      m_file.read(root + group + name, first, count, read.data());
    };
    // Offsets have one number more in each part.
    readAll(
      "Offsets", step.cells[number] + step.firstPart + part + sumOf(found.cells, part), cells + 1);
    if (read.front() != 0 || !std::is_sorted(read.begin(), read.end()) ||
        static_cast<std::uint64_t>(read.back()) != corners[part])
      this->fail("the offsets of the cells in '" + group + "Offsets' do not fit their points");
    for (std::size_t i = 1; i < read.size(); ++i)
      found.offsets->InsertNextValue(static_cast<std::int64_t>(begin) + read[i]);
    readAll("Connectivity", step.corners[number] + sumOf(corners, part), corners[part]);
    for (const std::int64_t corner : read)
    {
      if (corner < 0 || static_cast<std::uint64_t>(corner) >= points[part])
        this->fail("a cell has a point that is not there: " + std::to_string(corner));
      found.corners->InsertNextValue(before + corner);
    }
    before += static_cast<std::int64_t>(points[part]);
  }
  return found;
}

vtkSmartPointer<vtkDataSet> VTKHDFFile::readCells(
  const Step& step, const Piece& piece, const Progress& progress) const
{
  const std::vector<std::uint64_t> points = this->counts("NumberOfPoints", step);
  const std::vector<std::size_t> parts = this->partsOf(step, piece);
  std::vector<Rows> pointRows, cellRows;
  for (const std::size_t part : parts)
    pointRows.push_back({step.points + sumOf(points, part), points[part]});
  const vtkSmartPointer<vtkDataArray> places = this->rows(root + "Points", pointRows);
  if (places->GetNumberOfComponents() != 3)
    this->fail("'Points' does not have three components");
  vtkNew<vtkPoints> vertices;
  vertices->SetData(places);
  tell(progress, 0.2, m_file.path());

  std::uint64_t start = step.cells[0]; // of the values of cells
  vtkSmartPointer<vtkPointSet> data;
  if (m_type == VTK_UNSTRUCTURED_GRID)
  {
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    const Topology all = this->topology("", 0, step, points, parts);
    for (const std::size_t part : parts)
      cellRows.push_back({start + sumOf(all.cells, part), all.cells[part]});
    const vtkSmartPointer<vtkDataArray> types = this->rows(root + "Types", cellRows);
    vtkNew<vtkUnsignedCharArray> own;
    own->DeepCopy(types);
    for (vtkIdType i = 0; i < own->GetNumberOfValues(); ++i)
      if (own->GetValue(i) == VTK_POLYHEDRON)
        this->fail("polyhedra of VTKHDF files are not read");
    vtkNew<vtkCellArray> cells;
    cells->SetData(all.offsets, all.corners);
    grid->SetCells(own, cells);
    data = grid;
  }
  else
  {
    auto polygons = vtkSmartPointer<vtkPolyData>::New();
    std::vector<std::uint64_t> before(static_cast<std::size_t>(step.parts), 0), all = before;
    std::vector<Topology> kinds;
    for (std::size_t k = 0; k < topologies.size(); ++k)
    {
      kinds.push_back(this->topology(topologies[k] + std::string("/"), k, step, points, parts));
      for (std::size_t part = 0; part < step.parts; ++part)
        all[part] += kinds[k].cells[part];
      start += k > 0 ? step.cells[k] : 0;
    }
    // In the file all cells of a part come together, here all cells of a kind.
    for (std::size_t k = 0; k < topologies.size(); ++k)
    {
      for (const std::size_t part : parts)
      {
        cellRows.push_back({start + sumOf(all, part) + before[part], kinds[k].cells[part]});
        before[part] += kinds[k].cells[part];
      }
      vtkNew<vtkCellArray> cells;
      cells->SetData(kinds[k].offsets, kinds[k].corners);
      k == 0   ? polygons->SetVerts(cells)
      : k == 1 ? polygons->SetLines(cells)
      : k == 2 ? polygons->SetPolys(cells)
               : polygons->SetStrips(cells);
    }
    data = polygons;
  }
  data->SetPoints(vertices);
  tell(progress, 0.4, m_file.path());
  this->addArrays("PointData", step, step.points, pointRows, data->GetPointData(), progress);
  this->addArrays("CellData", step, start, cellRows, data->GetCellData(), progress);
  return data;
}

/// The arrays of an image's points or cells, of which each has rows of all directions that are not
/// flat, and with time steps one more.
void VTKHDFFile::addImageArrays(
  const std::string& group, const Step& step, std::uint64_t tuples, vtkDataSetAttributes* to) const
{
  for (const std::string& name : m_file.namesIn(root + group))
  {
    const std::string path = root + group + '/' + name;
    const std::optional<HDF5Array> known = m_file.array(path);
    if (!known || !known->isNumber || known->dimensions.empty() || tuples == 0)
      continue;
    const bool hasSteps = !m_times.empty();
    const std::uint64_t values = componentsOf(*known, hasSteps ? 1 : 0);
    if (values == 0 || values % tuples != 0 || values / tuples > 100'000)
      this->fail("'" + name + "' has " + std::to_string(values) + " values, which does not fit " +
                 std::to_string(tuples) + (group == "PointData" ? " points" : " cells"));
    std::uint64_t first = 0;
    if (hasSteps)
      first = m_file.array(root + "Steps/" + group + "Offsets/" + name)
                ? this->offsetAt(group + "Offsets/" + name, step)
                : step.number;
    vtkSmartPointer<vtkDataArray> array;
    array.TakeReference(vtkDataArray::CreateDataArray(vtkTypeOf(*known)));
    array->SetName(name.c_str());
    array->SetNumberOfComponents(static_cast<int>(values / tuples));
    array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
    m_file.readAsStored(path, first, hasSteps ? 1 : known->rows(), array->GetVoidPointer(0));
    to->AddArray(array);
  }
}

/// Numbers that the file says of an image.
std::vector<double> VTKHDFFile::numbers(const std::string& attribute, std::size_t count) const
{
  std::vector<double> found = m_file.numbers("/VTKHDF", attribute);
  if (found.size() != count)
    this->fail("the image has no " + attribute + " of " + std::to_string(count) + " numbers");
  return found;
}

std::array<int, 6> VTKHDFFile::extent() const
{
  const std::vector<double> read = this->numbers("WholeExtent", 6);
  std::array<int, 6> whole{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double low = read[2 * k], high = read[2 * k + 1];
    if (!(low >= -1e9 && high <= 1e9 && low <= high && high - low < 1e6))
      this->fail("the extent of the image is none");
    whole[2 * k] = static_cast<int>(low);
    whole[2 * k + 1] = static_cast<int>(high);
  }
  return whole;
}

vtkSmartPointer<vtkDataSet> VTKHDFFile::readImage(const Step& step, const Progress& progress) const
{
  std::array<int, 6> whole = this->extent();
  std::uint64_t points = 1, cells = 1;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const auto steps = static_cast<std::uint64_t>(whole[2 * k + 1] - whole[2 * k]);
    points *= steps + 1;
    cells *= std::max<std::uint64_t>(steps, 1);
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(whole.data());
  image->SetOrigin(this->numbers("Origin", 3).data());
  image->SetSpacing(this->numbers("Spacing", 3).data());
  if (const std::vector<double> turn = m_file.numbers("/VTKHDF", "Direction"); turn.size() == 9)
    image->SetDirectionMatrix(turn.data());
  this->addImageArrays("PointData", step, points, image->GetPointData());
  tell(progress, 0.5, m_file.path());
  this->addImageArrays("CellData", step, cells, image->GetCellData());
  if (image->GetPointData()->GetNumberOfArrays() + image->GetCellData()->GetNumberOfArrays() == 0 &&
      points > 1'000'000)
    this->fail("the image has " + std::to_string(points) + " points and no array");
  return image;
}

/// Facts about the whole, which are not of time steps.
void VTKHDFFile::addFields(vtkDataSet* to) const
{
  for (const std::string& name : m_file.namesIn(root + "FieldData"))
  {
    const std::string path = root + "FieldData/" + name;
    const std::optional<HDF5Array> known = m_file.array(path);
    const bool isOfSteps = m_file.array(root + "Steps/FieldDataOffsets/" + name).has_value();
    if (known && known->isNumber && !known->dimensions.empty() && !isOfSteps)
      to->GetFieldData()->AddArray(this->rows(path, {{0, known->rows()}}));
  }
}

vtkSmartPointer<vtkDataSet> VTKHDFFile::read(
  std::size_t number, const Piece& piece, const Progress& progress) const
{
  const Step step = this->stepAt(number);
  const vtkSmartPointer<vtkDataSet> data = m_type == VTK_IMAGE_DATA
                                             ? this->readImage(step, progress)
                                             : this->readCells(step, piece, progress);
  this->addFields(data);
  return data;
}

} // namespace mote
