// XYZ, points and tables.
#include "IOTestSupport.h"
#include "vtkMoteDelimitedPointsReader.h"
#include "vtkMoteLAMMPSDumpReader.h"
#include "vtkMotePointsReader.h"
#include "vtkMoteReaderTable.h"
#include "vtkMoteXYZReader.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <kernels/core/ScratchSpace.h>

#include <set>

namespace
{

class TestPointReaders : public FileTest
{
protected:
  template <class Reader>
  vtkPolyData* read(Reader& reader, const std::string& file)
  {
    reader.SetFileName(file.c_str());
    m_error.clear();
    vtkMoteReaderTable::Read(&reader, m_error);
    return reader.GetOutput();
  }

  std::string m_error;
};

TEST_F(TestPointReaders, PlainXYZ)
{
  vtkNew<vtkMoteXYZReader> reader;
  vtkPolyData* data = read(*reader, write("a.xyz", "2\ncomment\nSi 1 2 3 0.5\nO 4 5 6 0.25\n"
                                                   "1\nsecond\nXx 7 8 9 1"));
  ASSERT_EQ(m_error, "");
  ASSERT_EQ(data->GetNumberOfPoints(), 2);
  EXPECT_EQ(data->GetNumberOfVerts(), 2);
  EXPECT_EQ(data->GetPoint(1)[2], 6);
  EXPECT_EQ(data->GetPointData()->GetArray("type")->GetTuple1(0), 14);
  EXPECT_EQ(data->GetPointData()->GetArray("type")->GetTuple1(1), 8);
  EXPECT_EQ(data->GetPointData()->GetArray("column5")->GetTuple1(1), 0.25);
  EXPECT_EQ(
    vtkStringArray::SafeDownCast(data->GetPointData()->GetAbstractArray("element"))->GetValue(0),
    "Si");
  EXPECT_EQ(vtkMoteReaderTable::GetTimeSteps(reader, m_error), (std::vector<double>{0, 1}));
  ASSERT_TRUE(vtkMoteReaderTable::Read(reader, 1.0, m_error)) << m_error;
  EXPECT_EQ(reader->GetOutput()->GetPoint(0)[0], 7);
  EXPECT_EQ(reader->GetOutput()->GetPointData()->GetArray("type")->GetTuple1(0), 0);
}

TEST_F(TestPointReaders, NamesThatAreNoElementsHaveTypesOfTheirOwn)
{
  // As beads of a coarse model, of which some are called as elements are.
  const std::string path =
    write("a.xyz", "5\nbeads\nP4 0 0 0\nNa 1 0 0\nC1 2 0 0\nP4 3 0 0\nQd 4 0 0\n");
  const auto typesOf = [](vtkPolyData* data)
  {
    std::vector<int> types;
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
      types.push_back(static_cast<int>(data->GetPointData()->GetArray("type")->GetTuple1(i)));
    return types;
  };
  const std::vector<int> wanted = {3, 2, 1, 3, 4};
  vtkNew<vtkMoteXYZReader> reader;
  EXPECT_EQ(typesOf(read(*reader, path)), wanted);
  // Each of several ranks, which have some of the names alone.
  std::vector<int> ofPieces;
  for (const int piece : {0, 1, 2})
  {
    reader->UpdatePiece(piece, 3, 0);
    for (const int type : typesOf(reader->GetOutput()))
      ofPieces.push_back(type);
  }
  EXPECT_EQ(ofPieces, wanted);
  EXPECT_EQ(m_error, "");
}

TEST_F(TestPointReaders, ColumnsWithoutANameGetOne)
{
  const auto names = [](vtkPolyData* data)
  {
    std::vector<std::string> all;
    for (int i = 0; i < data->GetPointData()->GetNumberOfArrays(); ++i)
      all.emplace_back(data->GetPointData()->GetArrayName(i));
    return all;
  };
  using Names = std::vector<std::string>;
  const auto table = [&](const char* text)
  {
    vtkNew<vtkMoteDelimitedPointsReader> reader;
    return names(read(*reader, write("a.csv", text)));
  };
  EXPECT_EQ(table(",x,y,z\n0,0,0,1\n1,1,1,2\n"), (Names{"column1"}));
  EXPECT_EQ(table("x,y,z,\n0,0,1,5\n1,1,2,6\n"), (Names{"column4"}));
  EXPECT_EQ(table("column2, ,x,y,z\n7,0,0,0,1\n8,1,1,1,2\n"), (Names{"column2", "column2_"}));
  vtkNew<vtkMoteXYZReader> atoms;
  EXPECT_EQ(names(read(*atoms, write("a.xyz", "1\nProperties=pos:R:3::R:1\n1 2 3 4\n"))),
    (Names{"column4"}));
  EXPECT_EQ(m_error, "");
}

TEST_F(TestPointReaders, WordsThatAreNotKeptNameTheirTypes)
{
  // In scratch space there are no words: their numbers, and a note of what these mean.
  const auto space = std::make_shared<mote::ScratchSpace>(path("beside"), 1 << 20);
  const auto noted = [](vtkPolyData* data)
  {
    std::set<std::string> all;
    auto* names =
      vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("type_names"));
    for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i)
      all.insert(names->GetValue(i));
    return all;
  };
  const std::string atoms = write("a.xyz", "3\ncomment\nSi 1 2 3\nO 4 5 6\nSi 7 8 9\n");
  vtkNew<vtkMoteXYZReader> xyz;
  EXPECT_TRUE(noted(read(*xyz, atoms)).empty()) << "the words themselves are there";
  vtkNew<vtkMoteXYZReader> streamed;
  streamed->SetScratchSpace(space);
  vtkPolyData* data = read(*streamed, atoms);
  ASSERT_EQ(m_error, "");
  EXPECT_EQ(noted(data), (std::set<std::string>{"14=Si", "8=O"}));
  EXPECT_EQ(data->GetPointData()->GetArray("type")->GetTuple1(2), 14);
  vtkNew<vtkMoteLAMMPSDumpReader> dump;
  dump->SetScratchSpace(space);
  data = read(*dump,
    write("a.dump",
      "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n3\nITEM: BOX BOUNDS ff ff ff\n0 9\n0 9\n0 9\n"
      "ITEM: ATOMS element x y z\nSi 1 2 3\nO 4 5 6\nCu 7 8 9\n"));
  ASSERT_EQ(m_error, "");
  EXPECT_EQ(noted(data), (std::set<std::string>{"1=Cu", "2=O", "3=Si"}));
  EXPECT_EQ(data->GetPointData()->GetArray("type")->GetTuple1(0), 3);
}

