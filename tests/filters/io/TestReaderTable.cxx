// Every entry of the table from file name to reader, and what it says about other files.
#include "IOTestSupport.h"
#include "vtkMoteDataWriter.h"
#include "vtkMoteLAMMPSDumpReader.h"
#include "vtkMotePiecesWriter.h"
#include "vtkMoteReaderTable.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetWriter.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkPLYWriter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSTLWriter.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLImageDataWriter.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <sstream>

namespace
{

class TestReaderTable : public FileTest
{
protected:
  vtkSmartPointer<vtkDataObject> read(const std::string& file, const char* readerClass)
  {
    auto reader = vtkMoteReaderTable::MakeReader(file, m_error);
    EXPECT_TRUE(reader) << m_error;
    if (!reader)
      return nullptr;
    EXPECT_STREQ(reader->GetClassName(), readerClass);
    EXPECT_EQ(vtkMoteReaderTable::CheckFile(file), "");
    auto data = vtkMoteReaderTable::Read(reader, m_error);
    EXPECT_TRUE(data) << m_error;
    return data;
  }

  vtkIdType points(const std::string& file, const char* readerClass)
  {
    auto data = read(file, readerClass);
    auto* set = vtkDataSet::SafeDownCast(data);
    return set ? set->GetNumberOfPoints() : -1;
  }

  void expectError(const std::string& file, const std::string& sentence)
  {
    auto reader = vtkMoteReaderTable::MakeReader(file, m_error);
    if (reader)
    {
      EXPECT_FALSE(vtkMoteReaderTable::Read(reader, m_error));
    }
    EXPECT_EQ(m_error.find('\n'), std::string::npos);
    EXPECT_NE(m_error.find(file), std::string::npos) << m_error;
    EXPECT_NE(m_error.find(sentence), std::string::npos) << m_error;
    std::cout << "  " << m_error << "\n";
  }

