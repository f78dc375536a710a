// Real files of every variant. They agree with one another where they describe the same run.
#include "IOTestSupport.h"
#include "vtkMoteLAMMPSDumpReader.h"
#include "vtkMoteReaderTable.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace
{

/// A reader of one or more files, with its steps.
struct Dump
{
  explicit Dump(const std::vector<std::string>& files)
    : reader(vtkMoteReaderTable::MakeReader(files, error))
  {
    if (reader)
      times = vtkMoteReaderTable::GetTimeSteps(reader, error);
    EXPECT_EQ(error, "");
  }

  vtkPolyData* at(double time)
  {
    vtkMoteReaderTable::Read(reader, time, error);
    EXPECT_EQ(error, "");
    return vtkPolyData::SafeDownCast(reader->GetOutputDataObject(0));
  }

  std::string error;
  vtkSmartPointer<vtkAlgorithm> reader;
  std::vector<double> times;
};

using Positions = std::map<vtkIdType, std::array<double, 3>>;

/// Positions by atom id, as files may order atoms in different ways.
Positions byId(vtkPolyData* data)
{
  Positions positions;
  vtkDataArray* ids = data->GetPointData()->GetArray("id");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    data->GetPoint(i, positions[static_cast<vtkIdType>(ids->GetTuple1(i))].data());
  return positions;
}

/// The largest distance along an axis, in boxes' images if `period` is not zero.
double largestDifference(const Positions& a, const Positions& b, double period)
{
  double largest = a.size() == b.size() ? 0 : HUGE_VAL;
  for (const auto& [id, p] : a)
  {
    const auto q = b.find(id);
    for (int axis = 0; q != b.end() && axis < 3; ++axis)
    {
      double difference = p[axis] - q->second[axis];
      difference -= period > 0 ? period * std::round(difference / period) : 0;
      largest = std::max(largest, std::abs(difference));
    }
    largest = q == b.end() ? HUGE_VAL : largest;
  }
  return largest;
}

/// The cell coordinates of a position.
std::array<double, 3> fractions(vtkPolyData* data, const double* point)
{
  const double* h = static_cast<double*>(data->GetFieldData()->GetArray("box")->GetVoidPointer(0));
  const double* o =
    static_cast<double*>(data->GetFieldData()->GetArray("box_origin")->GetVoidPointer(0));
  const double z = (point[2] - o[2]) / h[8];
  const double y = (point[1] - o[1] - z * h[7]) / h[4];
  return {(point[0] - o[0] - y * h[3] - z * h[6]) / h[0], y, z};
}

void expectInsideCell(vtkPolyData* data, double slack)
{
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    for (const double s : fractions(data, data->GetPoint(i)))
    {
      ASSERT_GE(s, -slack) << "atom " << i;
      ASSERT_LE(s, 1 + slack) << "atom " << i;
    }
  }
}

constexpr double MeltBox = 16.795961913825074;

TEST(SharedDumps, VariantsOfTheMeltAgree)
{
  MOTE_REQUIRE_SHARED(plainFile, "variants/melt.atom.noscale.image.dump");
  Dump plain({plainFile});
  EXPECT_EQ(plain.times, (std::vector<double>{0, 125, 250}));
  for (const char* name : {"melt.atom.scaled.dump", "melt.custom.xs.dump", "melt.custom.xsu.dump",
         "melt.custom.units_time.dump", "melt.custom.dump.gz"})
  {
    MOTE_REQUIRE_SHARED(file, std::string("variants/") + name);
    Dump other({file});
    ASSERT_EQ(other.times.size(), 3u) << name;
    for (int step = 0; step < 3; ++step)
    {
      const Positions expected = byId(plain.at(plain.times[step]));
      const Positions found = byId(other.at(other.times[step]));
      EXPECT_EQ(found.size(), 4000u) << name;
      // Six digits of fractions and of lengths; unwrapped ones up to whole boxes.
      EXPECT_LT(largestDifference(expected, found, MeltBox), 2e-4) << name << " step " << step;
    }
  }
}

TEST(SharedDumps, ScaledUnwrappedEqualsWrappedPlusImages)
{
  MOTE_REQUIRE_SHARED(imageFile, "variants/melt.atom.noscale.image.dump");
  MOTE_REQUIRE_SHARED(unwrappedFile, "variants/melt.custom.xsu.dump");
  Dump images({imageFile});
  Dump unwrapped({unwrappedFile});
  vtkPolyData* data = images.at(250);
  Positions expected = byId(data);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    auto& position =
      expected[static_cast<vtkIdType>(data->GetPointData()->GetArray("id")->GetTuple1(i))];
    for (int axis = 0; axis < 3; ++axis)
    {
      const char* names[] = {"ix", "iy", "iz"};
      vtkDataArray* flags = data->GetPointData()->GetArray(names[axis]);
      ASSERT_EQ(flags->GetDataType(), VTK_INT);
      position[axis] += MeltBox * flags->GetTuple1(i);
    }
  }
  EXPECT_LT(largestDifference(expected, byId(unwrapped.at(250)), 0), 2e-4);
}

