// What is refused of PLY and OBJ, and before VTK's readers of STL, glTF and legacy files see it,
// and what of these formats has to pass.
#include "TableTest.h"

#include "vtkDataSet.h"
#include "vtkDataSetWriter.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPLYWriter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSTLWriter.h"
#include "vtkSphereSource.h"
#include "vtkStringArray.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <cstdint>
#include <map>

namespace
{

class TestFormatChecks : public TableTest
{
protected:
  void expectPoints(const std::string& file, vtkIdType points, vtkIdType cells)
  {
    EXPECT_EQ(errorOf(file), "");
    auto* set = vtkDataSet::SafeDownCast(m_data);
    ASSERT_TRUE(set);
    EXPECT_EQ(set->GetNumberOfPoints(), points);
    EXPECT_EQ(set->GetNumberOfCells(), cells);
  }

  /// Every beginning of a file is refused, or holds data; none crashes.
  void cutEverywhere(const std::string& file, std::size_t step)
  {
    std::ifstream stream(file, std::ios::binary);
    const std::string whole(std::istreambuf_iterator<char>(stream), {});
    const std::string name = "cut" + std::filesystem::path(file).extension().string();
    int refused = 0;
    for (std::size_t size = 0; size < whole.size(); size += step)
    {
      const std::string error = errorOf(write(name, whole.substr(0, size)));
      EXPECT_EQ(error.empty(), m_data != nullptr) << size;
      refused += !error.empty();
    }
    EXPECT_GT(refused, 3);
  }
};

const std::string plyHead = "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 3\n"
                            "property float x\nproperty float y\nproperty float z\n";
const std::string plyFace = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string plyPoints = "0 0 0\n1 0 0\n0 1 0\n";

TEST_F(TestFormatChecks, PLYOfAllKindsPasses)
{
  expectPoints(write("a.ply", plyHead + plyFace + "end_header\n" + plyPoints + "3 0 1 2\n"), 3, 1);
  expectPoints(write("b.ply", plyHead + "property uchar red\n" + plyFace +
                                "element edge 1\nproperty int from\nend_header\n"
                                "0 0 0 1\n1 0 0 2\n0 1 0 3\n3 0 1 2\n7\n"),
    3, 1);
  expectPoints(
    write("crlf.ply", "ply\r\nformat ascii 1.0\r\nelement vertex 1\r\nproperty float x\r\n"
                      "property float y\r\nproperty float z\r\nend_header\r\n1 2 3\r\n"),
    1, 0);
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  vtkNew<vtkPLYWriter> writer;
  writer->SetInputData(sphere->GetOutput());
  for (const bool big : {false, true})
  {
    const std::string file = path(big ? "big.ply" : "little.ply");
    writer->SetFileName(file.c_str());
    writer->SetDataByteOrder(big ? VTK_BIG_ENDIAN : VTK_LITTLE_ENDIAN);
    writer->Write();
    expectPoints(
      file, sphere->GetOutput()->GetNumberOfPoints(), sphere->GetOutput()->GetNumberOfCells());
    cutEverywhere(file, 97);
  }
}

TEST_F(TestFormatChecks, PLYThatVTKWouldCrashOn)
{
  const std::string end = "end_header\n" + plyPoints;
  expectError(write("a.ply", plyHead + plyFace + end + "3 0 1 3\n"), "line 14: a face has a point");
  expectError(write("a.ply", plyHead + plyFace + end + "3 0 1 -1\n"), "a face has a point");
  expectError(write("a.ply", plyHead + plyFace + end + "3 0 1\n"), "fewer values");
  expectError(write("a.ply", plyHead + plyFace + end + "3 0 1 2 2\n"), "more values");
  expectError(write("a.ply", plyHead + plyFace + end + "-3 0 1 2\n"), "a list of -3");
  expectError(write("a.ply", plyHead + plyFace + end + "3 0 b 2\n"), "found 'b'");
  expectError(write("a.ply", plyHead + plyFace + end), "truncated");
  expectError(write("a.ply", plyHead + "prop float w\n" + end), "line 8");
  expectError(write("a.ply", plyHead + "property half w\n" + end), "'half' is no type");
  expectError(write("a.ply", plyHead + "property list float int w\n" + end), "is no float");
  expectError(write("a.ply", plyHead + "property float x\n" + end), "a second property 'x'");
  expectError(
    write("a.ply", plyHead + "property list uchar int red\n" + end), "'red' is one value");
  expectError(write("a.ply", plyHead + "element face -1\n" + end), "a number of elements");
  expectError(write("a.ply", plyHead + "element vertex 1\n" + end), "cannot be called");
  expectError(write("a.ply", plyHead + "element face 1\nproperty uchar a\n" + end + "1\n"),
    "has no list 'vertex_indices'");
  expectError(write("a.ply",
                plyHead + "element edge 1\nproperty int from\n" + plyFace + end + "1\n3 0 1 2\n"),
    "'edge' must stand behind");
  expectError(write("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                             "end_header\n1\n"),
    "needs an element 'vertex'");
  expectError(write("a.ply", "ply\nelement vertex 1\nproperty float x\nend_header\n1\n"), "format");
}

const std::string objPoints = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\n";

TEST_F(TestFormatChecks, OBJOfAllKindsPasses)
{
  expectPoints(write("a.obj", objPoints + "f 1 2 3\n"), 3, 1);
  expectPoints(write("a.obj", objPoints + "f -3/-3 -2/-2 -1/-1\n"), 3, 1);
  expectPoints(write("a.obj", objPoints + "g a\nusemtl m\nf 1/1/1 2/2/1 3/3/1\n"), 3, 1);
  expectPoints(write("a.obj", objPoints + "f 1//1 \\\n2//1 3//1\n"), 3, 1);
  expectPoints(write("a.obj", "f 1 2 3\n" + objPoints), 3, 1);
  expectPoints(write("a.obj", objPoints + "l 1 2/2 3\np 1 3\n"), 3, 2);
}

TEST_F(TestFormatChecks, OBJThatIsDamaged)
{
  expectError(write("a.obj", objPoints + "f 1 2 4\n"), "line 8: number 4 is asked for, and there "
                                                       "are 3 vertices");
  expectError(write("a.obj", objPoints + "f 1/4 2/1 3/1\n"), "3 texture coordinates");
  expectError(write("a.obj", objPoints + "f 1//1 2//2 3//1\n"), "1 normals");
  expectError(write("a.obj", objPoints + "f 0 1 2\n"), "before the first");
  expectError(write("a.obj", objPoints + "f -4 1 2\n"), "before the first");
  expectError(write("a.obj", objPoints + "f 1 2 99999999999\n"), "expected numbers such as");
  expectError(write("a.obj", objPoints + "f 1/ 2/ 3/\n"), "expected numbers such as");
  expectError(write("a.obj", objPoints + "f 1 2\n"), "expected 3 numbers or more");
  expectError(write("a.obj", objPoints + "f 1 2 \\\n"), "a line is to follow");
  expectError(write("a.obj", "v 0 0\n"), "line 1: expected 3 numbers");
  expectError(write("a.obj", objPoints + std::string("f 1 2 3\n\0\n", 10)), "zero byte");
}

TEST_F(TestFormatChecks, STLAnnouncesWhatItHas)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  vtkNew<vtkSTLWriter> writer;
  writer->SetInputData(sphere->GetOutput());
  writer->SetFileName(path("a.stl").c_str());
  writer->SetFileTypeToBinary();
  writer->Write();
  const vtkIdType points = sphere->GetOutput()->GetNumberOfPoints();
  expectPoints(path("a.stl"), points, sphere->GetOutput()->GetNumberOfCells());
  truncate("a.stl", std::filesystem::file_size(path("a.stl")) - 1);
  expectError(path("a.stl"), "truncated");
}

/// A data set of every kind with values at its points and, where `strings`, names.
template <class Set>
vtkSmartPointer<Set> withValues(vtkSmartPointer<Set> set, bool strings)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName("a value");
  values->SetNumberOfComponents(2);
  values->SetNumberOfTuples(set->GetNumberOfPoints());
  values->Fill(0.25);
  set->GetPointData()->AddArray(values);
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("v");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(set->GetNumberOfPoints());
  vectors->Fill(-1.5);
  vectors->SetComponentName(0, "first");
  set->GetPointData()->SetVectors(vectors);
  if (strings)
  {
    vtkNew<vtkStringArray> names;
    names->SetName("names");
    names->SetNumberOfValues(set->GetNumberOfPoints());
    names->SetValue(0, "the first of all, and more than sixty-three bytes long, as some names are");
    set->GetPointData()->AddArray(names);
  }
  return set;
}

