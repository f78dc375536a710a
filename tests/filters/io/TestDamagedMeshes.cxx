// Damaged meshes and archives are read right or get one sentence: they are cut, bytes and numbers
// are changed.
#include "IOTestSupport.h"
#include "MeshSamples.h"
#include "ParticleArchives.h"
#include "vtkMoteReaderTable.h"

#include "vtkAlgorithm.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLMultiBlockDataWriter.h"
#include "vtkXMLPUnstructuredGridWriter.h"
#include "vtkXMLStructuredGridWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <random>
#include <vector>

#ifdef __SANITIZE_ADDRESS__
/// What VTK loses is known by the functions that do it (tests/lsan.supp); its libraries keep no
/// frame pointers, and the quick way sees nothing of them.
extern "C" const char* __asan_default_options()
{
  return "fast_unwind_on_malloc=0";
}
#endif

namespace
{

class TestDamagedMeshes : public FileTest
{
protected:
  /// Reads all steps, and the first again; the first sentence of what is wrong.
  static std::string read(const std::string& file)
  {
    std::string first;
    const auto keep = [&](const std::string& error) { first = first.empty() ? error : first; };
    std::string error;
    const auto reader = vtkMoteReaderTable::MakeReader(file, error);
    if (!reader)
      return error;
    std::vector<double> times = vtkMoteReaderTable::GetTimeSteps(reader, error);
    if (!error.empty())
      return error;
    if (times.empty())
      vtkMoteReaderTable::Read(reader, error);
    else
      times.push_back(times.front());
    keep(error);
    for (const double time : times)
    {
      error.clear();
      vtkMoteReaderTable::Read(reader, time, error);
      keep(error);
    }
    return first;
  }

  /// The bytes without an end, with others among them, or with another number.
  static std::string damaged(std::string bytes, int kind, std::mt19937& random)
  {
    if (kind == 0)
      bytes.resize(random() % bytes.size());
    if (kind == 1)
      for (auto changes = 1 + random() % 4; changes > 0; --changes)
        bytes[random() % bytes.size()] = static_cast<char>(random());
    if (kind < 2)
      return bytes;
    const auto isDigit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
    const auto begin = std::find_if(
      bytes.begin() + static_cast<std::ptrdiff_t>(random() % bytes.size()), bytes.end(), isDigit);
    const auto end = std::find_if_not(begin, bytes.end(), isDigit);
    static const std::vector<std::string> numbers = {
      "0", "-1", "7", "999999999", "2147483647", "-2147483648", "99999999999999999999"};
    return std::string(bytes.begin(), begin) + numbers[random() % numbers.size()] +
           std::string(end, bytes.end());
  }

  /// Damages each file that there is, in turn, so many times.
  void damage(const std::string& file, int times)
  {
    testing::internal::CaptureStderr();
    EXPECT_EQ(read(file), "");
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path("")))
      if (entry.is_regular_file() && entry.file_size() > 0)
        files.push_back(std::filesystem::relative(entry.path(), path("")).string());
    std::sort(files.begin(), files.end());
    std::mt19937 random(11);
    int refused = 0;
    for (const auto& one : files)
    {
      const std::string whole = textOf(one);
      for (int i = 0; i < times; ++i)
      {
        write(one, damaged(whole, i % 3, random));
        const std::string error = read(file);
        refused += !error.empty();
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
        EXPECT_TRUE(error.empty() || error.find(path("")) != std::string::npos) << error;
      }
      write(one, whole);
    }
    EXPECT_GT(refused, static_cast<int>(files.size()) * times / 4);
    EXPECT_EQ(read(file), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  }
};

TEST_F(TestDamagedMeshes, OpenFOAM)
{
  damage(samples::writeFoam(path("ascii")), 15);
}

TEST_F(TestDamagedMeshes, BinaryOpenFOAM)
{
  damage(samples::writeFoam(path("binary"), {true}), 15);
}

TEST_F(TestDamagedMeshes, DecomposedOpenFOAM)
{
  damage(samples::writeDecomposedFoam(path("decomposed"), true), 12);
}

TEST_F(TestDamagedMeshes, MovingOpenFOAM)
{
  damage(samples::writeFoam(path("moving"), {false, -1, true, true}), 12);
}

