// GROMACS, AtomEye, Gadget and HDF5 particles, and binary dumps: made here byte by byte, read whole
// and in pieces, and cut everywhere.
#include "HDF5Writer.h"
#include "ParticleFormatsTest.h"
#include "vtkMoteLAMMPSDumpReader.h"
#include "vtkMoteParticleFormatsReader.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace
{

using TestParticleFormats = ParticleFormatsTest;

const std::string gro = "Water, t= 1.5\n    3\n"
                        "    1SOL     OW    1   0.230   0.628   0.113  0.1000 -0.2000  0.3000\n"
                        "    1SOL    HW1    2   0.137   0.626   0.150  0.0000  0.0000  0.0000\n"
                        "    2SOL     OW    3  -0.230  99.628   0.113  1.0000  1.0000  1.0000\n"
                        "   1.86206   1.86206   1.86206\n"
                        "Water, t= 2.5\n    3\n"
                        "    1SOL     OW    1   1.230   0.628   0.113  0.1000 -0.2000  0.3000\n"
                        "    1SOL    HW1    2   0.137   0.626   0.150  0.0000  0.0000  0.0000\n"
                        "    2SOL     OW    3  -0.230  99.628   0.113  1.0000  1.0000  1.0000\n"
                        "   1.0 2.0 3.0 0.0 0.0 0.5 0.0 0.6 0.7\n";

TEST_F(TestParticleFormats, Gromacs)
{
  const std::string file = write("a.gro", gro);
  vtkPolyData* data = read(file, 2.5);
  ASSERT_TRUE(data);
  EXPECT_EQ(m_times, (std::vector<double>{1.5, 2.5}));
  expectPoint(data, 0, 1.230, 0.628, 0.113);
  expectPoint(data, 2, -0.230, 99.628, 0.113);
  EXPECT_EQ(value(data, "v", 0, 1), -0.2);
  EXPECT_EQ(value(data, "residue", 2), 2);
  EXPECT_EQ(value(data, "type", 0), 2); // HW1, OW
  EXPECT_EQ(value(data, "type", 1), 1);
  EXPECT_EQ(value(data, "id", 2), 3);
  const double* box =
    static_cast<double*>(data->GetFieldData()->GetArray("box")->GetVoidPointer(0));
  EXPECT_EQ(std::vector<double>(box, box + 9),
    (std::vector<double>{1, 0, 0, 0.5, 2, 0, 0.6, 0.7, 3})); // v2(x) is the sixth number
  cutAndPart<vtkMoteParticleFormatsReader>(gro, ".gro", 3, 1);
  data = read(writeGzip("a.gro.gz", gro), 1.5);
  ASSERT_TRUE(data);
  expectPoint(data, 0, 0.230, 0.628, 0.113);
  expectError(write("a.gro", "title\n2\n"), "truncated");
  expectError(write("a.gro", "title\nmany\n"), "line 2: expected the number of atoms");
  std::string wrong = gro;
  wrong.replace(wrong.find("0.628"), 5, "0.6x8");
  expectError(write("a.gro", wrong), "line 3: expected a number, found '0.6x8'");
}

/// Of more than 99,999 atoms the file's numbers begin anew, and those that are read do not. These
/// are more than are read at a time.
TEST_F(TestParticleFormats, GromacsCountsOn)
{
  std::string text = "many\n250001\n";
  for (int i = 1; i <= 250'001; ++i)
  {
    std::array<char, 64> line{};
    std::snprintf(line.data(), line.size(), "%5dSOL     OW%5d%8.3f%8.3f%8.3f\n", i % 100'000,
      i % 100'000, 0.001 * i, 0.0, 1.0);
    text += line.data();
  }
  vtkPolyData* data = read(write("many.gro", text + "1 1 1\n"));
  ASSERT_TRUE(data);
  ASSERT_EQ(data->GetNumberOfPoints(), 250'001);
  for (const int i : {100'000, 187'000, 200'000, 250'000})
  {
    EXPECT_EQ(value(data, "id", i), i + 1);
    expectPoint(data, i, 0.001 * (i + 1), 0, 1);
  }
}

TEST_F(TestParticleFormats, AtomEye)
{
  const std::string head = "Number of particles = 3\nA = 2.0 Angstrom (basic length-scale)\n"
                           "H0(1,1) = 4 A\nH0(1,2) = 1 A\nH0(1,3) = 0 A\nH0(2,1) = 0 A\n"
                           "H0(2,2) = 5 A\nH0(2,3) = 0 A\nH0(3,1) = 0 A\nH0(3,2) = 0 A\n"
                           "H0(3,3) = 6 A\n";
  const std::string extended = head + ".NO_VELOCITY.\nentry_count = 4\nauxiliary[0] = pe [eV]\n"
                                      "63.5\nCu\n0.5 0.5 0.5 -1.5\n91.2\nZr\n0 0 0 2\n1 1 1 3\n";
  vtkPolyData* data = read(write("a.cfg", extended));
  ASSERT_TRUE(data);
  expectPoint(data, 0, 4, 6, 6);
  expectPoint(data, 2, 8, 12, 12);
  EXPECT_EQ(value(data, "type", 0), 29);
  EXPECT_EQ(value(data, "type", 2), 40);
  EXPECT_EQ(value(data, "mass", 1), 91.2);
  EXPECT_EQ(value(data, "pe", 0), -1.5);
  cutAndPart<vtkMoteParticleFormatsReader>(extended, ".cfg", 3, 2);
  data = read(writeGzip("a.cfg.gz", extended));
  ASSERT_TRUE(data);
  expectPoint(data, 0, 4, 6, 6);
  const std::string standard =
    head + "R = 10\n63.5 Cu .5 .5 .5 1 0 0\n63.5 Cu 0 0 0 0 0 0\n1 H 1 1 1 0 0 1\n";
  data = read(write("b.cfg", standard));
  ASSERT_TRUE(data);
  EXPECT_EQ(value(data, "v", 0, 0), 80);
  EXPECT_EQ(value(data, "v", 0, 1), 20);
  EXPECT_EQ(value(data, "type", 2), 1);
  expectError(write("c.cfg", "nothing\n"), "this is no AtomEye file");
}

/// A snapshot of two particles of gas and one star; the gas has its own masses.
std::string gadget(bool named, bool swapped, std::uint32_t files = 1)
{
  const auto record = [&](const std::string& bytes)
  {
    const std::string length =
      bytesOf<std::uint32_t>({static_cast<std::uint32_t>(bytes.size())}, swapped);
    return length + bytes + length;
  };
  const auto block = [&](const std::string& name, const std::string& bytes)
  {
    const std::string next =
      bytesOf<std::uint32_t>({static_cast<std::uint32_t>(bytes.size() + 8)}, swapped);
    return (named ? record(name + next) : std::string()) + record(bytes);
  };
  std::string head = bytesOf<std::uint32_t>({2, 0, 0, 0, 1, 0}, swapped) +
                     bytesOf<double>({0, 0, 0, 0, 7.5, 0, 0.25, 0}, swapped) +
                     bytesOf<std::uint32_t>({0, 0, 2, 0, 0, 0, 1, 0, 0, files}, swapped) +
                     bytesOf<double>({100.0}, swapped);
  head.resize(256);
  return block("HEAD", head) + block("POS ", bytesOf<float>({1, 2, 3, 4, 5, 6, 7, 8, 9}, swapped)) +
         block("VEL ", bytesOf<float>({0, 0, 0, 1, 1, 1, -2, 0, 0}, swapped)) +
         block("ID  ", bytesOf<std::uint32_t>({11, 12, 13}, swapped)) +
         block("MASS", bytesOf<float>({0.5F, 1.5F}, swapped)) +
         block("U   ", bytesOf<float>({20, 30}, swapped)) +
         block("RHO ", bytesOf<float>({2, 3}, swapped));
}

TEST_F(TestParticleFormats, GadgetOfBothFormsAndOrders)
{
  for (const bool named : {false, true})
    for (const bool swapped : {false, true})
    {
      const std::string text = gadget(named, swapped);
      vtkPolyData* data = read(write("snapshot_000", text));
      ASSERT_TRUE(data);
      EXPECT_EQ(m_times, std::vector<double>{0.25});
      ASSERT_EQ(data->GetNumberOfPoints(), 3);
      expectPoint(data, 2, 7, 8, 9);
      EXPECT_EQ(value(data, "type", 1), 0);
      EXPECT_EQ(value(data, "type", 2), 4);
      EXPECT_EQ(value(data, "mass", 1), 1.5);
      EXPECT_EQ(value(data, "mass", 2), 7.5);
      EXPECT_EQ(value(data, "id", 2), 13);
      EXPECT_EQ(value(data, "v", 2, 0), -2);
      EXPECT_EQ(value(data, "u", 1), 30);
      EXPECT_EQ(value(data, "rho", 0), 2);
      EXPECT_TRUE(std::isnan(value(data, "u", 2)));
      cutAndPart<vtkMoteParticleFormatsReader>(text, ".gadget", 3);
      data = read(writeGzip("a.gadget.gz", text));
      ASSERT_TRUE(data);
      expectPoint(data, 0, 1, 2, 3);
    }
  std::string wrong = gadget(false, false);
  wrong[4] = 3; // particles of gas
  expectError(write("a.gadget", wrong), "does not hold");
  wrong = gadget(false, false);
  wrong[260] = 1; // behind the header
  expectError(write("a.gadget", wrong), "the lengths before and behind a block differ");
}

std::string binaryDump(bool named, bool swapped, int kind, std::int64_t step)
{
  const auto number = [&](auto value)
  { return bytesOf(std::vector<decltype(value)>{value}, swapped); };
  std::string text;
  if (named)
    text =
      number(std::int64_t{-10}) + "DUMPCUSTOM" + number(std::int32_t{1}) + number(std::int32_t{2});
  text += number(step) + number(std::int64_t{3}) + number(std::int32_t{kind});
  text += bytesOf<std::int32_t>({0, 0, 1, 1, 2, 3}, swapped);
  if (kind == 2)
    text += bytesOf<double>({10, 0, 0, 0, 10, 0, 0, 0, 10, 1, 1, 1}, swapped);
  else
    text += bytesOf<double>({0, 10, 0, 10, 0, 10}, swapped);
  if (kind == 1)
    text += bytesOf<double>({2, 0, 0}, swapped);
  text += number(std::int32_t{6});
  const std::string names = "id type xs ys zs c_pe";
  if (named)
    text += number(std::int32_t{5}) + "metal" + char(1) + number(0.5 * static_cast<double>(step)) +
            number(static_cast<std::int32_t>(names.size())) + names;
  // Two processes wrote two atoms and one.
  text += number(std::int32_t{2}) + number(std::int32_t{12}) +
          bytesOf<double>({1, 1, 0, 0, 0, -1, 2, 2, 0.5, 0.5, 0.5, -2}, swapped) +
          number(std::int32_t{6}) + bytesOf<double>({3, 1, 1, 1, 1, 3e300}, swapped);
  return text;
}

TEST_F(TestParticleFormats, BinaryDumps)
{
  for (const bool named : {true, false})
    for (const bool swapped : {false, true})
      for (const int kind : {0, 1, 2})
      {
        if (!named && (swapped || kind == 2))
          continue; // as LAMMPS of then had none
        SCOPED_TRACE(std::to_string(named) + std::to_string(swapped) + std::to_string(kind));
        const std::string text =
          binaryDump(named, swapped, kind, 4) + binaryDump(named, swapped, kind, 8);
        vtkPolyData* data = read(write("a.bin", text), 8);
        ASSERT_TRUE(data);
        EXPECT_EQ(m_times, named ? (std::vector<double>{2, 4}) : (std::vector<double>{4, 8}));
        const double origin = kind == 2 ? 1 : 0;
        // The box around a tilted cell is as wide as its tilt more.
        expectPoint(data, 1, origin + 5, origin + 5, origin + 5);
        expectPoint(data, 2, origin + 10, origin + 10, origin + 10);
        EXPECT_EQ(value(data, "type", 1), 2);
        EXPECT_EQ(value(data, "id", 2), 3);
        EXPECT_EQ(value(data, named ? "c_pe" : "column6", 1), -2);
        cutAndPart<vtkMoteLAMMPSDumpReader>(binaryDump(named, swapped, kind, 4), ".bin", 3);
      }
  // A step that is cut short leaves the one before.
  const std::string two = binaryDump(true, false, 0, 4) + binaryDump(true, false, 0, 8);
  const std::string file = write("b.bin", two.substr(0, two.size() - 1));
  const auto reader = vtkMoteReaderTable::MakeReader(file, m_error);
  ASSERT_TRUE(reader) << m_error;
  EXPECT_TRUE(vtkMoteReaderTable::Read(reader, 2, m_error)) << m_error;
  EXPECT_FALSE(vtkMoteReaderTable::Read(reader, 4, m_error));
  EXPECT_NE(m_error.find("truncated"), std::string::npos) << m_error;
}

/// Where the numbers of a named dump are, from its beginning.
TEST_F(TestParticleFormats, BinaryDumpsThatAreDamaged)
{
  const std::string whole = binaryDump(true, false, 1, 4);
  const std::size_t atoms = 34, box = 42, faces = 46, bounds = 70, columns = 142, units = 146,
                    names = 164, chunks = 189;
  const auto changed = [&](std::size_t place, auto value)
  {
    std::string text = whole;
    return text.replace(place, sizeof value, bytesOf(std::vector<decltype(value)>{value}));
  };
  using Int = std::int32_t;
  const std::vector<std::pair<std::string, std::string>> cases = {
    {changed(atoms, std::int64_t{-3}), "no room for -3 atoms"},
    {changed(atoms, std::int64_t{1} << 40), "no room for 1099511627776 atoms"},
    {changed(atoms, std::int64_t{4}), "announces 4 atoms, and has 3"},
    {changed(box, Int{3}), "no box of kind 3"}, {changed(faces, Int{4}), "no boundary of kind 4"},
    {changed(bounds, std::numeric_limits<double>::infinity()), "no finite size"},
    {changed(columns, Int{2}), "no atoms of 2 values"},
    {changed(columns, Int{5}), "names 6 of its 5 columns"},
    {changed(units, Int{-1}), "a text cannot be -1 bytes long"},
    {changed(names, Int{2'000'000}), "a text cannot be 2000000 bytes long"},
    {changed(chunks, Int{-2}), "no -2 blocks of atoms"},
    {changed(chunks + 4, Int{11}), "a block of 11 values has no whole atoms"}};
  for (const auto& [text, words] : cases)
  {
    SCOPED_TRACE(words);
    expectError(write("a.bin", text), words);
  }
}

TEST_F(TestParticleFormats, BinarySnapshotsOfSeveralFiles)
{
  for (const std::string ending : {"", ".gadget"})
  {
    for (int i = 0; i < 3; ++i) // of which the first has no names for its blocks
      write("snap_007." + std::to_string(i) + ending, gadget(i > 0, i == 2, 3));
    vtkPolyData* data = read(path("snap_007.0" + ending));
    ASSERT_TRUE(data);
    ASSERT_EQ(data->GetNumberOfPoints(), 9);
    for (int i = 0; i < 9; ++i)
    {
      expectPoint(data, i, 1 + 3 * (i % 3), 2 + 3 * (i % 3), 3 + 3 * (i % 3));
      EXPECT_EQ(value(data, "id", i), 11 + i % 3);
      EXPECT_EQ(value(data, "mass", i), i % 3 == 2 ? 7.5 : 0.5 + i % 3);
      EXPECT_EQ(value(data, "type", i), i % 3 == 2 ? 4 : 0);
      EXPECT_EQ(std::isnan(value(data, "u", i)), i % 3 == 2);
    }
    m_reader->UpdatePiece(1, 2, 0);
    auto* half = vtkPolyData::SafeDownCast(m_reader->GetOutputDataObject(0));
    ASSERT_EQ(half->GetNumberOfPoints(), 5);
    EXPECT_EQ(value(half, "id", 0), 12);
    EXPECT_EQ(value(half, "mass", 4), 7.5);
    EXPECT_EQ(read(path("snap_007.1" + ending))->GetNumberOfPoints(), 3);
    std::filesystem::remove(path("snap_007.2" + ending));
    expectError(path("snap_007.0" + ending), "snap_007.2" + ending + ": there is no such file");
    write("snap_007.2" + ending, gadget(false, false, 4));
    expectError(path("snap_007.0" + ending), "one of 3 files of a snapshot");
  }
}

TEST_F(TestParticleFormats, GadgetInHDF5)
{
  const std::string file = path("snap_001.hdf5");
  writeGadget(file);
  vtkPolyData* data = read(file);
  ASSERT_TRUE(data);
  ASSERT_EQ(data->GetNumberOfPoints(), 3);
  EXPECT_EQ(m_times, std::vector<double>{0.75});
  expectPoint(data, 1, 4, 5, 6);
  expectPoint(data, 2, 7, 8, 9);
  EXPECT_EQ(value(data, "mass", 1), 1.5);
  EXPECT_EQ(value(data, "mass", 2), 2.5);
  EXPECT_EQ(value(data, "type", 2), 1);
  auto* ids = data->GetPointData()->GetArray("id");
  ASSERT_TRUE(ids);
  EXPECT_EQ(ids->GetVariantValue(1).ToLongLong(), (1LL << 60) + 1); // to the last bit
  EXPECT_EQ(value(data, "Metallicity", 1, 0), 0.3);
  EXPECT_TRUE(std::isnan(value(data, "Metallicity", 2, 1)));
  std::ifstream stream(file, std::ios::binary);
  const std::string whole(std::istreambuf_iterator<char>(stream), {});
  for (std::size_t size = 0; size < whole.size(); size += 97)
    expectError(write("cut.hdf5", whole.substr(0, size)), size == 0 ? "empty" : "cut.hdf5");
}

TEST_F(TestParticleFormats, SnapshotsOfSeveralFiles)
{
  for (int i = 0; i < 3; ++i)
    writeGadgetShare(path("snap_007." + std::to_string(i) + ".hdf5"), 10.0 * i, 3);
  vtkPolyData* data = read(path("snap_007.0.hdf5"));
  ASSERT_TRUE(data);
  ASSERT_EQ(data->GetNumberOfPoints(), 8);
  for (int i = 0; i < 6; ++i) // gas of all files, then stars
  {
    EXPECT_EQ(value(data, "type", i), 0);
    expectPoint(data, i, 10 * (i / 2) + i % 2, 0, 0);
    EXPECT_EQ(value(data, "id", i), 10 * (i / 2) + i % 2);
  }
  expectPoint(data, 7, 20, 5, 5);
  EXPECT_EQ(value(data, "type", 7), 4);
  m_reader->UpdatePiece(1, 2, 0);
  auto* half = vtkPolyData::SafeDownCast(m_reader->GetOutputDataObject(0));
  ASSERT_EQ(half->GetNumberOfPoints(), 4);
  expectPoint(half, 0, 20, 0, 0);
  // Another one than the first is read alone; without one the first is told to lack it.
  EXPECT_EQ(read(path("snap_007.1.hdf5"))->GetNumberOfPoints(), 3);
  std::filesystem::remove(path("snap_007.2.hdf5"));
  expectError(path("snap_007.0.hdf5"), "snap_007.2.hdf5: there is no such file");
  writeGadgetShare(path("snap_007.2.hdf5"), 20, 4);
  expectError(path("snap_007.0.hdf5"), "one of 3 files of a snapshot");
}

TEST_F(TestParticleFormats, H5Part)
{
  writeH5Part(path("a.h5part"));
  vtkPolyData* data = read(path("a.h5part"), 10);
  ASSERT_TRUE(data);
  EXPECT_EQ(m_times, (std::vector<double>{0, 2, 10}));
  expectPoint(data, 0, 10.5, 10.5, 10.5);
  expectPoint(data, 1, 20, 21, 22);
  EXPECT_EQ(value(data, "p", 0, 2), 10.5);
  EXPECT_EQ(value(data, "id", 1), 4);
  EXPECT_FALSE(data->GetPointData()->HasArray("other"));
  EXPECT_FALSE(data->GetPointData()->HasArray("type"));
  {
    HDF5Writer out(path("b.h5part"));
    out.group("/Step#0");
    out.array<double>("/Step#0/x", {1, 2});
    out.array<double>("/Step#0/y", {1, 2, 3});
  }
  expectError(path("b.h5part"), "has no x, y and z");
  {
    HDF5Writer out(path("c.h5"));
    out.group("/other");
  }
  expectError(path("c.h5"), "no particles of Gadget, H5Part or openPMD");
}

TEST_F(TestParticleFormats, OpenPMD)
{
  writeOpenPMD(path("a.h5"));
  vtkPolyData* data = read(path("a.h5"));
  ASSERT_TRUE(data);
  EXPECT_EQ(m_times, std::vector<double>{2.5});
  expectPoint(data, 1, 12, 14, 0); // in the file's units, which are alike
  EXPECT_EQ(value(data, "mass", 1), 9.1e-31);
  EXPECT_EQ(value(data, "weighting", 1), 0.25);
  EXPECT_EQ(value(data, "type", 0), 1);
}

TEST_F(TestParticleFormats, SharedSamples)
{
  MOTE_REQUIRE_SHARED(galaxy, "variants/galaxy_gadget2.dat.gz");
  vtkPolyData* data = read(galaxy);
  ASSERT_TRUE(data);
  EXPECT_EQ(data->GetNumberOfPoints(), 60'000);
  EXPECT_EQ(value(data, "type", 0), 1);
  EXPECT_EQ(value(data, "type", 59'999), 2);
  MOTE_REQUIRE_SHARED(later, "variants/G2galaxy_001.hdf5");
  data = read(later);
  ASSERT_TRUE(data);
  EXPECT_EQ(data->GetNumberOfPoints(), 60'000);
  // The same particles keep their masses.
  EXPECT_NEAR(data->GetPointData()->GetArray("mass")->GetRange()[0], 0.00023252, 1e-8);
  MOTE_REQUIRE_SHARED(water, "variants/spc216.gro");
  data = read(water);
  ASSERT_TRUE(data);
  EXPECT_EQ(data->GetNumberOfPoints(), 648);
  for (vtkIdType i = 0; i < 648; i += 3) // oxygen, and hydrogen a tenth of a nanometre away
    for (vtkIdType k = 1; k < 3; ++k)
    {
      double a[3], b[3];
      data->GetPoint(i, a);
      data->GetPoint(i + k, b);
      EXPECT_NEAR(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 0.1, 0.002);
    }
  MOTE_REQUIRE_SHARED(shear, "variants/shear_void.h5part");
  ASSERT_TRUE(read(shear, 1000));
  EXPECT_EQ(m_times.size(), 5u);
  MOTE_REQUIRE_SHARED(melt, "variants/melt.unwrapped.125.cfg");
  data = read(melt);
  ASSERT_TRUE(data);
  EXPECT_EQ(data->GetNumberOfPoints(), 4000);
}

} // namespace
