// VTKHDF files: grids, polygonal data, images, parts and time steps; and what is wrong in them.

#include "IOTestSupport.h"
#include "VTKHDFSamples.h"

#include "vtkMoteReaderTable.h"

#include "vtkAlgorithm.h"
#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkHDFReader.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <functional>

namespace
{

class TestVTKHDF : public FileTest
{
protected:
  vtkSmartPointer<vtkDataSet> read(const std::string& file, std::optional<double> time = {})
  {
    m_error.clear();
    const auto reader = vtkMoteReaderTable::MakeReader(file, m_error);
    if (!reader)
      return nullptr;
    vtkSmartPointer<vtkDataObject> data = time ? vtkMoteReaderTable::Read(reader, *time, m_error)
                                               : vtkMoteReaderTable::Read(reader, m_error);
    return vtkDataSet::SafeDownCast(data);
  }

  std::string m_error;
};

void expectSame(vtkFieldData* a, vtkFieldData* b)
{
  ASSERT_EQ(a->GetNumberOfArrays(), b->GetNumberOfArrays());
  for (int k = 0; k < a->GetNumberOfArrays(); ++k)
  {
    vtkDataArray* one = a->GetArray(k);
    vtkDataArray* other = b->GetArray(one->GetName());
    ASSERT_TRUE(other) << one->GetName();
    EXPECT_EQ(one->GetDataType(), other->GetDataType()) << one->GetName();
    ASSERT_EQ(one->GetNumberOfValues(), other->GetNumberOfValues());
    for (vtkIdType i = 0; i < one->GetNumberOfTuples(); ++i)
      for (int c = 0; c < one->GetNumberOfComponents(); ++c)
        EXPECT_EQ(one->GetComponent(i, c), other->GetComponent(i, c)) << one->GetName();
  }
}

TEST_F(TestVTKHDF, GridsAsVTKReadsThem)
{
  for (const bool isImage : {false, true})
  {
    const std::string file = path(isImage ? "image.vtkhdf" : "grid.hdf");
    isImage ? writeImageHDF(file) : writeGridHDF(file);
    const auto own = read(file);
    ASSERT_TRUE(own) << m_error;
    vtkNew<vtkHDFReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    auto* other = vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
    ASSERT_TRUE(other);
    ASSERT_EQ(own->GetNumberOfPoints(), other->GetNumberOfPoints());
    ASSERT_EQ(own->GetNumberOfCells(), other->GetNumberOfCells());
    for (vtkIdType i = 0; i < own->GetNumberOfPoints(); ++i)
      for (int k = 0; k < 3; ++k)
        EXPECT_EQ(own->GetPoint(i)[k], other->GetPoint(i)[k]);
    for (vtkIdType c = 0; c < own->GetNumberOfCells(); ++c)
    {
      ASSERT_EQ(own->GetCellType(c), other->GetCellType(c));
      for (vtkIdType i = 0; i < own->GetCell(c)->GetNumberOfPoints(); ++i)
        EXPECT_EQ(own->GetCell(c)->GetPointId(static_cast<int>(i)),
          other->GetCell(c)->GetPointId(static_cast<int>(i)));
    }
    expectSame(own->GetPointData(), other->GetPointData());
    expectSame(own->GetCellData(), other->GetCellData());
  }
}

TEST_F(TestVTKHDF, GridsKeepTypesAndFields)
{
  writeGridHDF(path("a.h5")); // known by what is in it
  const auto data = read(path("a.h5"));
  ASSERT_TRUE(data) << m_error;
  EXPECT_EQ(data->GetNumberOfCells(), 3);
  EXPECT_EQ(data->GetCellType(2), VTK_TETRA);
  EXPECT_EQ(data->GetCell(2)->GetPointId(3), 14);
  EXPECT_EQ(data->GetPointData()->GetArray("p")->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(data->GetCellData()->GetArray("number")->GetDataType(), VTK_INT);
  EXPECT_EQ(data->GetCellData()->GetArray("U")->GetComponent(1, 2), 6.0);
  ASSERT_TRUE(data->GetFieldData()->GetArray("AxisDirection"));
  EXPECT_EQ(data->GetFieldData()->GetArray("AxisDirection")->GetComponent(1, 0), 1.0);
}

TEST_F(TestVTKHDF, PiecesTakePartsInTurn)
{
  writeGridHDF(path("a.vtkhdf"));
  std::string error;
  const auto reader = vtkMoteReaderTable::MakeReader(path("a.vtkhdf"), error);
  ASSERT_TRUE(reader) << error;
  reader->UpdatePiece(1, 2, 0);
  auto* data = vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  ASSERT_EQ(data->GetNumberOfCells(), 2);
  EXPECT_EQ(data->GetNumberOfPoints(), 7);
  EXPECT_EQ(data->GetCellData()->GetArray("number")->GetComponent(0, 0), 11.0);
  EXPECT_EQ(data->GetCell(0)->GetPoints()->GetPoint(1)[0], 3.0);
  reader->UpdatePiece(2, 3, 0);
  EXPECT_EQ(vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0))->GetNumberOfCells(), 0);
}