TEST_F(TestDamagedMeshes, MovingPointsOfOpenFOAM)
{
  const std::string file = samples::writeFoam(path("points"), {false, -1, true});
  for (const char* name : {"faces", "owner", "neighbour", "boundary"})
    std::filesystem::remove(path(std::string("points/0.5/polyMesh/") + name));
  damage(file, 12);
  // VTK's reader would move the points of the time before to none.
  const std::string name = "points/0.5/polyMesh/points", whole = textOf(name);
  for (const auto& [from, to] : {std::pair{"object", "objct"}, std::pair{"0 0)", "0 zero)"}})
  {
    write(name, std::string(whole).replace(whole.find(from), std::string(from).size(), to));
    EXPECT_NE(read(file), "") << to;
  }
}

TEST_F(TestDamagedMeshes, PackedOpenFOAM)
{
  const std::string file = samples::writeFoam(path("packed"));
  packFoam("packed");
  damage(file, 15);
}

TEST_F(TestDamagedMeshes, EnSight)
{
  damage(samples::writeEnSight(path("ascii"), false), 30);
}

TEST_F(TestDamagedMeshes, BinaryEnSight)
{
  damage(samples::writeEnSight(path("binary"), true), 30);
}

TEST_F(TestDamagedMeshes, EnSightWithStepsInOneFile)
{
  for (const bool isBinary : {false, true})
  {
    std::filesystem::remove_all(path(""));
    damage(samples::writeEnSightSteps(path("steps"), isBinary), 60);
  }
}

TEST_F(TestDamagedMeshes, Bgeo)
{
  damage(write("a.bgeo", samples::bgeo()), 300);
}

TEST_F(TestDamagedMeshes, Uintah)
{
  damage(samples::Archive(path("a.uda"), false, false).index(), 30);
}

TEST_F(TestDamagedMeshes, UintahWithGzip)
{
  damage(samples::Archive(path("a.uda"), false, true).index(), 30);
}

TEST_F(TestDamagedMeshes, CGNS)
{
  samples::writeCGNS(path("a.cgns"));
  damage(path("a.cgns"), 90);
}

TEST_F(TestDamagedMeshes, Blocks)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, samples::box());
  blocks->SetBlock(1, samples::structuredBox());
  damage(writeWith<vtkXMLMultiBlockDataWriter>("a.vtm", blocks.Get()), 30);
}

TEST_F(TestDamagedMeshes, StructuredGrids)
{
  damage(writeWith<vtkXMLStructuredGridWriter>("a.vts", samples::structuredBox()), 60);
}

TEST_F(TestDamagedMeshes, Pieces)
{
  vtkNew<vtkXMLPUnstructuredGridWriter> writer;
  writer->SetInputData(samples::box());
  writer->SetFileName(path("a.pvtu").c_str());
  writer->Write();
  damage(path("a.pvtu"), 60);
}

TEST_F(TestDamagedMeshes, PiecesAndBlocksWithoutPointDataWhoseCellDataAreTooShort)
{
  const auto array = [](const std::string& type, const std::string& name, const std::string& values)
  {
    return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
           (name == "Points" ? "3" : "1") + "\" format=\"ascii\">" + values + "</DataArray>";
  };
  const std::string points =
    "<Points>" + array("Float32", "Points", "0 0 0 1 0 0 0 1 0 0 0 1") + "</Points>";
  const std::string cells =
    array("Int64", "connectivity", "0 1 2 3") + array("Int64", "offsets", "4");
  const auto readPieces = [&](const std::string& kind, const std::string& ending,
                            const std::string& count, const std::string& rest)
  {
    const std::string type = "<VTKFile type=\"", version = "\" version=\"0.1\">";
    // One cell, and no value.
    write("short." + ending, type + kind + version + "<" + kind + "><Piece NumberOfPoints=\"4\" " +
                               count + "=\"1\">" + "<CellData>" + array("Float32", "c", "") +
                               "</CellData>" + points + rest + "</Piece></" + kind + "></VTKFile>");
    write("short.p" + ending,
      type + "P" + kind + version + "<P" + kind +
        " GhostLevel=\"0\"><PCellData><PDataArray type=\"Float32\" Name=\"c\"/></PCellData>"
        "<PPoints><PDataArray type=\"Float32\" Name=\"Points\" NumberOfComponents=\"3\"/></PPoints>"
        "<Piece Source=\"short." +
        ending + "\"/></P" + kind + "></VTKFile>");
    write("short.vtm", type + "vtkMultiBlockDataSet" + version +
                         "<vtkMultiBlockDataSet><DataSet index=\"0\" file=\"short." + ending +
                         "\"/></vtkMultiBlockDataSet></VTKFile>");
    EXPECT_NE(read(path("short.vtm")), "");
    return read(path("short.p" + ending));
  };
  EXPECT_NE(readPieces("UnstructuredGrid", "vtu", "NumberOfCells",
              "<Cells>" + cells + array("UInt8", "types", "10") + "</Cells>"),
    "");
  EXPECT_NE(readPieces("PolyData", "vtp", "NumberOfPolys", "<Polys>" + cells + "</Polys>"), "");
}

