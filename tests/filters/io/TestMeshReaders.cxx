// Meshes as programs of engineers write them: blocks and their names, arrays, time steps.
#include "IOTestSupport.h"
#include "MeshSamples.h"
#include "vtkMoteReaderTable.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkEnSightWriter.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLMultiBlockDataWriter.h"
#include "vtkXMLPUnstructuredGridWriter.h"
#include "vtkXMLRectilinearGridWriter.h"
#include "vtkXMLStructuredGridWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <map>
#include <vector>

namespace
{

class TestMeshReaders : public FileTest
{
protected:
  using Blocks = std::map<std::string, vtkSmartPointer<vtkDataSet>>;

  /// Opens a file, and finds its times.
  std::vector<double> open(const std::string& file)
  {
    m_reader = vtkMoteReaderTable::MakeReader(file, m_error);
    EXPECT_TRUE(m_reader) << m_error;
    auto times = vtkMoteReaderTable::GetTimeSteps(m_reader, m_error);
    EXPECT_EQ(m_error, "");
    return times;
  }

  /// The data sets at a time by the names of their blocks.
  Blocks readAt(double time)
  {
    Blocks blocks;
    const auto data = vtkMoteReaderTable::Read(m_reader, time, m_error);
    EXPECT_TRUE(data) << m_error;
    auto* tree = vtkDataObjectTree::SafeDownCast(data);
    if (!tree)
    {
      blocks[""] = vtkDataSet::SafeDownCast(data);
      return blocks;
    }
    const auto leaves = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      vtkInformation* facts = leaves->GetCurrentMetaData();
      const bool isNamed = facts->Has(vtkCompositeDataSet::NAME());
      blocks[isNamed ? facts->Get(vtkCompositeDataSet::NAME()) : ""] =
        vtkDataSet::SafeDownCast(leaves->GetCurrentDataObject());
    }
    return blocks;
  }

  static double value(vtkDataArray* array, vtkIdType tuple, int component = 0)
  {
    return array && tuple < array->GetNumberOfTuples() ? array->GetComponent(tuple, component)
                                                       : -1e9;
  }

  static std::vector<std::string> namesOf(const Blocks& blocks)
  {
    std::vector<std::string> names;
    for (const auto& [name, data] : blocks)
      names.push_back(name);
    return names;
  }

  /// The two blocks of a .vtm file.
  static vtkSmartPointer<vtkMultiBlockDataSet> twoBlocks()
  {
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    blocks->SetBlock(0, samples::box());
    blocks->SetBlock(1, samples::structuredBox());
    blocks->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "fluid");
    blocks->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "rotor");
    return blocks;
  }

  vtkSmartPointer<vtkAlgorithm> m_reader;
  std::string m_error;
};

using Names = std::vector<std::string>;
using Times = std::vector<double>;

TEST_F(TestMeshReaders, OpenFOAM)
{
  for (const bool isBinary : {false, true})
  {
    const std::string folder = path(isBinary ? "binary" : "ascii");
    const std::string foam = samples::writeFoam(folder, {isBinary});
    for (const std::string& file : {foam, folder + "/system/controlDict", folder, folder + "/"})
    {
      EXPECT_EQ(open(file), (Times{0.0, 0.5}));
      const Blocks blocks = readAt(0.5);
      ASSERT_EQ(namesOf(blocks), (Names{"inlet", "internalMesh", "outlet", "walls"}));
      vtkDataSet* mesh = blocks.at("internalMesh");
      EXPECT_EQ(mesh->GetNumberOfCells(), 12);
      EXPECT_EQ(blocks.at("walls")->GetNumberOfCells(), 24);
      EXPECT_EQ(value(mesh->GetCellData()->GetArray("p"), 7), 7.5);
      EXPECT_EQ(value(mesh->GetCellData()->GetArray("U"), 7, 1), 7.0);
      EXPECT_EQ(value(blocks.at("inlet")->GetCellData()->GetArray("p"), 0), 7.0);
      EXPECT_EQ(value(blocks.at("outlet")->GetCellData()->GetArray("p"), 0), 2.5);
      const Blocks before = readAt(0.0);
      EXPECT_EQ(value(before.at("internalMesh")->GetCellData()->GetArray("p"), 7), 7.0);
      EXPECT_EQ(value(before.at("internalMesh")->GetCellData()->GetArray("U"), 7, 1), 2.0);
    }
  }
}

