// Particles of text files that go through scratch files: the same .mote files as by way of memory.
#include "VTKTestSupport.h"

#include "filters/io/IOTestSupport.h"

#include "kernels/core/ScratchSpace.h"

#include "vtkMoteParticleFileWriter.h"
#include "vtkMotePolyDataReader.h"
#include "vtkMoteReaderTable.h"

#include <cstdio>

using namespace mote::testing;

namespace
{

constexpr int atoms = 3000;

/// Lines of `pattern` with a number of its own and three coordinates each.
std::string linesOf(const std::function<std::string(int)>& before, const char* after)
{
  std::string text;
  for (int i = 0; i < atoms; ++i)
  {
    char line[160];
    std::snprintf(line, sizeof(line), "%s %.7g %.7g %.7g %s\n", before(i).c_str(),
      std::sin(0.1 * i) * 9.0, std::cos(0.37 * i) * 5.0, i * 0.01, after);
    text += line;
  }
  return text;
}

const char* elementOf(int i)
{
  static const char* const elements[] = {"O", "Cu", "H", "Xx", "Fe"};
  return elements[i * i % 5];
}

struct Streamed : FileTest
{
  std::string complaints;

  /// What a file becomes; with a budget by way of a scratch space.
  std::string convert(const std::string& name, std::optional<std::uint64_t> budget)
  {
    const std::string output = path("out.mote");
    std::string error;
    auto reader = vtkMoteReaderTable::MakeReader(name, error);
    EXPECT_TRUE(reader) << error;
    vtkNew<vtkMoteParticleMapper> mapper;
    if (budget)
    {
      const auto space = std::make_shared<mote::ScratchSpace>(output, *budget);
      vtkMotePolyDataReader::SafeDownCast(reader)->SetScratchSpace(space);
      mapper->SetScratchSpace(space);
    }
    vtkNew<vtkMoteParticleFileWriter> writer;
    Complaints said(writer);
    mapper->SetRadiusModeToType();
    mapper->SetTypeRadius(2, 0.25);
    writer->SetMapper(mapper);
    const auto data = vtkMoteReaderTable::Read(reader, error);
    EXPECT_TRUE(data) << error;
    writer->SetInputData(data);
    writer->SetFileName(output.c_str());
    EXPECT_EQ(writer->Write(), 1) << writer->GetErrorMessage();
    complaints = said.text.substr(std::min(said.text.size(), said.text.find("): ")));
    if (budget)
    {
      EXPECT_EQ(mapper->GetScratchSpace()->usesFiles(), *budget < 1000000);
    }
    std::ifstream file(output, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  }

  void expectSame(const std::string& name)
  {
    const std::string memory = this->convert(name, {});
    const std::string said = complaints;
    EXPECT_GT(memory.size(), 4096u);
    for (const std::uint64_t budget : {std::uint64_t{0}, std::uint64_t{3}, std::uint64_t{7000},
           std::uint64_t{100000}, std::uint64_t{1} << 30})
    {
      EXPECT_EQ(memory, this->convert(name, budget)) << name << ", " << budget;
      EXPECT_EQ(complaints, said);
    }
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(
                              std::filesystem::path(path("out.mote")).parent_path()),
                {}),
      2);
  }
};

} // namespace

TEST_F(Streamed, DumpWithElementsAndVectors)
{
  // A "mol" that only the second half makes a float, and a word in a column of LAMMPS's user.
  const std::string rows = linesOf(
    [](int i)
    {
      return std::to_string(i + 1) + " " + elementOf(i) + (i % 3 ? " yes " : " no ") +
             (i < 2000 ? "5" : "5.5");
    },
    "1 2.5 -3e-3");
  this->expectSame(
    this->writeGzip("a.dump.gz", dumpFrame(7, atoms, "id element flag mol x y z vx vy vz", rows)));
  EXPECT_NE(complaints.find("element, flag"), std::string::npos) << complaints;
}

TEST_F(Streamed, DumpWithTypesAndScaledCoordinates)
{
  const std::string rows =
    linesOf([](int i) { return std::to_string(1 + i % 3) + " " + elementOf(i); }, "0.125");
  this->expectSame(
    this->write("a.dump", dumpFrame(7, atoms, "type element xs ys zs c_damage", rows)));
}

TEST_F(Streamed, XYZWithElements)
{
  this->expectSame(
    this->write("a.xyz", std::to_string(atoms) + "\ncomment\n" +
                           linesOf([](int i) { return std::string(elementOf(i)); }, "1.5")));
}

TEST_F(Streamed, ExtendedXYZ)
{
  this->expectSame(this->write("a.xyz",
    std::to_string(atoms) + "\nProperties=name:S:1:species:S:2:pos:R:3:charge:R:1:n:I:1\n" +
      linesOf([](int i) { return std::string(elementOf(i)) + " a b"; }, "1.5 4")));
}

TEST_F(Streamed, ADiskThatIsFullGetsOneSentence)
{
  const std::string name = this->write("a.xyz",
    std::to_string(atoms) + "\n\n" + linesOf([](int i) { return std::string(elementOf(i)); }, ""));
  std::string error;
  auto reader = vtkMoteReaderTable::MakeReader(name, error);
  vtkMotePolyDataReader::SafeDownCast(reader)->SetScratchSpace(
    std::make_shared<mote::ScratchSpace>("/no/such/folder/b.mote", 0));
  EXPECT_FALSE(vtkMoteReaderTable::Read(reader, error));
  EXPECT_NE(error.find("/no/such/folder/b.mote"), std::string::npos) << error;
}

TEST_F(Streamed, MadeParticlesAreDrawnAndWritten)
{
  std::string error;
  auto reader = vtkMoteReaderTable::MakeReader("varied:3000", error);
  ASSERT_TRUE(reader) << error;
  auto data = vtkMoteReaderTable::Read(reader, error);
  auto* points = vtkPolyData::SafeDownCast(data);
  ASSERT_TRUE(points) << error;
  ASSERT_EQ(points->GetNumberOfPoints(), 3000);
  vtkNew<vtkPolyData> copy; // the same in memory
  copy->DeepCopy(points);
  for (const vtkIdType i : {0, 1234, 2999})
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(points->GetPoint(i)[k], copy->GetPoint(i)[k]);
  for (int k = 0; k < 6; ++k)
    EXPECT_EQ(points->GetBounds()[k], copy->GetBounds()[k]);
  EXPECT_EQ(
    vtkMoteParticleMapper::EstimateSpacing(points), vtkMoteParticleMapper::EstimateSpacing(copy));
  Stage made(points), copied(copy);
  for (Stage* stage : {&made, &copied})
  {
    stage->mapper->SetRadiusModeToSpacing();
    stage->mapper->SetCenterRange(0, 0.2, 0.7);
    stage->mapper->Update();
  }
  EXPECT_EQ(made.mapper->GetRadiusInUse(), copied.mapper->GetRadiusInUse());
  EXPECT_EQ(
    made.mapper->GetNumberOfVisibleParticles(), copied.mapper->GetNumberOfVisibleParticles());
  made.mapper->SetRadiusModeToAutomatic();
  made.mapper->Update();
  EXPECT_EQ(made.mapper->GetRadiusInUse(), 0.0); // radii of its own
  EXPECT_FALSE(vtkMoteReaderTable::Read(vtkMoteReaderTable::MakeReader("varied:x", error), error));
  EXPECT_EQ(error, "varied:x: \"x\" is not a number above zero");
}