TEST_F(TestDamagedMeshes, StepsInOneFile)
{
  const auto array = [](const std::string& name, int step, const std::string& values)
  {
    return "<DataArray type=\"Float32\" Name=\"" + name + "\" TimeStep=\"" + std::to_string(step) +
           "\" format=\"ascii\">" + values + "</DataArray>\n";
  };
  const auto file = [&](const std::string& first)
  {
    return write("a.vti",
      "<VTKFile type=\"ImageData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "<ImageData TimeValues=\"0 1\" WholeExtent=\"0 1 0 1 0 1\" Origin=\"0 0 0\" "
      "Spacing=\"1 1 1\"><Piece Extent=\"0 1 0 1 0 1\">\n<PointData>" +
        array("p", 0, first) + array("p", 1, "7 6 5 4 3 2 1 0") + "</PointData>\n<CellData>" +
        array("c", 0, "1") + array("c", 1, "2") + "</CellData>\n</Piece></ImageData></VTKFile>\n");
  };
  damage(file("0 1 2 3 4 5 6 7"), 300);
  // VTK's reader would take the arrays of another step for those that it could not read.
  EXPECT_NE(read(file("0 1 two 3 4 5 6 7")).find("a.vti"), std::string::npos);
}

TEST_F(TestDamagedMeshes, Collections)
{
  writeWith<vtkXMLUnstructuredGridWriter>("a.vtu", samples::box());
  write("a.pvd",
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n"
    "<DataSet timestep=\"0\" part=\"0\" name=\"x\" file=\"a.vtu\"/>\n"
    "<DataSet timestep=\"1.5\" file=\"a.vtu\"/>\n</Collection>\n</VTKFile>\n");
  damage(path("a.pvd"), 60);
}

TEST_F(TestDamagedMeshes, WhatCrashedAReader)
{
  samples::writeFoam(path("foam"), {false, -1, true, true});
  for (const bool isPacked : {false, true})
  {
    const auto change = [&](const std::string& name, const std::string& from, const std::string& to,
                          const std::string& told = "")
    {
      SCOPED_TRACE(name + " with " + to + (isPacked ? ", packed" : ""));
      std::filesystem::copy(
        path("foam"), path("changed"), std::filesystem::copy_options::recursive);
      std::string text = textOf("foam/" + name);
      const std::size_t at = text.find(from);
      ASSERT_NE(at, std::string::npos);
      write("changed/" + name, text.replace(at, from.size(), to));
      if (isPacked)
        packFoam("changed");
      const std::string error = read(path("changed/case.foam"));
      EXPECT_NE(error.find(told.empty() ? "changed/" + name : told), std::string::npos) << error;
      std::filesystem::remove_all(path("changed"));
    };
    change("0/U", "boundaryField\n", "boundaryField/");
    // The reader looks at the boundary before it misses another file.
    std::filesystem::rename(path("foam/constant/polyMesh/owner"), path("owner"));
    change("constant/polyMesh/boundary", "(", "nothing");
    std::filesystem::rename(path("owner"), path("foam/constant/polyMesh/owner"));
    change("constant/polyMesh/boundary", "inlet\n    {", "inlet\n    ");
    // An entry of no name, of which VTK's reader threw a text.
    change("0/p", "{", std::string("{ note (\0{});", 13), "the case is damaged");
    // Memory would be taken for what one value is said to stand for.
    const std::string list = "nonuniform List<scalar>\n24\n(\n3";
    change("0.5/p", list, "nonuniform List<scalar>\n2000000000{3}\n;(\n3");
    change("0.5/lagrangian/spray/rho", "3{", "2000000000{");
    change("0.5/lagrangian/spray/d", "3\n(", "2000000000\n(");
    for (const std::string folder : {"constant", "0.5"})
    {
      change(folder + "/polyMesh/owner", "\n0", "\n-5");
      change(folder + "/polyMesh/owner", "\n0", "\n99999999");
      change(folder + "/polyMesh/faces", "4(1", "4(100");
    }
  }
  const std::string file = samples::writeEnSight(path("ensight"), true);
  for (const std::size_t bytes : {0u, 300u, 900u})
  {
    const std::string whole = textOf("ensight/box.geo");
    truncate("ensight/box.geo", bytes);
    EXPECT_NE(read(file).find("box.geo: the file ends too early"), std::string::npos) << read(file);
    write("ensight/box.geo", whole);
  }
}

} // namespace