  std::string m_error;
};

TEST_F(TestReaderTable, ReadersOfThisModule)
{
  const std::string dump = dumpFrame(0, 1, "x y z", "1 2 3\n");
  EXPECT_EQ(points(write("a.dump", dump), "vtkMoteLAMMPSDumpReader"), 1);
  EXPECT_EQ(points(write("a.LAMMPSTRJ", dump), "vtkMoteLAMMPSDumpReader"), 1);
  EXPECT_EQ(points(writeGzip("a.dump.gz", dump), "vtkMoteLAMMPSDumpReader"), 1);
  EXPECT_EQ(points(write("dump.atom.100", dump), "vtkMoteLAMMPSDumpReader"), 1); // by content
  EXPECT_EQ(points(writeGzip("odd.gz", dump), "vtkMoteLAMMPSDumpReader"), 1);
  EXPECT_EQ(points(write("a.xyz", "1\n\nSi 1 2 3\n"), "vtkMoteXYZReader"), 1);
  EXPECT_EQ(points(write("a.extxyz", "1\n\nSi 1 2 3\n"), "vtkMoteXYZReader"), 1);
  EXPECT_EQ(points(write("a.pts", "1 2 3\n"), "vtkMotePointsReader"), 1);
  EXPECT_EQ(points(write("a.csv", "x,y,z\n1,2,3\n"), "vtkMoteDelimitedPointsReader"), 1);
  EXPECT_EQ(points(write("a.txt", "# x y z\n1 2 3\n"), "vtkMoteDelimitedPointsReader"), 1);
  EXPECT_EQ(
    points(write("dump.txt", dumpFrame(0, 1, "id x y z", "1 2 3 4\n")), "vtkMoteLAMMPSDumpReader"),
    1)
    << "by its content, as the name says little";
}

TEST_F(TestReaderTable, ReadersAndWritersPrintWhatTheyAre)
{
  const auto expectWords = [](vtkObject* object, const std::string& words)
  {
    std::ostringstream text;
    object->Print(text);
    EXPECT_NE(text.str().find(object->GetClassName()), std::string::npos);
    EXPECT_NE(text.str().find(words), std::string::npos) << words << " in\n" << text.str();
  };
  const std::pair<std::string, const char*> files[] = {
    {write("a.dump", dumpFrame(0, 1, "x y z", "1 2 3\n")), "FileName"},
    {write("a.xyz", "1\n\nSi 1 2 3\n1\n\nSi 1 2 3\n"), "Frames: 2"},
    {write("a.pts", "1 2 3\n"), "FileName"}, {write("a.csv", "x,y,z\n1,2,3\n"), "FileName"},
    {write("a.gro", "water\n1\n    1SOL     OW    1   0.1   0.2   0.3\n1 1 1\n"), "Open: yes"},
    {write("a.pvd", "<VTKFile type=\"Collection\"><Collection/></VTKFile>"), "TimeSteps: "}};
  for (const auto& [file, words] : files)
  {
    const auto reader = vtkMoteReaderTable::MakeReader(file, m_error);
    ASSERT_TRUE(reader) << m_error;
    vtkMoteReaderTable::Read(reader, m_error);
    expectWords(reader, words);
  }
  expectWords(vtkNew<vtkMoteDataWriter>(), "FileName");
  expectWords(vtkNew<vtkMotePiecesWriter>(), "NumberOfWrittenPieces: 0");
}

/// A reader of the same file need not look for its steps again.
TEST_F(TestReaderTable, DumpReadersShareWhatTheyFound)
{
  const std::string frame = dumpFrame(0, 1, "x y z", "1 2 3\n");
  const std::string file = write("a.dump", frame + dumpFrame(5, 1, "x y z", "4 5 6\n"));
  vtkNew<vtkMoteLAMMPSDumpReader> first, second;
  first->SetFileName(file.c_str());
  first->UpdateInformation();
  second->SetFileName(file.c_str());
  second->TakeIndexOf(first);
  second->UpdateTimeStep(5.0);
  EXPECT_EQ(second->GetOutput()->GetPoint(0)[0], 4.0);
  second->RemoveAllFileNames();
  second->AddFileName(write("b.dump", dumpFrame(7, 1, "x y z", "8 9 1\n")).c_str());
  second->Update();
  EXPECT_EQ(second->GetOutput()->GetPoint(0)[0], 8.0);
}

TEST_F(TestReaderTable, ReadersOfVTK)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  vtkPolyData* mesh = sphere->GetOutput();
  const vtkIdType count = mesh->GetNumberOfPoints();
  EXPECT_EQ(points(writeWith<vtkXMLPolyDataWriter>("a.vtp", mesh), "vtkXMLPolyDataReader"), count);
  EXPECT_EQ(
    points(writeWith<vtkDataSetWriter>("a.vtk", mesh), "vtkGenericDataObjectReader"), count);
  EXPECT_EQ(points(writeWith<vtkPLYWriter>("a.ply", mesh), "vtkPLYReader"), count);
  EXPECT_EQ(points(writeWith<vtkSTLWriter>("a.stl", mesh), "vtkSTLReader"), count);
  EXPECT_EQ(points(write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "vtkOBJReader"), 3);
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  image->AllocateScalars(VTK_FLOAT, 1);
  EXPECT_EQ(points(writeWith<vtkXMLImageDataWriter>("a.vti", image), "vtkXMLImageDataReader"), 27);
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> corners;
  corners->InsertNextPoint(0, 0, 0);
  grid->SetPoints(corners);
  EXPECT_EQ(
    points(writeWith<vtkXMLUnstructuredGridWriter>("a.vtu", grid), "vtkXMLUnstructuredGridReader"),
    1);
  EXPECT_EQ(points(writeWith<vtkDataSetWriter>("b.vtk", grid), "vtkGenericDataObjectReader"), 1);
  const std::string atom =
    "ATOM      1  N   ASP E   1       4.868 -17.809  25.188  1.00 34.37      E    N\n";
  EXPECT_EQ(points(write("a.pdb", atom), "vtkPDBReader"), 1);
}