TEST_F(TestMeshReaders, OpenFOAMWhoseBytesLookLikeBraces)
{
  const std::string foam = samples::writeFoam(path("braces"), {true});
  std::string pressure = textOf("braces/0.5/p");
  const std::size_t begin = pressure.find("24\n(") + 4;
  pressure.replace(begin, 23 * sizeof(double), std::string(23 * sizeof(double), '{'));
  write("braces/0.5/p", pressure);
  open(foam);
  EXPECT_EQ(value(readAt(0.5).at("walls")->GetCellData()->GetArray("p"), 23), 3.0);
}

TEST_F(TestMeshReaders, PackedPointsWithoutCells)
{
  // As meshio writes them: no block, whose last one has 32768 bytes.
  const std::string none = "AAAAAACAAAAAgAAA";
  const auto array = [](const std::string& name, const std::string& type, const std::string& values)
  {
    return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
           (name == "Points" ? "3" : "1") + "\" format=\"binary\">" + values + "</DataArray>";
  };
  const std::string points = "AQAAAACAAAAMAAAACwAAAA==eJxjYEAAAAAMAAE=";
  open(write(
    "a.vtu", "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\" "
             "header_type=\"UInt32\" compressor=\"vtkZLibDataCompressor\"><UnstructuredGrid>"
             "<Piece NumberOfPoints=\"1\" NumberOfCells=\"0\"><Points>" +
               array("Points", "Float32", points) + "</Points><Cells>" +
               array("connectivity", "Int64", none) + array("offsets", "Int64", none) +
               array("types", "UInt8", none) + "</Cells><CellData>" + array("c", "Float32", none) +
               "</CellData></Piece></UnstructuredGrid></VTKFile>"));
  EXPECT_EQ(readAt(0.0).at("")->GetNumberOfPoints(), 1);
}

TEST_F(TestMeshReaders, PackedOpenFOAM)
{
  for (const bool isBinary : {false, true})
  {
    const std::string name = isBinary ? "binary" : "ascii";
    const std::string foam = samples::writeFoam(path(name), {isBinary});
    packFoam(name);
    ASSERT_FALSE(std::filesystem::exists(path(name + "/constant/polyMesh/points")));
    EXPECT_EQ(open(foam), (Times{0.0, 0.5}));
    const Blocks blocks = readAt(0.5);
    ASSERT_EQ(namesOf(blocks), (Names{"inlet", "internalMesh", "outlet", "walls"}));
    vtkDataSet* mesh = blocks.at("internalMesh");
    EXPECT_EQ(mesh->GetNumberOfCells(), 12);
    vtkDataArray* pressure = mesh->GetCellData()->GetArray("p");
    ASSERT_TRUE(pressure);
    EXPECT_EQ(value(pressure, 7), 7.5);
    const char* unit = pressure->GetInformation()->Get(vtkDataArray::UNITS_LABEL());
    EXPECT_STREQ(unit, "m^2 s^-2");
    EXPECT_EQ(value(mesh->GetCellData()->GetArray("U"), 7, 1), 7.0);
  }
}

TEST_F(TestMeshReaders, MovingOpenFOAM)
{
  open(samples::writeFoam(path("moving"), {false, -1, true}));
  for (const double time : {0.0, 0.5, 0.0})
  {
    double bounds[6];
    readAt(time).at("internalMesh")->GetBounds(bounds);
    EXPECT_EQ(bounds[0], 2.0 * time);
  }
  // Points alone may be new, too.
  for (const char* name : {"faces", "owner", "neighbour", "boundary"})
    std::filesystem::remove(path(std::string("moving/0.5/polyMesh/") + name));
  open(path("moving/case.foam"));
  for (const double time : {0.5, 0.0, 0.5, 0.0})
    for (const char* part : {"internalMesh", "inlet"})
      EXPECT_EQ(readAt(time).at(part)->GetPoint(0)[0], 2.0 * time) << part;
}