TEST_F(TestVTKHDF, CellsOfPolygonalData)
{
  writePolygonsHDF(path("a.vtkhdf"));
  const auto all = read(path("a.vtkhdf"));
  auto* data = vtkPolyData::SafeDownCast(all);
  ASSERT_TRUE(data) << m_error;
  ASSERT_EQ(data->GetNumberOfVerts(), 2);
  ASSERT_EQ(data->GetNumberOfPolys(), 2);
  vtkDataArray* numbers = data->GetCellData()->GetArray("number");
  ASSERT_TRUE(numbers);
  // Vertices of all parts come first.
  const double expected[] = {100, 200, 101, 201};
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(numbers->GetComponent(i, 0), expected[i]) << i;
  EXPECT_EQ(data->GetCell(1)->GetPointId(0), 4);
  EXPECT_EQ(data->GetCell(3)->GetPointId(0), 5);
}

TEST_F(TestVTKHDF, Steps)
{
  writeStepsHDF(path("a.vtkhdf"));
  std::string error;
  const auto reader = vtkMoteReaderTable::MakeReader(path("a.vtkhdf"), error);
  ASSERT_TRUE(reader) << error;
  EXPECT_EQ(vtkMoteReaderTable::GetTimeSteps(reader, error), (std::vector<double>{0.5, 1.5, 4}));
  const double places[] = {2, 2, 8}, values[] = {12, 22, 31}, times[] = {0.5, 1.5, 4};
  for (int step = 0; step < 3; ++step)
  {
    const auto data = read(path("a.vtkhdf"), times[step]);
    ASSERT_TRUE(data) << m_error;
    const vtkIdType count = step < 2 ? 3 : 2;
    ASSERT_EQ(data->GetNumberOfPoints(), count);
    ASSERT_EQ(data->GetNumberOfCells(), count);
    EXPECT_EQ(data->GetPoint(count - 1)[0], places[step]);
    EXPECT_EQ(data->GetPointData()->GetArray("v")->GetComponent(count - 1, 0), values[step]);
    EXPECT_EQ(data->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), times[step]);
  }
}

/// A grid of a tetrahedron with one of its arrays replaced.
std::string writeTetrahedron(
  const std::string& file, const std::string& name, const Numbers& numbers, bool isThere = true)
{
  HDF5Writer out(file);
  beginVTKHDF(out, "UnstructuredGrid", 1);
  const std::map<std::string, Numbers> usual = {{"NumberOfPoints", {4}}, {"NumberOfCells", {1}},
    {"NumberOfConnectivityIds", {4}}, {"Connectivity", {0, 1, 2, 3}}, {"Offsets", {0, 4}},
    {"Types", {10}}, {"CellData/c", {5}}, {"PointData/p", {1, 2, 3, 4}}};
  for (const auto& [own, values] : usual)
    if (own != name)
      out.array<std::int64_t>("/VTKHDF/" + own, values);
    else if (isThere)
      out.array<std::int64_t>("/VTKHDF/" + own, numbers);
  out.array<double>("/VTKHDF/Points", {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, 3);
  return file;
}

TEST_F(TestVTKHDF, WrongNumbersGetASentence)
{
  EXPECT_TRUE(read(writeTetrahedron(path("good.vtkhdf"), "", {}))) << m_error;
  const std::vector<std::pair<std::string, Numbers>> wrong = {{"NumberOfPoints", {5}},
    {"NumberOfPoints", {-1}}, {"NumberOfPoints", {1LL << 60}}, {"NumberOfCells", {2}},
    {"NumberOfCells", {-3}}, {"NumberOfCells", {1LL << 62}}, {"NumberOfConnectivityIds", {5}},
    {"NumberOfConnectivityIds", {3}}, {"Connectivity", {0, 1, 2, 4}},
    {"Connectivity", {0, 1, 2, -1}}, {"Connectivity", {0, 1, 2}}, {"Offsets", {0, 5}},
    {"Offsets", {4, 0}}, {"Offsets", {1, 4}}, {"Offsets", {0}}, {"Types", {42}}, {"Types", {}},
    {"CellData/c", {}}, {"PointData/p", {1, 2, 3}}};
  int number = 0;
  for (const auto& [name, numbers] : wrong)
  {
    const std::string file = path("wrong" + std::to_string(number++) + ".vtkhdf");
    EXPECT_FALSE(read(writeTetrahedron(file, name, numbers))) << name << ' ' << number;
    EXPECT_FALSE(m_error.empty());
    EXPECT_NE(m_error.find(file), std::string::npos) << m_error;
    EXPECT_EQ(m_error.find('\n'), std::string::npos) << m_error;
  }
  for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds",
         "Connectivity", "Offsets", "Types"})
  {
    const std::string file = path(std::string("without") + name + ".vtkhdf");
    EXPECT_FALSE(read(writeTetrahedron(file, name, {}, false))) << name;
  }
  const std::string other = path("other.vtkhdf");
  {
    HDF5Writer out(other);
    beginVTKHDF(out, "OverlappingAMR", 1);
  }
  EXPECT_FALSE(read(other));
  EXPECT_NE(m_error.find("OverlappingAMR"), std::string::npos) << m_error;
}

