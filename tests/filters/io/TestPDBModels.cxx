// Models of a Protein Data Bank file are time steps.
#include "TableTest.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkVariant.h"

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace
{

/// The record of an atom at this place.
std::string atom(double x)
{
  char line[96];
  std::snprintf(line, sizeof line, "%-30s%8.3f%8.3f%8.3f  1.00 34.37      E    N\n",
    "ATOM      1  N   ASP E   1", x, 1.0, -2.0);
  return line;
}

class TestPDBModels : public TableTest
{
protected:
  std::vector<double> timesOf(const std::string& file)
  {
    std::string error;
    m_reader = vtkMoteReaderTable::MakeReader(file, error);
    EXPECT_EQ(error, "");
    return vtkMoteReaderTable::GetTimeSteps(m_reader, error);
  }
  /// Where the atoms of a time are.
  std::vector<double> placesAt(double time)
  {
    std::string error;
    const auto data = vtkMoteReaderTable::Read(m_reader, time, error);
    EXPECT_EQ(error, "");
    auto* points = vtkPolyData::SafeDownCast(data);
    std::vector<double> places;
    for (vtkIdType i = 0; points && i < points->GetNumberOfPoints(); ++i)
      places.push_back(points->GetPoint(i)[0]);
    return places;
  }

  vtkSmartPointer<vtkAlgorithm> m_reader;
};

using Numbers = std::vector<double>;

TEST_F(TestPDBModels, ThatAreCalledSo)
{
  const std::string text = "HEADER    A TEST\nMODEL        1\n" + atom(1) + atom(2) +
                           "TER\nENDMDL\nMODEL        2\n" + atom(3) + "ENDMDL\nMODEL        3\n" +
                           atom(4) + atom(5) + "ENDMDL\n" +
                           "MASTER        0    0    0    0    0    0    0    0    5    0\nEND\n";
  EXPECT_EQ(timesOf(write("a.pdb", text)), (Numbers{0, 1, 2}));
  EXPECT_EQ(placesAt(1), (Numbers{3}));
  EXPECT_EQ(placesAt(2), (Numbers{4, 5}));
  EXPECT_EQ(placesAt(0), (Numbers{1, 2}));
  EXPECT_EQ(placesAt(1.4), (Numbers{3}));
  EXPECT_EQ(placesAt(9), (Numbers{4, 5}));
}

TEST_F(TestPDBModels, OneAloneIsNoStep)
{
  EXPECT_EQ(timesOf(write("a.pdb", "MODEL        1\n" + atom(1) + "ENDMDL\nEND\n")), Numbers{});
  EXPECT_EQ(timesOf(write("b.pdb", atom(1) + atom(2) + "END\n\n")), Numbers{});
  std::string error;
  const auto data = vtkMoteReaderTable::Read(m_reader, error);
  EXPECT_EQ(vtkPolyData::SafeDownCast(data)->GetNumberOfPoints(), 2);
}

TEST_F(TestPDBModels, WithTheTimesOfGROMACS)
{
  const auto frame = [](const std::string& time, double x)
  {
    return "TITLE     Protein in water t= " + time +
           " step= 1\r\nCRYST1   10.000\r\nMODEL        1\n" + atom(x) + "TER\nENDMDL\n";
  };
  const std::string text = frame("10.00000", 1) + frame("12.5", 2) + frame("20", 3);
  EXPECT_EQ(timesOf(write("a.pdb", text)), (Numbers{10, 12.5, 20}));
  EXPECT_EQ(placesAt(12.5), (Numbers{2}));
  // Times that do not rise are none.
  EXPECT_EQ(
    timesOf(write("b.pdb", frame("10", 1) + frame("10", 2) + frame("20", 3))), (Numbers{0, 1, 2}));
}

TEST_F(TestPDBModels, WithoutAModelOnlyAnEnd)
{
  // As VMD writes trajectories.
  const std::string text =
    "CRYST1   10.000\n" + atom(1) + "END\n" + atom(2) + "END\n" + atom(3) + "END\n";
  EXPECT_EQ(timesOf(write("a.pdb", text)), (Numbers{0, 1, 2}));
  EXPECT_EQ(placesAt(0), (Numbers{1}));
  EXPECT_EQ(placesAt(1), (Numbers{2}));
  EXPECT_EQ(placesAt(2), (Numbers{3}));
}

TEST_F(TestPDBModels, WhatStandsBeforeThemHoldsForAll)
{
  const std::string helix =
    "HELIX    1  H1 ASP E    1  ASP E    3  1                                   3\n";
  timesOf(write("a.pdb",
    helix + "MODEL        1\n" + atom(1) + "ENDMDL\nMODEL        2\n" + atom(2) + "ENDMDL\n"));
  for (const double time : {0.0, 1.0})
  {
    std::string error;
    const auto data = vtkMoteReaderTable::Read(m_reader, time, error);
    vtkDataArray* structures =
      vtkPolyData::SafeDownCast(data)->GetPointData()->GetArray("secondary_structures");
    ASSERT_TRUE(structures);
    EXPECT_EQ(structures->GetTuple1(0), 'h') << time;
  }
}

TEST_F(TestPDBModels, AFileThatChangesIsLookedThroughAgain)
{
  const auto model = [](double x) { return "MODEL        1\n" + atom(x) + "ENDMDL\n"; };
  EXPECT_EQ(timesOf(write("a.pdb", model(1) + model(2))), (Numbers{0, 1}));
  EXPECT_EQ(placesAt(1), (Numbers{2}));
  write("a.pdb", model(1) + model(2) + model(3));
  m_reader->Modified();
  m_reader->UpdateInformation();
  EXPECT_EQ(placesAt(2), (Numbers{3}));
}

TEST_F(TestPDBModels, Packed)
{
  const auto model = [](double x) { return "MODEL        1\n" + atom(x) + "ENDMDL\n"; };
  for (const char* name : {"a.pdb.gz", "a.ent.gz", "b.pdb"})
  {
    EXPECT_EQ(timesOf(writeGzip(name, model(1) + model(2))), (Numbers{0, 1})) << name;
    EXPECT_EQ(placesAt(1), (Numbers{2})) << name;
  }
}

TEST_F(TestPDBModels, WithTheirBoxes)
{
  const auto boxAt = [&](double time)
  {
    std::string error;
    const auto data = vtkMoteReaderTable::Read(m_reader, time, error);
    vtkDataArray* box = data->GetFieldData()->GetArray("box");
    Numbers values;
    for (vtkIdType i = 0; box && i < box->GetNumberOfValues(); ++i)
      values.push_back(box->GetVariantValue(i).ToDouble());
    return values;
  };
  const auto cell =
    [](const std::string& lengths, const std::string& angles, const std::string& group)
  { return "CRYST1" + lengths + angles + " " + group + "\n"; };
  const std::string lengths = "   10.000   20.000   30.500", right = "  90.00  90.00  90.00";
  const auto frame = [&](const std::string& box)
  { return box + "MODEL        1\n" + atom(1) + "ENDMDL\n"; };
  timesOf(write("a.pdb", frame(cell(lengths, right, "P 1           1")) + frame("") +
                           frame(cell(lengths, right, "P 21 21 21    8")) +
                           frame(cell("    1.000    1.000    1.000", right, "P 1           1")) +
                           frame(cell(lengths, "  90.00  90.00  60.00", "")) +
                           frame(cell(lengths, "  60.00  60.00  60.00", "P 1")) +
                           frame(cell(lengths, "  10.00  10.00 170.00", "P 1")) +
                           frame("CRYST1   10.000\n")));
  const Numbers box = {10, 0, 0, 0, 20, 0, 0, 0, 30.5};
  EXPECT_EQ(boxAt(0), box);
  EXPECT_EQ(boxAt(1), box); // said once, it holds for all
  for (const double none : {2, 3, 6, 7})
    EXPECT_EQ(boxAt(none), Numbers{}) << none;
  Numbers skewed = boxAt(4);
  ASSERT_EQ(skewed.size(), 9u);
  EXPECT_NEAR(skewed[3], 10.0, 1e-12);
  EXPECT_NEAR(skewed[4], 10.0 * std::sqrt(3.0), 1e-12);
  EXPECT_EQ(skewed[8], 30.5);
  skewed = boxAt(5);
  ASSERT_EQ(skewed.size(), 9u);
  const double* c = &skewed[6];
  EXPECT_NEAR(c[0] * c[0] + c[1] * c[1] + c[2] * c[2], 30.5 * 30.5, 1e-9);
  EXPECT_NEAR(c[0] * skewed[0], 30.5 * 10.0 / 2.0, 1e-9);
  EXPECT_NEAR(c[0] * skewed[3] + c[1] * skewed[4], 30.5 * 20.0 / 2.0, 1e-9);
}

TEST_F(TestPDBModels, AnyThatIsDamaged)
{
  const std::string cut = atom(2).substr(0, 40) + "\n";
  expectError(
    write("a.pdb", "MODEL        1\n" + atom(1) + "ENDMDL\nMODEL        2\n" + cut + "ENDMDL\n"),
    ", line 5: the record of an atom ends after 40 columns");
  expectError(write("b.pdb", "MODEL        1\nENDMDL\nEND\n"), "no points");
  std::string same;
  for (int i = 0; i < 20000; ++i)
    same += atom(1);
  const std::string packed = writeGzip("d.pdb.gz", same);
  truncate("d.pdb.gz", 60);
  expectError(packed, "gzip data end too early");
  expectError(write("c.pdb", same), "more than 50 million bonds");
}

} // namespace