TEST_F(TestMeshReaders, OpenFOAMWithParticles)
{
  const std::string foam = samples::writeFoam(path("cloud"), {false, -1, false, true});
  // A list of one value is shorter in the file than the places it stands for.
  std::string pressure = textOf("cloud/0.5/p");
  const std::size_t begin = pressure.find("24\n(");
  ASSERT_NE(begin, pressure.npos);
  pressure.replace(begin, pressure.find(')', begin) + 1 - begin, "24{3}");
  write("cloud/0.5/p", pressure);
  open(foam);
  const Blocks blocks = readAt(0.5);
  EXPECT_EQ(value(blocks.at("walls")->GetCellData()->GetArray("p"), 23), 3.0);
  ASSERT_TRUE(blocks.contains("spray"));
  vtkPointData* arrays = blocks.at("spray")->GetPointData();
  EXPECT_EQ(blocks.at("spray")->GetPoint(2)[0], 2.5);
  EXPECT_NEAR(value(arrays->GetArray("d"), 1), 0.2, 1e-7);
  EXPECT_EQ(value(arrays->GetArray("rho"), 2), 1000.0);
}

TEST_F(TestMeshReaders, DecomposedOpenFOAM)
{
  for (const bool isBinary : {false, true})
  {
    const std::string folder = path(isBinary ? "binary" : "ascii");
    EXPECT_EQ(open(samples::writeDecomposedFoam(folder, isBinary)), (Times{0.0, 0.5}));
    const Blocks blocks = readAt(0.5);
    ASSERT_TRUE(blocks.contains("internalMesh"));
    EXPECT_EQ(blocks.at("internalMesh")->GetNumberOfCells(), 24);
    double bounds[6];
    blocks.at("internalMesh")->GetBounds(bounds);
    EXPECT_EQ(bounds[1], 6.0);
    EXPECT_EQ(blocks.at("walls")->GetNumberOfCells(), 48);
    EXPECT_TRUE(blocks.contains("inlet") && blocks.contains("outlet"));
    // Once it has been put together, that is what is read.
    samples::writeFoam(folder, {isBinary});
    open(folder + "/case.foam");
    EXPECT_EQ(readAt(0.5).at("internalMesh")->GetNumberOfCells(), 12);
  }
  std::filesystem::create_directories(path("collated/processors4/constant/polyMesh"));
  EXPECT_FALSE(vtkMoteReaderTable::MakeReader(write("collated/a.foam", ""), m_error));
  EXPECT_NE(m_error.find("reconstructPar"), std::string::npos) << m_error;
  EXPECT_FALSE(vtkMoteReaderTable::MakeReader(write("alone.foam", ""), m_error));
  EXPECT_NE(m_error.find("no mesh"), std::string::npos) << m_error;
}

TEST_F(TestMeshReaders, EnSight)
{
  for (const bool isBinary : {false, true})
  {
    const std::string file = samples::writeEnSight(path(isBinary ? "binary" : "ascii"), isBinary);
    EXPECT_EQ(open(file), (Times{0.0, 0.5}));
    const Blocks blocks = readAt(0.5);
    ASSERT_EQ(namesOf(blocks), (Names{"fluid", "inlet"}));
    EXPECT_EQ(blocks.at("fluid")->GetNumberOfCells(), 12);
    EXPECT_EQ(blocks.at("inlet")->GetNumberOfCells(), 4);
    EXPECT_EQ(value(blocks.at("fluid")->GetPointData()->GetArray("p"), 35), 223.0);
    EXPECT_EQ(value(blocks.at("fluid")->GetCellData()->GetArray("U"), 7, 0), 0.5);
    EXPECT_EQ(value(blocks.at("fluid")->GetCellData()->GetArray("U"), 7, 1), 7.0);
    EXPECT_EQ(value(readAt(0.0).at("fluid")->GetCellData()->GetArray("U"), 7, 0), 0.0);
  }
  EXPECT_FALSE(
    vtkMoteReaderTable::MakeReader(write("old.case", "FORMAT\ntype: ensight\n"), m_error));
  EXPECT_NE(m_error.find("Gold"), std::string::npos) << m_error;
}