TEST_F(TestReaderTable, WholePDB)
{
  const std::string atom =
    "ATOM      1  N   ASP E   1       4.868 -17.809  25.188  1.00 34.37      E    N";
  const std::string master = "MASTER        0    0    0    0    0    0    0    0";
  const std::vector<std::pair<std::string, int>> cases = {
    {atom + "\n" + atom + "\n", 2}, {atom + "\r\n" + atom + "\r\nEND\r\n", 2}, {atom + "\nEND", 1},
    {atom + "\n" + atom, 2}, {atom.substr(0, 54) + "\nEND\n", 1},
    {atom + "\n" + master + "    1    0\nEND\n", 1},
    {atom + "\n" + atom + "\n" + master + "    1    0\nEND\n", 2},
    {"MODEL        1\n" + atom + "\nENDMDL\nMODEL        2\n" + atom + "\nENDMDL\n" + master +
        "    2    0\nEND\n",
      1}, // of the first
  };
  for (const auto& [text, count] : cases)
  {
    auto object = read(write("a.pdb", text), "vtkPDBReader");
    auto* data = vtkPolyData::SafeDownCast(object);
    ASSERT_TRUE(data) << text;
    EXPECT_EQ(data->GetNumberOfPoints(), count) << text;
    vtkDataArray* radius = data->GetPointData()->GetArray("radius");
    ASSERT_TRUE(radius) << text;
    EXPECT_EQ(radius->GetNumberOfComponents(), 1);
    EXPECT_EQ(radius->GetNumberOfTuples(), count);
    EXPECT_NEAR(radius->GetTuple1(0), 1.55, 0.2); // nitrogen
  }
}

TEST_F(TestReaderTable, DamagedPDB)
{
  const std::string atom =
    "ATOM      1  N   ASP E   1       4.868 -17.809  25.188  1.00 34.37      E    N\n";
  std::string words = atom;
  words.replace(38, 8, "   -17.x");
  const std::string cut = "the last line has no line end, so the file may have been cut short";
  expectError(write("a.pdb", atom + atom.substr(0, 60)), ", line 2: " + cut);
  expectError(write("b.pdb", atom + atom.substr(0, 29)), ", line 2: " + cut);
  expectError(write("c.pdb", atom + atom.substr(0, 50) + "\n" + atom),
    ", line 2: the record of an atom ends after 50 columns, and its coordinates take 54");
  expectError(
    write("d.pdb", atom + words), ", line 2, column 39: expected a number for 'y', found '-17.x'");
  expectError(
    write("e.pdb", atom + "MASTER        0    0    0    0    0    0    0    0    2    0\nEND\n"),
    ", line 2: the MASTER record counts 2 atoms, but the file has 1");
}

TEST_F(TestReaderTable, OpenFOAMCase)
{
  // One cube, whose six faces are all boundary.
  const auto list = [this](
                      const std::string& name, const std::string& kind, const std::string& content)
  {
    write(name,
      "FoamFile\n{\nversion 2.0;\nformat ascii;\nclass " + kind + ";\nobject o;\n}\n" + content);
  };
  std::filesystem::create_directories(path("constant/polyMesh"));
  std::filesystem::create_directories(path("system"));
  std::filesystem::create_directories(path("0"));
  list("system/controlDict", "dictionary",
    "startFrom startTime;\nstartTime 0;\nendTime 1;\ndeltaT 1;\nwriteControl timeStep;\n"
    "writeInterval 1;\n");
  const std::string mesh = "constant/polyMesh/";
  list(mesh + "points", "vectorField",
    "8\n(\n(0 0 0)\n(1 0 0)\n(1 1 0)\n(0 1 0)\n(0 0 1)\n(1 0 1)\n(1 1 1)\n(0 1 1)\n)\n");
  list(mesh + "faces", "faceList",
    "6\n(\n4(0 3 2 1)\n4(4 5 6 7)\n4(0 1 5 4)\n4(2 3 7 6)\n4(0 4 7 3)\n4(1 2 6 5)\n)\n");
  list(mesh + "owner", "labelList", "6\n(\n0\n0\n0\n0\n0\n0\n)\n");
  list(mesh + "neighbour", "labelList", "0\n(\n)\n");
  list(mesh + "boundary", "polyBoundaryMesh",
    "1\n(\nwalls\n{\ntype wall;\nnFaces 6;\nstartFace 0;\n}\n)\n");
  auto data = read(write("case.foam", ""), "vtkMoteFoamReader");
  auto* blocks = vtkCompositeDataSet::SafeDownCast(data);
  ASSERT_TRUE(blocks);
  EXPECT_EQ(blocks->GetNumberOfCells(), 1 + 6); // and those of the patch
  std::filesystem::create_directories(path("bare"));
  expectError(write("bare/case.foam", ""), "");
}