TEST_F(TestFormatChecks, LegacyFilesOfAllKindsPass)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(3, 4, 2);
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetDimensions(2, 2, 2);
  vtkNew<vtkFloatArray> places;
  places->InsertNextValue(0);
  places->InsertNextValue(1);
  grid->SetXCoordinates(places);
  grid->SetYCoordinates(places);
  grid->SetZCoordinates(places);
  auto structured = vtkSmartPointer<vtkStructuredGrid>::New();
  structured->SetDimensions(2, 2, 2);
  auto unstructured = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> corners;
  for (int i = 0; i < 8; ++i)
    corners->InsertNextPoint(i & 1, i >> 1 & 1, i >> 2);
  structured->SetPoints(corners);
  unstructured->SetPoints(corners);
  const vtkIdType ids[] = {0, 1, 3, 2, 4, 5, 7, 6};
  unstructured->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
  vtkNew<vtkDataSetWriter> writer;
  for (const auto& set : std::initializer_list<vtkSmartPointer<vtkDataSet>>{
         sphere->GetOutput(), image, grid, structured, unstructured})
  {
    withValues<vtkDataSet>(set, true);
    writer->SetInputData(set);
    for (const int version : {42, 51})
    {
      for (const int type : {VTK_ASCII, VTK_BINARY})
      {
        const std::string file = path("a.vtk");
        writer->SetFileVersion(version);
        writer->SetFileType(type);
        writer->SetFileName(file.c_str());
        writer->Write();
        SCOPED_TRACE(std::string(set->GetClassName()) + (type == VTK_ASCII ? " text " : " bytes ") +
                     std::to_string(version));
        expectPoints(file, set->GetNumberOfPoints(), set->GetNumberOfCells());
        cutEverywhere(file, 61);
      }
    }
  }
}