TEST_F(TestMeshReaders, EnSightOfVTKsWriter)
{
  vtkNew<vtkEnSightWriter> writer;
  const auto grid = samples::box();
  writer->SetInputData(grid);
  writer->SetGhostLevel(0);
  writer->SetPath(path("").c_str());
  writer->SetBaseName("box");
  writer->SetTransientGeometry(false);
  writer->SetTimeStep(0);
  writer->Write();
  // VTK 9.1 leaves the case file itself open.
  open(
    write("a.case", "FORMAT\ntype: ensight gold\n\nGEOMETRY\nmodel: box.0.00000.geo\n\nVARIABLE\n"
                    "scalar per node: p box.0.00000_n.p\nscalar per element: q box.0.00000_c.q\n"
                    "vector per element: U box.0.00000_c.U\n"));
  vtkIdType cells = 0;
  for (const auto& [name, data] : readAt(0.0))
  {
    cells += data->GetNumberOfCells();
    EXPECT_TRUE(data->GetCellData()->GetArray("q")) << name;
    EXPECT_TRUE(data->GetPointData()->GetArray("p")) << name;
  }
  EXPECT_EQ(cells, 12);
}

TEST_F(TestMeshReaders, CGNS)
{
  samples::writeCGNS(path("a.cgns"));
  EXPECT_EQ(open(path("a.cgns")), (Times{0.0, 0.5}));
  const Blocks blocks = readAt(0.5);
  ASSERT_EQ(namesOf(blocks), (Names{"fluid", "inlet", "rotor", "walls"}));
  EXPECT_EQ(blocks.at("fluid")->GetNumberOfCells(), 12);
  EXPECT_EQ(blocks.at("walls")->GetNumberOfCells(), 24);
  EXPECT_TRUE(vtkStructuredGrid::SafeDownCast(blocks.at("rotor")));
  EXPECT_EQ(value(blocks.at("fluid")->GetCellData()->GetArray("q"), 7), 7.5);
  EXPECT_EQ(value(readAt(0.0).at("rotor")->GetCellData()->GetArray("q"), 7), 7.0);
}

TEST_F(TestMeshReaders, Blocks)
{
  open(writeWith<vtkXMLMultiBlockDataWriter>("a.vtm", twoBlocks()));
  const Blocks blocks = readAt(0.0);
  ASSERT_EQ(namesOf(blocks), (Names{"fluid", "rotor"}));
  EXPECT_TRUE(vtkUnstructuredGrid::SafeDownCast(blocks.at("fluid")));
  EXPECT_TRUE(vtkStructuredGrid::SafeDownCast(blocks.at("rotor")));
  // A series of such files.
  const std::vector<std::string> files = {
    writeWith<vtkXMLMultiBlockDataWriter>("b.1.vtm", twoBlocks()),
    writeWith<vtkXMLMultiBlockDataWriter>("b.2.vtm", twoBlocks())};
  EXPECT_EQ(vtkMoteReaderTable::GroupSeries(files).size(), 1u);
  m_reader = vtkMoteReaderTable::MakeReader(files, m_error);
  EXPECT_EQ(vtkMoteReaderTable::GetTimeSteps(m_reader, m_error), (Times{0.0, 1.0}));
  EXPECT_EQ(namesOf(readAt(1.0)), (Names{"fluid", "rotor"}));
}