namespace
{

/// A triangle, whose three points and three indices are this in base64.
std::string triangleInGLTF(
  const std::string& buffer = "data:application/octet-stream;base64,"
                              "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAABAAIA",
  const std::string& points = "3")
{
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
         R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
         R"("buffers":[{"uri":")" +
         buffer +
         R"(","byteLength":42}],"bufferViews":[{"buffer":0,"byteLength":36},)"
         R"({"buffer":0,"byteOffset":36,"byteLength":6}],"accessors":[{"bufferView":0,)"
         R"("componentType":5126,"type":"VEC3","min":[0,0,0],"max":[1,1,0],"count":)" +
         points + R"(},{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}]})";
}

} // namespace

TEST_F(TestReaderTable, MeshesInGLTF)
{
  const auto trianglesOf = [&](const std::string& file)
  {
    auto data = read(file, "vtkGLTFReader");
    auto* blocks = vtkCompositeDataSet::SafeDownCast(data);
    return blocks ? blocks->GetNumberOfCells() : -1;
  };
  EXPECT_EQ(trianglesOf(write("a.gltf", triangleInGLTF())), 1);
  const std::string bytes("\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\0\0\0\0\0\0"
                          "\0\0\0\0\0\0\x80\x3f\0\0\0\0\0\0\1\0\2\0",
    42);
  write("points.bin", bytes);
  EXPECT_EQ(trianglesOf(write("b.gltf", triangleInGLTF("points.bin"))), 1);
  // What VTK's reader does not survive, or reads beyond.
  expectError(write("alone.gltf", triangleInGLTF("missing.bin")), "'missing.bin'");
  write("short.bin", bytes.substr(0, 30));
  expectError(write("short.gltf", triangleInGLTF("short.bin")), "shorter");
  expectError(write("long.gltf", triangleInGLTF("points.bin", "4")), "accessors");
  expectError(write("longer.gltf", triangleInGLTF("points.bin", "1537228672809129302")), "");
  expectError(write("cut.gltf", triangleInGLTF().substr(0, 100)), "no glTF");
  expectError(write("empty.glb", ""), "no glTF");
  expectError(write("cut.glb", std::string("glTF\2\0\0\0\x64\0\0\0\x50\0\0\0JSON{}", 22)), "early");
  expectError(write("types.gltf", R"({"asset":1,"buffers":[1],"accessors":"x"})"), "");
}

TEST_F(TestReaderTable, ColorsOfVerticesInGLTF)
{
  std::string model = triangleInGLTF();
  const std::string places = R"("POSITION":0)";
  model.replace(model.find(places), places.size(), places + R"(,"COLOR_0":0)");
  auto data = read(write("a.gltf", model), "vtkGLTFReader");
  auto* blocks = vtkCompositeDataSet::SafeDownCast(data);
  ASSERT_TRUE(blocks);
  const auto each = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
  each->InitTraversal();
  ASSERT_FALSE(each->IsDoneWithTraversal());
  auto* triangle = vtkDataSet::SafeDownCast(each->GetCurrentDataObject());
  ASSERT_TRUE(triangle);
  vtkDataArray* colors = triangle->GetPointData()->GetArray("COLOR_0");
  ASSERT_TRUE(colors);
  EXPECT_EQ(colors->GetDataType(), VTK_UNSIGNED_CHAR);
  for (vtkIdType i = 0; i < 3; ++i)
    for (int c = 0; c < 3; ++c)
      EXPECT_EQ(colors->GetComponent(i, c), 255.0 * triangle->GetPoint(i)[c]) << i << c;
}

TEST_F(TestReaderTable, FilesThatCannotBeRead)
{
  expectError(path("missing.vtp"), "there is no such file");
  expectError(path("."), "this is a directory, not a file");
  expectError(
    write("a.unknown", "text\n"), "no reader knows this file; known extensions are .dump");
  expectError(write("a.bin", std::string("\xf8\xff\xff\xff\xff\xff\xff\xff", 8) + "DUMPATOM"),
    "the file ends within a time step: it is truncated");
  expectError(write("text.ply", "hello\n"), "this is no PLY file");
  EXPECT_NE(vtkMoteReaderTable::CheckFile(""), "");
  if (::geteuid() != 0)
  {
    const std::string secret = write("secret.vtp", "");
    std::filesystem::permissions(secret, std::filesystem::perms::none);
    expectError(secret, "you have no permission to read this file");
  }
}