TEST_F(TestPointReaders, ExtendedXYZ)
{
  vtkNew<vtkMoteXYZReader> reader;
  vtkPolyData* data = read(*reader,
    writeGzip("a.xyz", "1\nLattice=\"1 0 0 0 1 0 0 0 1\" "
                       "Properties=species:S:1:force:R:3:pos:R:3:Z:I:1:fixed:L:1 energy=1\n"
                       "Si 1 2 3 4 5 6 14 T\n"));
  ASSERT_EQ(m_error, "");
  EXPECT_EQ(data->GetPoint(0)[0], 4);
  EXPECT_EQ(data->GetPointData()->GetArray("force")->GetComponent(0, 2), 3);
  EXPECT_EQ(data->GetPointData()->GetArray("Z")->GetDataType(), VTK_INT);
  EXPECT_EQ(data->GetPointData()->GetArray("type")->GetTuple1(0), 14);
  EXPECT_TRUE(data->GetPointData()->GetAbstractArray("fixed"));
}

TEST_F(TestPointReaders, BoxAndTimeOfXYZ)
{
  const std::string row = "\nCu 1 2 3\n";
  const std::string properties = " Properties=species:S:1:pos:R:3";
  vtkNew<vtkMoteXYZReader> reader;
  const auto read = [&](const std::string& comment)
  {
    reader->SetFileName(write("a.xyz", "1\n" + comment + row).c_str());
    reader->Modified();
    reader->Update();
    return reader->GetOutput()->GetFieldData();
  };
  vtkFieldData* fields = read(
    "Lattice=\"1 0 0 0.5 2 0 0 0 3\"" + properties + " Origin=\"-1 0 1\" pbc=\"T F T\" Time=7.5");
  ASSERT_TRUE(fields->GetArray("box"));
  EXPECT_EQ(fields->GetArray("box")->GetComponent(0, 3), 0.5);
  EXPECT_EQ(fields->GetArray("box_origin")->GetComponent(0, 0), -1.0);
  EXPECT_EQ(
    vtkStringArray::SafeDownCast(fields->GetAbstractArray("boundary"))->GetValue(0), "pp ff pp");
  EXPECT_EQ(reader->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 7.5);
  // Without more a box is periodic, and its corner is the origin.
  fields = read("Lattice=\"1 0 0 0 2 0 0 0 3\"" + properties);
  EXPECT_EQ(
    vtkStringArray::SafeDownCast(fields->GetAbstractArray("boundary"))->GetValue(0), "pp pp pp");
  EXPECT_EQ(fields->GetArray("box_origin")->GetComponent(0, 2), 0.0);
  // What is no box, or part of another word.
  for (const char* none : {"Lattice=\"1 0 0 0 2 0 0 0\"", "Lattice=\"1 0 0 0 2 0 0 0 x\"",
         "Lattice=\"1 0 0 0 2 0 0 0 nan\"", "Lattice=", "SubLattice=\"1 0 0 0 2 0 0 0 3\""})
    EXPECT_FALSE(read(none + properties)->GetArray("box")) << none;
}