TEST_F(TestMeshReaders, StructuredAndPieces)
{
  open(writeWith<vtkXMLStructuredGridWriter>("a.vts", samples::structuredBox()));
  EXPECT_EQ(readAt(0.0).at("")->GetNumberOfCells(), 12);
  vtkNew<vtkRectilinearGrid> grid;
  grid->SetDimensions(3, 3, 3);
  open(writeWith<vtkXMLRectilinearGridWriter>("a.vtr", grid.Get()));
  vtkNew<vtkXMLPUnstructuredGridWriter> writer;
  writer->SetInputData(samples::box());
  writer->SetFileName(path("a.pvtu").c_str());
  writer->SetNumberOfPieces(1);
  writer->Write();
  open(path("a.pvtu"));
  const Blocks blocks = readAt(0.0);
  EXPECT_EQ(blocks.at("")->GetNumberOfCells(), 12);
  EXPECT_EQ(value(blocks.at("")->GetCellData()->GetArray("q"), 11), 11.0);
}

TEST_F(TestMeshReaders, Collections)
{
  std::filesystem::create_directories(path("parts"));
  for (const char* name : {"parts/a.vtu", "parts/b.vtu"})
    writeWith<vtkXMLUnstructuredGridWriter>(name, samples::box(name[6] == 'b' ? 2.0 : 0.0));
  const auto entry = [](const std::string& attributes)
  { return "<DataSet " + attributes + "/>\n"; };
  const std::string begin =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\"><Collection>\n";
  const std::string end = "</Collection></VTKFile>\n";
  // Times need not ascend in the file.
  EXPECT_EQ(
    open(write("a.pvd", begin + entry(R"(timestep="2.5" file="parts/b.vtu")") +
                          entry(R"(timestep="1" part="0" name="fluid" file="parts/a.vtu")") +
                          entry(R"(timestep="1" part="1" file="parts/b.vtu")") + end)),
    (Times{1.0, 2.5}));
  EXPECT_EQ(namesOf(readAt(1.0)), (Names{"fluid", "part 1"}));
  const Blocks later = readAt(2.5);
  ASSERT_EQ(namesOf(later), (Names{""}));
  EXPECT_EQ(value(later.at("")->GetCellData()->GetArray("U"), 3, 0), 2.0);
  EXPECT_EQ(open(write("a.vtu.series",
              R"({"file-series-version":"1.0","files":[{"name":"parts/a.vtu","time":0.25},)"
              R"({"name":"parts/b.vtu","time":7}]})")),
    (Times{0.25, 7.0}));
  EXPECT_EQ(value(readAt(7.0).at("")->GetCellData()->GetArray("U"), 3, 0), 2.0);
  EXPECT_EQ(value(readAt(1.0).at("")->GetCellData()->GetArray("U"), 3, 0), 0.0); // before 7

  const auto expectError = [&](const std::string& file, const std::string& sentence)
  {
    m_error.clear();
    const auto reader = vtkMoteReaderTable::MakeReader(file, m_error);
    if (reader)
      vtkMoteReaderTable::GetTimeSteps(reader, m_error);
    if (reader && m_error.empty())
    {
      EXPECT_FALSE(vtkMoteReaderTable::Read(reader, m_error)) << file;
    }
    EXPECT_NE(m_error.find(sentence), std::string::npos) << m_error;
    EXPECT_EQ(m_error.find('\n'), std::string::npos) << m_error;
  };
  expectError(write("b.pvd", begin + entry(R"(timestep="0" file="none.vtu")") + end), "none.vtu");
  expectError(
    write("c.pvd", begin + entry(R"(timestep="soon" file="parts/a.vtu")") + end), "'soon'");
  expectError(write("d.pvd", begin + entry(R"(timestep="0" file="d.pvd")") + end), "within");
  expectError(write("e.pvd", begin + end), "no file");
  expectError(write("f.pvd", begin), "XML");
  expectError(write("g.pvd", ""), "XML");
  expectError(write("h.pvd", begin + entry(R"(timestep="0")") + end), "names no file");
  expectError(write("i.series", "{\"files\":["), "no whole list");
  expectError(write("j.series", R"({"files":[{"time":1}]})"), "no name");
  expectError(write("k.series", R"({"files":[{"name":"parts/a.vtu","time":"1"}]})"), "no number");
}

} // namespace