TEST_F(TestReaderTable, DamagedFilesGiveOneSentenceAndPrintNothing)
{
  testing::internal::CaptureStderr();
  for (const char* name : {"a.dump", "a.xyz", "a.pts", "a.csv", "a.pdb", "a.vtp", "a.vtu", "a.vti",
         "a.vtk", "a.ply", "a.obj", "a.stl"})
  {
    expectError(write(name, "this is no such file\n"), "");
    expectError(write(name, ""), "");
  }
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  writeWith<vtkXMLPolyDataWriter>("cut.vtp", sphere->GetOutput());
  writeWith<vtkDataSetWriter>("cut.vtk", sphere->GetOutput());
  writeWith<vtkPLYWriter>("cut.ply", sphere->GetOutput());
  writeWith<vtkSTLWriter>("cut.stl", sphere->GetOutput());
  for (const char* name : {"cut.vtp", "cut.vtk", "cut.ply", "cut.stl"})
  {
    truncate(name, std::filesystem::file_size(path(name)) / 2);
    expectError(path(name), "");
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(TestReaderTable, TheOutputWindowIsLeftAsItWas)
{
  vtkOutputWindow* window = vtkOutputWindow::GetInstance();
  const int mode = window->GetDisplayMode();
  expectError(write("a.vtp", "no XML"), "");
  EXPECT_EQ(window->GetDisplayMode(), mode);
  EXPECT_FALSE(window->HasObserver(vtkCommand::ErrorEvent));
}

TEST_F(TestReaderTable, ThePumpIsMade)
{
  std::string error;
  const auto pump = vtkMoteReaderTable::MakeReader("pump:0.0005", error);
  ASSERT_TRUE(pump) << error;
  EXPECT_EQ(vtkMoteReaderTable::GetTimeSteps(pump, error).size(), 80u);
  const auto all = vtkMoteReaderTable::Read(pump, 0.01, error);
  ASSERT_TRUE(vtkCompositeDataSet::SafeDownCast(all)) << error;
  EXPECT_GT(vtkCompositeDataSet::SafeDownCast(all)->GetNumberOfCells(), 3000);
  for (const char* part : {"inlet", "rotor", "diffuser"})
  {
    const auto one = vtkMoteReaderTable::MakeReader("pump:5e-4:" + std::string(part), error);
    ASSERT_TRUE(one) << error;
    EXPECT_TRUE(vtkDataSet::SafeDownCast(vtkMoteReaderTable::Read(one, error))) << error;
  }
  for (const char* wrong : {"pump:", "pump:x", "pump:0.01x", "pump:nan", "pump:0", "pump:11",
         "pump:1:", "pump:1:blade", "pump::rotor"})
  {
    EXPECT_FALSE(vtkMoteReaderTable::MakeReader(wrong, error)) << wrong;
    EXPECT_NE(error.find(wrong), std::string::npos) << error;
    EXPECT_NE(error.find(" pump"), std::string::npos) << error;
    EXPECT_EQ(vtkMoteReaderTable::CheckFile(wrong), error);
  }
}

TEST_F(TestReaderTable, MeshesAreMade)
{
  const auto read = [](const std::string& name, std::string& error) -> vtkSmartPointer<vtkPolyData>
  {
    const auto reader = vtkMoteReaderTable::MakeReader(name, error);
    return reader ? vtkPolyData::SafeDownCast(vtkMoteReaderTable::Read(reader, error)) : nullptr;
  };
  std::string error;
  const auto sphere = read("sphere:5000", error);
  ASSERT_TRUE(sphere) << error;
  EXPECT_NEAR(double(sphere->GetNumberOfPolys()), 5000.0, 250.0);
  EXPECT_NEAR(sphere->GetLength(), 2.0 * std::sqrt(3.0), 0.2);
  const std::string model =
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const auto finer = read("subdivide:" + model + ":1000", error);
  ASSERT_TRUE(finer) << error;
  EXPECT_EQ(finer->GetNumberOfPolys(), 4 * 256);
  EXPECT_EQ(finer->GetNumberOfPoints(), 2 + 4 * 256 / 2); // closed: corners are shared
  for (const std::string& wrong : {std::string("sphere:"), std::string("sphere:99"),
         std::string("sphere:1e6"), std::string("sphere:536870913"), std::string("subdivide:1000"),
         std::string("subdivide::1000"), std::string("subdivide:none.ply:1000"),
         "subdivide:" + write("p.xyz", "1\n\nA 0 0 0\n") + ":1000", "subdivide:" + model + ":x"})
  {
    error.clear();
    EXPECT_FALSE(read(wrong, error)) << wrong;
    EXPECT_NE(error.find(wrong), std::string::npos) << error;
  }
}

TEST_F(TestReaderTable, Series)
{
  const auto file = [this](const char* name, int step)
  { return write(name, dumpFrame(step, 1, "x y z", "1 2 3\n")); };
  const std::vector<std::string> names = {file("p.1000.dump", 1000), write("m.vtp", ""),
    file("p.200.dump", 200), file("q.5.dump", 5), file("dump.9", 9), file("dump.10", 10),
    path("x.3.dump2")};
  const auto groups = vtkMoteReaderTable::GroupSeries(names);
  ASSERT_EQ(groups.size(), 5u);
  EXPECT_EQ(groups[0], (std::vector<std::string>{names[2], names[0]}));
  EXPECT_EQ(groups[1], (std::vector<std::string>{names[1]}));
  EXPECT_EQ(groups[3], (std::vector<std::string>{names[4], names[5]}));
  auto reader = vtkMoteReaderTable::MakeReader(groups[0], m_error);
  ASSERT_TRUE(reader) << m_error;
  EXPECT_EQ(vtkMoteReaderTable::GetTimeSteps(reader, m_error), (std::vector<double>{200, 1000}));
  EXPECT_FALSE(vtkMoteReaderTable::MakeReader({names[0], names[1]}, m_error));
  EXPECT_NE(m_error.find("one format"), std::string::npos) << m_error;
  const std::string mesh = write("m.stl", "");
  EXPECT_FALSE(vtkMoteReaderTable::MakeReader({mesh, mesh}, m_error));
  EXPECT_NE(m_error.find("make no series"), std::string::npos) << m_error;
  EXPECT_FALSE(vtkMoteReaderTable::MakeReader(std::vector<std::string>(), m_error));
}

TEST_F(TestReaderTable, NoReaderNoData)
{
  EXPECT_TRUE(vtkMoteReaderTable::GetTimeSteps(nullptr, m_error).empty());
  EXPECT_NE(m_error.find("no reader"), std::string::npos) << m_error;
  m_error.clear();
  EXPECT_EQ(vtkMoteReaderTable::Read(nullptr, m_error), nullptr);
  EXPECT_NE(m_error.find("no reader"), std::string::npos) << m_error;
  m_error.clear();
  EXPECT_EQ(vtkMoteReaderTable::Read(nullptr, 1.0, m_error), nullptr);
  EXPECT_NE(m_error.find("no reader"), std::string::npos) << m_error;
}

TEST_F(TestReaderTable, FormsForPython)
{
  const std::string file = write("a.xyz", "1\n\nSi 1 2 3\n");
  auto reader = vtkSmartPointer<vtkAlgorithm>::Take(vtkMoteReaderTable::NewReader(file));
  ASSERT_TRUE(reader);
  auto data = vtkSmartPointer<vtkDataObject>::Take(vtkMoteReaderTable::ReadFile(file));
  ASSERT_TRUE(data);
  EXPECT_EQ(vtkPolyData::SafeDownCast(data)->GetNumberOfPoints(), 1);
  vtkOutputWindow::GetInstance()->SetDisplayModeToNever();
  EXPECT_EQ(vtkMoteReaderTable::NewReader(path("missing.vtp")), nullptr);
  EXPECT_EQ(vtkMoteReaderTable::ReadFile(write("bad.vtp", "")), nullptr);
  vtkOutputWindow::GetInstance()->SetDisplayModeToDefault();
}

TEST_F(TestReaderTable, Lists)
{
  EXPECT_EQ(vtkMoteReaderTable::GetExtensions().find(".dump .lammpstrj"), 0u);
  const std::string help = vtkMoteReaderTable::GetFormatsHelp();
  EXPECT_NE(help.find("\n  .vtp  "), std::string::npos) << help;
  vtkNew<vtkMoteReaderTable> table;
  std::ostringstream text;
  table->Print(text);
  EXPECT_NE(text.str().find(".foam"), std::string::npos);
}

} // namespace