/// What is wrong with files in parts of the format that a grid of one step has not.
TEST_F(TestVTKHDF, WrongStepsAndImagesGetASentence)
{
  const std::string root = "/VTKHDF/", file = path("a.vtkhdf");
  const auto refused = [&](const std::string& words, std::optional<double> time = {})
  {
    EXPECT_FALSE(read(file, time)) << words;
    EXPECT_NE(m_error.find(words), std::string::npos) << m_error;
    EXPECT_EQ(m_error.find('\n'), std::string::npos) << m_error;
  };
  using Change = std::function<void(HDF5Writer&)>;
  const std::vector<std::pair<std::string, Change>> steps = {
    {"Steps/Values",
      [&](HDF5Writer& out) {
        out.array<double>(root + "Steps/Values", {0, 1}, 2);
      }},
    {"Steps/PartOffsets",
      [&](HDF5Writer& out) { out.array<std::int64_t>(root + "Steps/PartOffsets", {0}); }},
    {"Steps/PointOffsets",
      [&](HDF5Writer& out) {
        out.array<std::int64_t>(root + "Steps/PointOffsets", {0, -4, 3});
      }},
    {"Steps/NumberOfParts",
      [&](HDF5Writer& out) {
        out.array<std::int64_t>(root + "Steps/NumberOfParts", {1, 9, 1});
      }},
    {"Points",
      [&](HDF5Writer& out) { out.array<double>(root + "Points", std::vector<double>(10), 2); }}};
  const char* const words[] = {"no list", "has no number for each step", "numbers below zero",
    "a step has parts that are not there", "does not have three components"};
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    writeStepsHDF(file);
    const auto& [name, change] = steps[i];
    {
      HDF5Writer out(file, false);
      out.remove(root + name);
      change(out);
    }
    refused(words[i], 1.5);
  }
  const auto image = [&](const std::vector<double>& extent, std::size_t values)
  {
    HDF5Writer out(file);
    beginVTKHDF(out, "ImageData", 1);
    out.attribute("/VTKHDF", "WholeExtent", extent);
    out.attribute("/VTKHDF", "Origin", {1, 2, 3});
    out.attribute("/VTKHDF", "Spacing", {1, 1, 1});
    if (values > 0)
      out.block<float>(root + "PointData/p", std::vector<float>(values), {1, 1, values});
  };
  image({0, 2, 0}, 3);
  refused("no WholeExtent of 6 numbers");
  image({0, -2, 0, 0, 0, 0}, 3);
  refused("the extent of the image is none");
  image({0, 2, 0, 0, 0, 0}, 4);
  refused("");
  image({0, 10000, 0, 10000, 0, 10000}, 0);
  refused("points and no array");
}

TEST_F(TestVTKHDF, FilesThatEndTooEarlyGetASentence)
{
  writeGridHDF(path("whole.vtkhdf"));
  const auto bytes = std::filesystem::file_size(path("whole.vtkhdf"));
  int sentences = 0;
  for (std::uintmax_t end = 0; end < bytes; end += 257)
  {
    std::filesystem::copy_file(
      path("whole.vtkhdf"), path("cut.vtkhdf"), std::filesystem::copy_options::overwrite_existing);
    truncate("cut.vtkhdf", end);
    const auto data = read(path("cut.vtkhdf"));
    EXPECT_EQ(data == nullptr, !m_error.empty());
    sentences += data ? 0 : 1;
  }
  EXPECT_GT(sentences, 10);
}

} // namespace