const std::string legacyHead = "# vtk DataFile Version 3.0\na test\nASCII\nDATASET ";
const std::string legacyPoints = legacyHead + "POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n";

TEST_F(TestFormatChecks, LegacyFilesKeepAllArraysOfAKind)
{
  // As LIGGGHTS writes particles.
  write("a.vtk", legacyPoints +
                   "VERTICES 3 6\n1 0\n1 1\n1 2\nPOINT_DATA 3\n"
                   "SCALARS id int 1\nLOOKUP_TABLE default\n1 2 3\n"
                   "SCALARS radius double 1\nLOOKUP_TABLE default\n0.1 0.2 0.3\n"
                   "VECTORS v double\n1 0 0 2 0 0 3 0 0\n"
                   "VECTORS f double\n4 0 0 5 0 0 6 0 0\n"
                   "NORMALS n double\n1 0 0 0 1 0 0 0 1\n"
                   "NORMALS m double\n0 0 1 1 0 0 0 1 0\n"
                   "TENSORS s double\n1 2 3 4 5 6 7 8 9 1 2 3 4 5 6 7 8 9 1 2 3 4 5 6 7 8 9\n"
                   "TENSORS t double\n9 2 3 4 5 6 7 8 9 1 2 3 4 5 6 7 8 9 1 2 3 4 5 6 7 8 9\n"
                   "FIELD first 1\ne 1 3 float\n7 8 9\n"
                   "FIELD second 1\ng 1 3 float\n10 11 12\n");
  std::string error;
  const auto data =
    vtkMoteReaderTable::Read(vtkMoteReaderTable::MakeReader(path("a.vtk"), error), error);
  ASSERT_TRUE(data) << error;
  vtkPointData* const arrays = vtkPolyData::SafeDownCast(data)->GetPointData();
  const std::map<std::string, double> last = {{"id", 3}, {"radius", 0.3}, {"v", 3}, {"f", 6},
    {"n", 0}, {"m", 0}, {"s", 1}, {"t", 1}, {"e", 9}, {"g", 12}};
  EXPECT_EQ(arrays->GetNumberOfArrays(), static_cast<int>(last.size()));
  for (const auto& [name, value] : last)
  {
    ASSERT_TRUE(arrays->GetArray(name.c_str())) << name;
    EXPECT_EQ(arrays->GetArray(name.c_str())->GetComponent(2, 0), value) << name;
  }
}