TEST_F(TestPointReaders, BadXYZ)
{
  vtkNew<vtkMoteXYZReader> reader;
  const std::vector<std::pair<const char*, const char*>> cases = {
    {"", "bad.xyz: the file is empty"},
    {"hello\n", "line 1: expected the number of atoms of an XYZ frame, found 'hello'"},
    {"2\ncomment\nSi 1 2 3\n", "line 4: the file ends after 1 of 2 atoms"},
    {"2\n", "line 2: the file ends where a comment should follow"},
    {"1\nc\nSi 1 2\n", "line 3, column 7: expected 4 values, found only 3 ('z' is missing)"},
    {"1\nc\nSi 1 2 x\n", "line 3, column 8: expected a number for 'z', found 'x'"},
    {"1\nProperties=pos:R\nSi 1 2 3\n", "line 2: expected Properties=name:type:count"},
    {"1\nProperties=a:R:1\n1\n", "line 2: the properties have no positions"},
    {"1\nc\nSi 1 2 3\n7 8\n", "line 4: expected the number of atoms of an XYZ frame, found '7 8'"},
    {"99999999999\nc\nSi 1 2 3\n", "the file ends after 1 of 99999999999 atoms"},
  };
  for (const auto& [text, sentence] : cases)
  {
    EXPECT_EQ(read(*reader, write("bad.xyz", text))->GetNumberOfPoints(), 0) << text;
    EXPECT_NE(m_error.find(sentence), std::string::npos) << m_error;
    reader->Modified();
  }
}