TEST(SharedDumps, UnitsAndTime)
{
  MOTE_REQUIRE_SHARED(file, "variants/melt.custom.units_time.dump");
  Dump dump({file});
  ASSERT_EQ(dump.times.size(), 3u);
  EXPECT_EQ(dump.times[0], 0);
  vtkFieldData* fields = dump.at(dump.times[2])->GetFieldData();
  EXPECT_EQ(fields->GetArray("timestep")->GetTuple1(0), 250);
  EXPECT_EQ(fields->GetArray("TimeValue")->GetTuple1(0), dump.times[2]);
  EXPECT_LT(dump.times[2], 250); // a time, not a step
  EXPECT_EQ(vtkStringArray::SafeDownCast(fields->GetAbstractArray("units"))->GetValue(0), "lj");
}

TEST(SharedDumps, SeriesEqualsOneFile)
{
  MOTE_REQUIRE_SHARED(first, "variants/melt.custom.perstep.000000.dump");
  MOTE_REQUIRE_SHARED(whole, "variants/melt.custom.dump.gz");
  Dump one({whole});
  const auto groups =
    vtkMoteReaderTable::GroupSeries({sharedParticles("variants/melt.custom.perstep.000250.dump"),
      first, sharedParticles("variants/melt.custom.perstep.000125.dump")});
  ASSERT_EQ(groups.size(), 1u);
  Dump series(groups[0]);
  EXPECT_EQ(series.times, one.times);
  for (const double time : one.times)
  {
    vtkPolyData* a = one.at(time);
    vtkPolyData* b = series.at(time);
    EXPECT_EQ(largestDifference(byId(a), byId(b), 0), 0);
    for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
    {
      ASSERT_EQ(a->GetPointData()->GetArray("c_ke")->GetTuple1(i),
        b->GetPointData()->GetArray("c_ke")->GetTuple1(i));
    }
  }
}

TEST(SharedDumps, NoIdNoTypeThresholdAndEmptyFrames)
{
  MOTE_REQUIRE_SHARED(bare, "variants/melt.custom.notype_noid.dump");
  MOTE_REQUIRE_SHARED(threshold, "variants/melt.custom.thresh.dump");
  MOTE_REQUIRE_SHARED(empty, "variants/melt.custom.emptyframes.dump");
  Dump nameless({bare});
  vtkPolyData* data = nameless.at(125);
  EXPECT_EQ(data->GetNumberOfPoints(), 4000);
  EXPECT_EQ(data->GetPointData()->GetNumberOfArrays(), 1);
  Dump some({threshold});
  EXPECT_EQ(some.at(0)->GetNumberOfPoints(), 2251);
  EXPECT_EQ(some.at(125)->GetNumberOfPoints(), 741);
  EXPECT_EQ(some.at(250)->GetNumberOfPoints(), 756);
  EXPECT_EQ(some.at(250)->GetNumberOfVerts(), 756);
  Dump none({empty});
  EXPECT_EQ(none.times, (std::vector<double>{0, 100}));
  EXPECT_EQ(none.at(0)->GetNumberOfPoints(), 0);
  EXPECT_EQ(none.at(100)->GetNumberOfPoints(), 4);
}

TEST(SharedDumps, TriclinicAtomsLieInTheirCell)
{
  MOTE_REQUIRE_SHARED(melt, "variants/melt.triclinic3d.custom.dump");
  MOTE_REQUIRE_SHARED(nemd, "variants/nemd.triclinic.custom.dump");
  MOTE_REQUIRE_SHARED(scaled, "variants/nemd.triclinic.atom.scaled.dump");
  MOTE_REQUIRE_SHARED(powerlaw, "powerlaw.dump.gz");
  for (const std::string& file : {melt, nemd, scaled, powerlaw})
  {
    Dump dump({file});
    for (const double time : dump.times)
    {
      // LAMMPS wraps atoms only when it rebuilds neighbour lists: some stray a little.
      expectInsideCell(dump.at(time), 0.05);
    }
  }
  Dump lengths({nemd});
  Dump parts({scaled});
  EXPECT_EQ(lengths.times.size(), 5u);
  for (const double time : lengths.times)
    EXPECT_LT(largestDifference(byId(lengths.at(time)), byId(parts.at(time)), 0), 2e-4);
}

TEST(SharedDumps, MeltCellIsTheCubeSheared)
{
  MOTE_REQUIRE_SHARED(file, "variants/melt.triclinic3d.custom.dump");
  Dump dump({file});
  vtkFieldData* fields = dump.at(0)->GetFieldData();
  vtkDataArray* box = fields->GetArray("box");
  for (const int diagonal : {0, 4, 8})
    EXPECT_NEAR(box->GetComponent(0, diagonal), MeltBox, 1e-12);
  EXPECT_NEAR(box->GetComponent(0, 3), 5.0387885741475218, 1e-14);
  EXPECT_EQ(box->GetComponent(0, 1), 0);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(fields->GetArray("box_origin")->GetComponent(0, axis), 0, 1e-12);
}

