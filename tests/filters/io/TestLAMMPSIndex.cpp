#include "IOTestSupport.h"
#include "LAMMPSColumns.h"
#include "LAMMPSDump.h"

namespace
{

using mote::FileError;
using mote::indexLAMMPSDump;
using mote::LAMMPSIndex;
using mote::layoutOf;

class TestLAMMPSIndex : public FileTest
{
};

const std::string Row = "1 1 0.5 0.5 0.5\n";

TEST_F(TestLAMMPSIndex, FramesOfAFile)
{
  const std::string text = "ITEM: UNITS\nmetal\nITEM: TIME\n0.5\n" +
                           dumpFrame(5, 2, "id type x y z", Row + Row) + "ITEM: TIME\n0.75\n" +
                           dumpFrame(10, 0, "id type x y z", "") + "ITEM: TIME\n1\n" +
                           dumpFrame(15, 1, "id x y z", "1 2 3 4\n");
  for (const std::string& file : {write("a.dump", text), writeGzip("a.gz", text)})
  {
    const LAMMPSIndex index = indexLAMMPSDump(file, {});
    ASSERT_EQ(index.frames.size(), 3u);
    EXPECT_EQ(index.frames[0].timestep, 5);
    EXPECT_EQ(index.frames[0].atoms, 2u);
    EXPECT_EQ(*index.frames[1].time, 0.75);
    EXPECT_EQ(index.frames[1].atoms, 0u);
    EXPECT_EQ(index.frames[2].units, "metal");
    EXPECT_EQ(index.frames[0].columns, index.frames[1].columns); // shared
    EXPECT_EQ(index.frames[2].columns->size(), 4u);
    EXPECT_EQ(index.frames[0].box.boundary, "pp pp pp");
    EXPECT_EQ(index.frames[0].rows.line, 14u);
    EXPECT_TRUE(index.warning.empty());
  }
}

TEST_F(TestLAMMPSIndex, TriclinicBoundsAreThoseOfTheEnclosingBox)
{
  // Cell: origin (1, 2, 3), a = 10, b = (-2, 20, 0), c = (3, -4, 40).
  const std::string box = "xy xz yz pp ff ss\n-1 14 -2\n-2 22 3\n3 43 -4\n";
  const LAMMPSIndex index = indexLAMMPSDump(write("a.dump", dumpFrame(0, 0, "x y z", "", box)), {});
  const mote::LAMMPSBox& cell = index.frames[0].box;
  EXPECT_EQ(cell.origin, (std::array<double, 3>{1, 2, 3}));
  EXPECT_EQ(cell.cell[0], (std::array<double, 3>{10, 0, 0}));
  EXPECT_EQ(cell.cell[1], (std::array<double, 3>{-2, 20, 0}));
  EXPECT_EQ(cell.cell[2], (std::array<double, 3>{3, -4, 40}));
  EXPECT_EQ(cell.boundary, "pp ff ss");
}

TEST_F(TestLAMMPSIndex, DamageDoesNotHideOtherFrames)
{
  const std::string good = dumpFrame(0, 1, "id type x y z", Row);
  const std::string few = dumpFrame(1, 3, "id type x y z", Row + Row);
  const std::string many = dumpFrame(2, 1, "id type x y z", Row + Row);
  const std::string last = dumpFrame(3, 1, "id type x y z", Row);
  const LAMMPSIndex index = indexLAMMPSDump(write("a.dump", good + few + many + last), {});
  ASSERT_EQ(index.frames.size(), 4u);
  EXPECT_FALSE(index.frames[0].damage);
  ASSERT_TRUE(index.frames[1].damage);
  EXPECT_NE(std::string(index.frames[1].damage->what())
              .find("line 22: step 1 announces 3 atoms, but 'ITEM: TIMESTEP' follows after 2"),
    std::string::npos)
    << index.frames[1].damage->what();
  ASSERT_TRUE(index.frames[2].damage);
  EXPECT_NE(std::string(index.frames[2].damage->what()).find("more follow"), std::string::npos);
  EXPECT_FALSE(index.frames[3].damage);
  EXPECT_EQ(index.frames[3].timestep, 3);
}

TEST_F(TestLAMMPSIndex, ATailWithoutATimeStepIsAWarning)
{
  const std::string good = dumpFrame(0, 1, "id type x y z", Row);
  const LAMMPSIndex index = indexLAMMPSDump(write("a.dump", good + "ITEM: TIMESTEP\n"), {});
  EXPECT_EQ(index.frames.size(), 1u);
  EXPECT_NE(index.warning.find("truncated"), std::string::npos) << index.warning;
}

TEST_F(TestLAMMPSIndex, EveryTruncationIsNoticed)
{
  // Cut anywhere, the frame is damaged or the file refused, but never taken for whole.
  const std::string text = dumpFrame(0, 2, "id type x y z", Row + Row);
  for (std::size_t bytes = 0; bytes < text.size(); ++bytes)
  {
    try
    {
      const LAMMPSIndex index = indexLAMMPSDump(write("a.dump", text.substr(0, bytes)), {});
      ASSERT_EQ(index.frames.size(), 1u);
      EXPECT_TRUE(index.frames[0].damage) << "cut to " << bytes << " bytes";
    }
    catch (const FileError& error)
    {
      EXPECT_NE(error.kind(), FileError::Kind::Aborted);
    }
  }
}

TEST_F(TestLAMMPSIndex, Layouts)
{
  auto layout =
    layoutOf({"id", "xs", "y", "zsu", "xu", "vx", "vy", "vz", "c_s[1]", "c_s[2]", "fx"}, true);
  EXPECT_TRUE(layout.missing.empty());
  EXPECT_EQ(layout.coordinates[0].column, 4u); // xu before xs
  EXPECT_FALSE(layout.coordinates[0].scaled);
  EXPECT_FALSE(layout.coordinates[1].scaled);
  EXPECT_TRUE(layout.coordinates[2].scaled);
  std::string names;
  for (const auto& array : layout.arrays)
    names += array.name + ":" + std::to_string(array.columns.size()) + " ";
  EXPECT_EQ(names, "id:1 xs:1 v:3 c_s:2 fx:1 ");
  EXPECT_EQ(layoutOf({"x", "y", "z", "vx", "vy", "vz"}, false).arrays.size(), 3u);
  EXPECT_EQ(layoutOf({"x", "y", "z", "c_s[1]"}, true).arrays.at(0).name, "c_s[1]") << "one alone";
  EXPECT_EQ(layoutOf({"id", "x", "z"}, true).missing, "y");
  EXPECT_EQ(
    layoutOf({"x", "y", "z", "c_1[1]", "c_2[2]", "c_q[0]", "c_q["}, true).arrays.size(), 4u);
}

TEST_F(TestLAMMPSIndex, Types)
{
  using mote::ColumnType;
  using mote::typeOf;
  EXPECT_EQ(typeOf("id", "1"), ColumnType::Int64);
  EXPECT_EQ(typeOf("type", "1"), ColumnType::Int32);
  EXPECT_EQ(typeOf("type", "Si"), ColumnType::String);
  EXPECT_EQ(typeOf("element", "1"), ColumnType::String);
  EXPECT_EQ(typeOf("c_ke", "word"), ColumnType::Float64); // an error once it is read
  EXPECT_EQ(typeOf("label", "word"), ColumnType::String);
  EXPECT_EQ(typeOf("label", "7"), ColumnType::Float64);
}

} // namespace