TEST_F(TestPointReaders, Points)
{
  vtkNew<vtkMotePointsReader> reader;
  const std::string text = "1 2 3\n-4.5 5 6e2\n7 8 9";
  for (const std::string& file : {write("a.pts", text), writeGzip("a.pts.gz", text)})
  {
    vtkPolyData* data = read(*reader, file);
    ASSERT_EQ(m_error, "");
    ASSERT_EQ(data->GetNumberOfPoints(), 3);
    EXPECT_EQ(data->GetPoint(1)[0], -4.5);
    EXPECT_EQ(data->GetPoint(2)[2], 9);
  }
  EXPECT_EQ(read(*reader, write("b.pts", "1 2\n"))->GetNumberOfPoints(), 0);
  EXPECT_NE(m_error.find("line 1, column 4: expected 3 values, found only 2"), std::string::npos)
    << m_error;
  read(*reader, write("c.pts", ""));
  EXPECT_NE(m_error.find("the file is empty"), std::string::npos) << m_error;
}

TEST_F(TestPointReaders, Tables)
{
  vtkNew<vtkMoteDelimitedPointsReader> reader;
  vtkPolyData* data =
    read(*reader, write("a.csv", "name,X,Y,Z,mass\na,1,2,3,0.5\nb,4,5,6.5,0.25\n"));
  ASSERT_EQ(m_error, "");
  ASSERT_EQ(data->GetNumberOfPoints(), 2);
  EXPECT_EQ(data->GetPoint(1)[2], 6.5);
  EXPECT_EQ(data->GetNumberOfVerts(), 2);
  EXPECT_EQ(data->GetPointData()->GetNumberOfArrays(), 2);
  EXPECT_EQ(data->GetPointData()->GetArray("mass")->GetTuple1(1), 0.25);
  const std::vector<std::pair<const char*, const char*>> cases = {
    {"", "the file is empty"},
    {"x,y,z\n", "the table has no row below the names"},
    {"a,b\n1,2\n", "line 1: no column is named 'x'; points need columns x, y and mostly z, and "
                   "here are 'a', 'b'"},
    {"x,y,z\n1,2,3\n1,two,3\n", "line 3, column 3: expected a number for 'y', found 'two'"},
  };
  for (const auto& [text, sentence] : cases)
  {
    EXPECT_EQ(read(*reader, write("bad.csv", text))->GetNumberOfPoints(), 0) << text;
    EXPECT_NE(m_error.find(sentence), std::string::npos) << m_error;
    reader->Modified();
  }
  EXPECT_EQ(read(*reader, writeGzip("b.csv", "x,y,z\n1,2,3\n"))->GetPoint(0)[2], 3) << m_error;
}

TEST_F(TestPointReaders, TablesAsOtherProgramsWriteThem)
{
  const std::vector<std::pair<const char*, double>> cases = {
    {"x, y, z, mass\n1, 2, 3, 0.5\n", 3},
    {" X ; y;z; mass \r\n1;2;3; 0.5\r\n", 3},
    {"x\ty\tz\tmass\n1\t2\t3\t0.5\n", 3},
    {"\xEF\xBB\xBFx,y,z,mass\n1,2,3,0.5\n", 3},
    {"x,y,mass\n1,2,0.5\n", 0},
  };
  for (const auto& [text, z] : cases)
  {
    vtkNew<vtkMoteDelimitedPointsReader> reader;
    vtkPolyData* data = read(*reader, write("a.csv", text));
    ASSERT_EQ(m_error, "") << text;
    ASSERT_EQ(data->GetNumberOfPoints(), 1) << text;
    EXPECT_EQ(data->GetPoint(0)[0], 1) << text;
    EXPECT_EQ(data->GetPoint(0)[1], 2) << text;
    EXPECT_EQ(data->GetPoint(0)[2], z) << text;
    ASSERT_TRUE(data->GetPointData()->GetArray("mass")) << text;
    EXPECT_EQ(data->GetPointData()->GetArray("mass")->GetTuple1(0), 0.5) << text;
  }
  vtkNew<vtkMoteDelimitedPointsReader> reader;
  read(*reader, write("binary.csv", std::string("\x01\0\x02x,y,z\n1,2,3\n", 16)));
  EXPECT_NE(m_error.find("binary.csv: this is a binary file"), std::string::npos) << m_error;
}

} // namespace