TEST(SharedDumps, Simulations)
{
  MOTE_REQUIRE_SHARED(fracture, "peri3d.00300.dump.gz");
  MOTE_REQUIRE_SHARED(pour, "pour.dump.gz");
  MOTE_REQUIRE_SHARED(shear, "shear_void.dump.gz");
  Dump series(
    {fracture, sharedParticles("peri3d.01500.dump.gz"), sharedParticles("peri3d.03000.dump.gz")});
  EXPECT_EQ(series.times, (std::vector<double>{300, 1500, 3000}));
  vtkPolyData* data = series.at(3000);
  EXPECT_EQ(data->GetNumberOfPoints(), 84270);
  double range[2];
  data->GetPointData()->GetArray("c_1")->GetRange(range);
  EXPECT_GE(range[0], 0);
  EXPECT_LE(range[1], 1);
  EXPECT_EQ(data->GetPointData()->GetArray("v")->GetNumberOfComponents(), 3);

  Dump grains({pour});
  EXPECT_EQ(grains.times.size(), 7u);
  EXPECT_EQ(grains.at(0)->GetNumberOfPoints(), 0);
  vtkIdType last = 0;
  for (const double time : grains.times)
  {
    vtkPolyData* step = grains.at(time);
    EXPECT_GE(step->GetNumberOfPoints(), last);
    last = step->GetNumberOfPoints();
  }
  EXPECT_GT(last, 0);
  EXPECT_TRUE(grains.at(1e9)->GetPointData()->HasArray("diameter"));

  Dump crystal({shear});
  EXPECT_EQ(crystal.at(0)->GetPointData()->GetArray("c_xst")->GetNumberOfComponents(), 3);
}

TEST(SharedDumps, OtherFormats)
{
  const std::map<std::string, vtkIdType> counts = {{"variants/melt.xyz", 4000},
    {"variants/SiH.extended.xyz", 101}, {"uintah_foam.pts.gz", 380892}};
  for (const auto& [name, count] : counts)
  {
    MOTE_REQUIRE_SHARED(file, name);
    Dump dump({file});
    EXPECT_EQ(dump.at(0)->GetNumberOfPoints(), count) << name;
  }
  MOTE_REQUIRE_SHARED(xyz, "variants/melt.xyz");
  MOTE_REQUIRE_SHARED(plainFile, "variants/melt.atom.noscale.image.dump");
  Dump atoms({xyz});
  EXPECT_EQ(atoms.times, (std::vector<double>{0, 125, 250}));
  EXPECT_EQ(atoms.at(125)->GetPointData()->GetArray("type")->GetTuple1(7), 1);
  MOTE_REQUIRE_SHARED(pdb, "variants/pept.pdb");
  MOTE_REQUIRE_SHARED(vtp, "variants/mixer_binary_b64_zlib.vtp");
  Dump peptide({pdb});
  EXPECT_EQ(peptide.at(0)->GetNumberOfPoints(), 107);
  Dump mesh({vtp});
  EXPECT_GT(mesh.at(0)->GetNumberOfPoints(), 100);
}

TEST(SharedDumps, ACutPDBSaysSo)
{
  MOTE_REQUIRE_SHARED(pdb, "variants/pept.pdb");
  const auto cut =
    std::filesystem::temp_directory_path() / ("mote-cut-" + std::to_string(::getpid()) + ".pdb");
  std::filesystem::copy_file(pdb, cut, std::filesystem::copy_options::overwrite_existing);
  std::filesystem::permissions(cut, std::filesystem::perms::owner_all);
  std::filesystem::resize_file(cut, std::filesystem::file_size(pdb) * 2 / 3);
  std::string error;
  auto reader = vtkMoteReaderTable::MakeReader(cut.string(), error);
  ASSERT_TRUE(reader) << error;
  EXPECT_FALSE(vtkMoteReaderTable::Read(reader, error));
  EXPECT_NE(error.find("line 72: the last line has no line end"), std::string::npos) << error;
  std::filesystem::remove(cut);
}

TEST(SharedDumps, BinaryDumpsAreThoseOfText)
{
  const std::pair<const char*, const char*> pairs[] = {
    {"melt.triclinic3d.bin", "melt.triclinic3d.custom.dump"},
    {"nemd.triclinic.custom.bin", "nemd.triclinic.custom.dump"},
    {"melt.atom.bin", "melt.atom.scaled.dump"}};
  for (const auto& [binary, text] : pairs)
  {
    MOTE_REQUIRE_SHARED(bytesFile, std::string("variants/") + binary);
    MOTE_REQUIRE_SHARED(textFile, std::string("variants/") + text);
    Dump bytes({bytesFile}), lines({textFile});
    ASSERT_EQ(bytes.times, lines.times) << binary;
    for (const double time : bytes.times)
    {
      vtkPolyData* a = bytes.at(time);
      vtkPolyData* b = lines.at(time);
      ASSERT_TRUE(a && b);
      EXPECT_LT(largestDifference(byId(a), byId(b), 0), 2e-4) << binary; // six digits of text
      EXPECT_EQ(a->GetPointData()->GetNumberOfArrays(), b->GetPointData()->GetNumberOfArrays());
    }
  }
}
} // namespace
