// LAMMPS data files, of all styles of atoms and as they are damaged.
#include "ReaderTest.h"
#include "vtkMoteLAMMPSDumpReader.h"
#include "vtkMoteReaderTable.h"

#include "vtkDataArray.h"
#include "vtkDataArraySelection.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace
{

const std::string box = "0 10 xlo xhi\n-1 19 ylo yhi\n0 40 zlo zhi\n";

std::string dataFile(int atoms, const std::string& sections, const std::string& title = "title")
{
  return title + "\n\n" + std::to_string(atoms) + " atoms\n2 atom types\n3 bonds\n" + box +
         "\nMasses\n\n1 28.0 # Si\n2 16.0\n\n" + sections;
}

using TestLAMMPSData = ReaderTest<vtkMoteLAMMPSDumpReader>;

double number(vtkPolyData* data, const char* name, vtkIdType row, int component = 0)
{
  vtkDataArray* array = data->GetPointData()->GetArray(name);
  return array ? array->GetComponent(row, component) : -999.0;
}

TEST_F(TestLAMMPSData, ColumnsOfStyles)
{
  struct Case
  {
    const char* section;
    std::vector<const char*> arrays;
    int atom = 7; ///< the place of x
  };
  const std::vector<Case> cases = {
    {"Atoms # atomic\n\n1 2 7 8 9\n", {"id", "type"}},
    {"Atoms\n\n1 2 7 8 9\n", {"id", "type"}},
    {"Atoms # atomic\n\n1 2 7 8 9 0 -1 1\n", {"id", "type", "ix", "iy", "iz"}},
    {"Atoms # charge\n\n1 2 -0.5 7 8 9\n", {"id", "type", "q"}},
    {"Atoms\n\n1 2 -0.5 7 8 9\n", {"id", "type", "q"}},
    {"Atoms\n\n1 5 2 7 8 9 # a comment\n", {"id", "mol", "type"}},
    {"Atoms  # bond\n\n1 5 2 7 8 9\n", {"id", "mol", "type"}},
    {"Atoms # full\n\n1 5 2 0.5 7 8 9 0 0 0\n", {"id", "mol", "type", "q", "ix", "iy", "iz"}},
    {"Atoms\n\n1 5 2 0.5 7 8 9\n", {"id", "mol", "type", "q"}},
    {"Atoms # sphere\n\n1 2 0.5 2600 7 8 9\n", {"id", "type", "diameter", "density"}},
    {"Atoms\n\n1 2 0.5 2600 7 8 9\n", {"id", "type", "diameter", "density"}},
    {"Atoms # dipole\n\n1 2 0 7 8 9 1 0 0\n", {"id", "type", "q", "mu"}},
    {"Atoms # hybrid sphere bond\n\n1 2 7 8 9 0.5 2600 4\n",
      {"id", "type", "column6", "column7", "column8"}},
    {"Atoms # atomic\n\n1 Si 7 8 9\n", {"id", "typelabel", "type"}},
  };
  for (const Case& one : cases)
  {
    const auto data = this->read(dataFile(1, one.section));
    ASSERT_EQ(data->GetNumberOfPoints(), 1) << one.section << m_error;
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(data->GetPoint(0)[axis], 7 + axis) << one.section;
    ASSERT_EQ(data->GetPointData()->GetNumberOfArrays(), int(one.arrays.size())) << one.section;
    for (const char* name : one.arrays)
      EXPECT_TRUE(data->GetPointData()->HasArray(name)) << one.section << name;
    EXPECT_EQ(number(data, "id", 0), 1);
  }
}

TEST_F(TestLAMMPSData, BoxTimeAndUnits)
{
  const std::string title =
    "LAMMPS data file via write_data, version 2 Aug 2023, timestep = 1500, units = metal";
  std::string text = dataFile(1, "Atoms # atomic\n\n1 2 7 8 9", title); // no line end
  text.insert(text.find("\nMasses"), "1 2 3 xy xz yz\n");
  vtkNew<vtkMoteLAMMPSDumpReader> reader;
  reader->SetFileName(write("data.melt", text).c_str());
  std::string error;
  ASSERT_EQ(vtkMoteReaderTable::GetTimeSteps(reader, error), std::vector<double>{1500});
  ASSERT_TRUE(vtkMoteReaderTable::Read(reader, error)) << error;
  vtkFieldData* fields = reader->GetOutput()->GetFieldData();
  const double cell[] = {10, 0, 0, 1, 20, 0, 2, 3, 40}, origin[] = {0, -1, 0};
  for (int i = 0; i < 9; ++i)
    EXPECT_EQ(fields->GetArray("box")->GetComponent(0, i), cell[i]) << i;
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(fields->GetArray("box_origin")->GetComponent(0, i), origin[i]);
  EXPECT_EQ(vtkStringArray::SafeDownCast(fields->GetAbstractArray("units"))->GetValue(0), "metal");
  EXPECT_TRUE(reader->CanReadFile(path("data.melt").c_str())) << "by its content";
  const auto general = this->read("t\n1 atoms\n1 2 3 avec\n4 5 6 bvec\n7 8 9 cvec\n-1 -2 -3 abc "
                                  "origin\nAtoms\n\n1 1 0 0 0\n");
  ASSERT_EQ(general->GetNumberOfPoints(), 1) << m_error;
  EXPECT_EQ(general->GetFieldData()->GetArray("box")->GetComponent(0, 5), 6);
  EXPECT_EQ(general->GetFieldData()->GetArray("box_origin")->GetComponent(0, 2), -3);
}

/// Atoms in any order, and velocities in another; of atom i (i, 0.5, -i).
std::string manyAtoms(int count, bool isSameOrder)
{
  std::mt19937 random(3);
  std::vector<int> ids;
  for (int i = 1; i <= count; ++i)
    ids.push_back(i);
  std::string atoms = "Atoms # atomic\n\n", velocities = "\nVelocities\n\n";
  std::shuffle(ids.begin(), ids.end(), random);
  for (const int id : ids)
    atoms += std::to_string(id) + " 1 " + std::to_string(id % 10) + " 2 3\n";
  if (!isSameOrder)
    std::shuffle(ids.begin(), ids.end(), random);
  for (const int id : ids)
    velocities +=
      std::to_string(id) + " " + std::to_string(id) + " 0.5 -" + std::to_string(id) + " 9 9 9\n";
  return dataFile(
    count, "Bonds\n\n1 1 1 2\n2 1 2 3\n\n" + atoms + velocities + "\nBond Coeffs\n\n1 2 3\n");
}

TEST_F(TestLAMMPSData, VelocitiesGoToTheirAtoms)
{
  for (const int count : {1, 3, 20000})
    for (const bool isSameOrder : {false, true})
      for (const int pieces : {1, 3})
      {
        const std::string text = manyAtoms(count, isSameOrder);
        const std::string file = count == 3 ? writeGzip("a.data.gz", text) : write("a.data", text);
        vtkIdType all = 0;
        for (int piece = 0; piece < pieces; ++piece)
        {
          vtkNew<vtkMoteLAMMPSDumpReader> reader;
          reader->SetFileName(file.c_str());
          reader->SetCombineVectors(piece != 1);
          reader->UpdatePiece(piece, pieces, 0);
          ASSERT_EQ(reader->GetLastErrorMessage(), "");
          vtkPolyData* data = reader->GetOutput();
          all += data->GetNumberOfPoints();
          for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
          {
            const double id = number(data, "id", i);
            ASSERT_EQ(data->GetPoint(i)[0], int(id) % 10);
            ASSERT_EQ(piece == 1 ? number(data, "vx", i) : number(data, "v", i, 0), id) << i;
            ASSERT_EQ(piece == 1 ? number(data, "vy", i) : number(data, "v", i, 1), 0.5);
            ASSERT_EQ(piece == 1 ? number(data, "vz", i) : number(data, "v", i, 2), -id);
          }
        }
        EXPECT_EQ(all, count);
      }
  // Without ids, where only velocities are wanted, and without these.
  vtkNew<vtkMoteLAMMPSDumpReader> reader;
  reader->SetFileName(write("b.data", manyAtoms(5, false)).c_str());
  reader->UpdateInformation();
  reader->GetPointDataArraySelection()->DisableArray("id");
  reader->Update();
  EXPECT_FALSE(reader->GetOutput()->GetPointData()->HasArray("id"));
  ASSERT_TRUE(reader->GetOutput()->GetPointData()->HasArray("v"));
  EXPECT_EQ(number(reader->GetOutput(), "v", 2, 1), 0.5);
  reader->GetPointDataArraySelection()->DisableArray("v");
  reader->Update();
  EXPECT_FALSE(reader->GetOutput()->GetPointData()->HasArray("v"));
}

TEST_F(TestLAMMPSData, ErrorsAreSentences)
{
  expectError(
    dataFile(2, "Atoms\n\n1 1 7 8 9\n"), "announces 2 atoms, but ends after 1: it is truncated");
  expectError(dataFile(1, "Atoms\n\n1 1 7 8 9\n2 1 7 8 9\n"), "but more follow: '2 1 7 8 9'");
  expectError(dataFile(1, "Bonds\n\n1 1 1 1\n"), "no section 'Atoms'");
  expectError(dataFile(1, "Atoms # wavepacket\n\n1 1 7 8 9\n"), "style 'wavepacket' are not read");
  expectError(dataFile(1, "Atoms # full\n\n1 1 7 8 9\n"),
    "atoms of style 'full' have 7 or 10 values, and here are 5");
  expectError(dataFile(1, "Atoms\n\n1 1 7 8\n"), "lines of 4 values need the atom style");
  expectError(dataFile(1, "Atoms\n\n1 1 7 8 nine\n"), "expected a number for 'z', found 'nine'");
  expectError(dataFile(1, "Atoms\n\n1 1 7 8 9\n\nVelocities\n\n2 0 0 0\n"),
    "a velocity of atom 2, but no such atom");
  expectError(dataFile(1, "Atoms\n\n1 1 7 8 9\n\nVelocities\n\n1.5 0 0 0\n"), "no integer");
  expectError(dataFile(1, "Atoms\n\n1 1 7 8 9\n\nVelocities\n\n1 0 0\n"),
    "velocities have 4 values or more, and here are 3");
  expectError(dataFile(1, "Atoms\n\n1.5 1 7 8 9\n\nVelocities\n\n1 0 0 0\n"), "no integer");
  EXPECT_EQ(this
              ->read(dataFile(2, "Atoms\n\n9223372036854775807 1 7 8 9\n-9223372036854775807 1 "
                                 "1 2 3\n\nVelocities\n\n-9223372036854775807 4 0 "
                                 "0\n9223372036854775807 5 0 0\n"))
              ->GetNumberOfPoints(),
    2)
    << m_error;
  expectError("t\n1 atoms\n0 wide xlo xhi\nAtoms\n\n1 1 1 1 1\n",
    "line 3: expected a number for the box, found 'wide'");
  expectError("t\n-1 atoms\nAtoms\n\n1 1 1 1 1\n", "expected the number of atoms, found '-1'");
  EXPECT_EQ(this->read("t\n0 atoms\nAtoms\n\n")->GetNumberOfPoints(), 0);
  EXPECT_EQ(m_error, "");
  expectError("t\n999999999999 atoms\nAtoms\n\n1 1 1 1 1\n", "it is truncated");
}

TEST_F(TestLAMMPSData, CutAtEveryByte)
{
  const std::string text = manyAtoms(4, false);
  for (std::size_t bytes = 0; bytes < text.size(); ++bytes)
  {
    const auto data = this->read(text.substr(0, bytes));
    ASSERT_EQ(data->GetNumberOfPoints(), m_error.empty() ? 4 : 0) << bytes << m_error;
    ASSERT_EQ(m_error.find('\n'), std::string::npos) << m_error;
  }
}

} // namespace