TEST_F(TestFormatChecks, LegacyFilesOfLongArraysPass)
{
  constexpr std::size_t count = 12'000'000;
  const auto floats = std::string("\x3f\x80\0\0", 4); // 1, of the file's byte order
  const std::string head = "# vtk DataFile Version 3.0\na test\nBINARY\nDATASET POLYDATA\n"
                           "FIELD FieldData 1\nlong 1 " +
                           std::to_string(count) + " unsigned_char\n";
  expectPoints(write("a.vtk",
                 head + std::string(count, 'a') + "\nPOINTS 1 float\n" + floats + floats + floats),
    1, 0);
}

TEST_F(TestFormatChecks, LegacyFilesThatVTKWouldCrashOn)
{
  expectPoints(write("a.vtk", legacyPoints + "POLYGONS 1 4\n3 0 1 2\n"), 3, 1);
  expectError(write("a.vtk", legacyPoints + "POLYGONS 1 4\n3 x 1 2\n"), "found 'x'");
  expectError(write("a.vtk", legacyPoints + "POLYGONS 1 4\n4 0 1 2\n"), "do not fill the list");
  expectError(write("a.vtk", legacyPoints + "POLYGONS 2 4\n3 0 1 2\n"), "do not fill the list");
  expectError(write("a.vtk", legacyPoints + "POLYGONS 1 4\n2 0 1 2\n"), "too many");
  expectError(write("a.vtk", legacyPoints + "POLYGONS 1 9999\n3 0 1 2\n"), "truncated");
  expectError(write("a.vtk", legacyPoints + "POLY 1 4\n3 0 1 2\n"), "'poly' is no keyword");
  expectError(
    write("a.vtk", legacyPoints + "POINT_DATA 3\nSCALARS s half 1\n"), "'half' is no type");
  expectError(write("a.vtk", legacyHead + "UNDIRECTED_GRAPH\n"), "is no kind of data set");
  expectError(
    write("a.vtk", legacyHead + "STRUCTURED_POINTS\nDIMENSIONS 2000 2000 2000\nORIGIN 0 0 0\n"),
    "no room for values at 8000000000 points");
  const std::string child = "CHILD 0 [inlet]\n";
  expectError(write("a.vtk", legacyHead + "MULTIBLOCK\nCHILDREN 1\n" + child + legacyPoints +
                               "POLYGONS 1 4\n3 x 1 2\nENDCHILD\n"),
    "found 'x'");
  std::string nested = legacyHead + "MULTIBLOCK\n";
  for (int i = 0; i < 200; ++i)
    nested += "CHILD 13\n" + legacyHead + "MULTIBLOCK\n";
  expectError(write("a.vtk", nested), "100 levels deep");
}

} // namespace
