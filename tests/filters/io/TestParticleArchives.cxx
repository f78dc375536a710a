// Points of Houdini, and archives of Uintah, read whole, in pieces and damaged.
#include "ParticleArchives.h"
#include "vtkMoteParticleFormatsReader.h"

#include "vtkCompositeDataIterator.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkStringArray.h"

#include <cstdint>
#include <filesystem>

using namespace samples;

namespace
{

using TestParticleArchives = ParticleFormatsTest;

TEST_F(TestParticleArchives, Bgeo)
{
  for (const std::string& file : {write("a.bgeo", bgeo()), writeGzip("b.bgeo.gz", bgeo()),
         write("c.bhclassic", bgeo()), write("any name", bgeo())})
  {
    vtkPolyData* data = read(file);
    ASSERT_TRUE(data);
    ASSERT_EQ(data->GetNumberOfPoints(), 3);
    expectPoint(data, 2, 2.0, 12.0, -0.5);
    EXPECT_EQ(value(data, "velocity", 1, 0), 0.25);
    EXPECT_EQ(value(data, "velocity", 1, 2), 2.0);
    EXPECT_EQ(data->GetPointData()->GetArray("velocity")->GetDataType(), VTK_FLOAT);
    EXPECT_EQ(value(data, "id", 2), 9.0);
    EXPECT_EQ(data->GetPointData()->GetArray("id")->GetDataType(), VTK_INT);
    auto* phase = vtkStringArray::SafeDownCast(data->GetPointData()->GetAbstractArray("phase"));
    ASSERT_TRUE(phase);
    EXPECT_EQ(phase->GetValue(0), "water");
    EXPECT_EQ(phase->GetValue(1), "oil");
    EXPECT_EQ(phase->GetValue(2), "");
  }
  cutAndPart<vtkMoteParticleFormatsReader>(bgeo(), ".bgeo", 3);
}

TEST_F(TestParticleArchives, BgeoOfOthersIsRefused)
{
  expectError(write("new.bgeo", "\x7fNSJ\x01 and more"), "have it written as .bhclassic");
  expectError(write("old.bgeo", bgeo(4)), "only 5 is read");
  expectError(write("no.bgeo", "PGEOMETRY V5"), "is no .bgeo file");
  expectError(write("many.bgeo", bgeo(5, 1 << 30)), "truncated");
  expectError(write("less.bgeo", bgeo(5, -1)), "is negative");
  std::string wide = "BgeoV" + big<std::int32_t>({5, 0, 0, 0, 0, 1, 0, 0, 0});
  wide += named("w") + big<std::uint16_t>({65535}) + big<std::int32_t>({4, 0});
  expectError(write("wide.bgeo", wide), "more values than the file has room for");
  std::string strange = bgeo();
  strange[strange.find("velocity") + 8 + 2 + 3] = 9; // its type
  expectError(write("strange.bgeo", strange), "of a type that is not known: 9");
}

TEST_F(TestParticleArchives, BgeoWithoutNamesOrWithOneTwice)
{
  std::string text = "BgeoV" + big<std::int32_t>({5, 1, 0, 0, 0, 4, 0, 0, 0});
  using namespace std::string_literals;
  for (const std::string& name : {"a"s, "a"s, ""s, "a\0b"s})
    text += named(name) + big<std::uint16_t>({1}) + big<std::int32_t>({0, 0});
  text += big<float>({1.0f, 2.0f, 3.0f, 1.0f, 4.0f, 5.0f, 6.0f, 7.0f});
  vtkPolyData* data = read(write("a.bgeo", text));
  ASSERT_TRUE(data);
  EXPECT_EQ(value(data, "a", 0), 4.0);
  EXPECT_EQ(value(data, "a_2", 0), 5.0);
  EXPECT_EQ(value(data, "_", 0), 6.0);
  EXPECT_EQ(value(data, "a_3", 0), 7.0);
}

TEST_F(TestParticleArchives, PointsOfGLTF)
{
  // Twelve bytes a point, as base64: (0, 0, 0), (1, 0, 0), (0, 2, 0).
  const std::string model =
    R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],)"
    R"("nodes": [{"mesh": 0, "translation": [10, 0, 0]}],)"
    R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 0}]}],)"
    R"("buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,)"
    R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAAEAAAAAA"}],)"
    R"("bufferViews": [{"buffer": 0, "byteLength": 36}],)"
    R"("accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}]})";
  read(write("a.gltf", model));
  std::vector<vtkPolyData*> parts;
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(m_data))
  {
    const auto iterator = vtk::TakeSmartPointer(blocks->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
      parts.push_back(vtkPolyData::SafeDownCast(iterator->GetCurrentDataObject()));
  }
  ASSERT_EQ(parts.size(), 1u);
  ASSERT_EQ(parts[0]->GetNumberOfPoints(), 3);
  EXPECT_EQ(parts[0]->GetNumberOfPolys(), 0);
  expectPoint(parts[0], 1, 11.0, 0.0, 0.0);
  expectPoint(parts[0], 2, 10.0, 2.0, 0.0);
}

TEST_F(TestParticleArchives, Uintah)
{
  for (const bool swapped : {false, true})
    for (const bool gzip : {false, true})
    {
      const Archive archive(path("a.uda.000"), swapped, gzip, swapped ? 32 : 64);
      for (const std::string& name : {archive.index(), path("a.uda.000")})
      {
        vtkPolyData* data = read(name);
        ASSERT_TRUE(data);
        EXPECT_EQ(m_times, (std::vector<double>{0.0, 0.25}));
        // Two of the second material, then one of the first and three of the second.
        ASSERT_EQ(data->GetNumberOfPoints(), 6);
        expectPoint(data, 1, 1.0, 0.0, 1.0);
        expectPoint(data, 2, 0.0, 1.0, 0.0);
        expectPoint(data, 5, 2.0, 1.0, 1.0);
        EXPECT_EQ(value(data, "material", 1), 1.0);
        EXPECT_EQ(value(data, "material", 2), 0.0);
        EXPECT_TRUE(std::isnan(value(data, "p.temperature", 0)));
        EXPECT_EQ(value(data, "p.temperature", 2), 300.0);
        EXPECT_EQ(value(data, "p.particleID", 5), double((std::int64_t{1} << 40) + 12));
        EXPECT_EQ(value(data, "p.stress", 4, 8), 8.5);
        EXPECT_FALSE(data->GetPointData()->HasArray("p.x"));
        data = read(name, 0.25);
        ASSERT_TRUE(data);
        expectPoint(data, 1, 6.0, 0.0, 1.0);
      }
    }
}

TEST_F(TestParticleArchives, UintahInPieces)
{
  for (const bool gzip : {false, true})
  {
    const Archive archive(path(gzip ? "b.uda" : "a.uda"), false, gzip);
    vtkNew<vtkMoteParticleFormatsReader> all;
    all->SetFileName(archive.index().c_str());
    all->Update();
    vtkIdType done = 0;
    for (int piece = 0; piece < 4; ++piece)
    {
      vtkNew<vtkMoteParticleFormatsReader> part;
      part->SetFileName(archive.index().c_str());
      part->UpdateInformation();
      part->UpdatePiece(piece, 4, 0);
      for (vtkIdType i = 0; i < part->GetOutput()->GetNumberOfPoints(); ++i, ++done)
      {
        EXPECT_EQ(value(part->GetOutput(), "p.particleID", i),
          value(all->GetOutput(), "p.particleID", done));
        EXPECT_EQ(part->GetOutput()->GetPoint(i)[0], all->GetOutput()->GetPoint(done)[0]);
      }
    }
    EXPECT_EQ(done, 6);
  }
}

TEST_F(TestParticleArchives, UintahThatIsDamaged)
{
  const auto damaged = [this](bool gzip, const std::string& file, const std::string& text)
  {
    const Archive archive(path("d.uda"), false, gzip);
    if (text.empty())
      std::filesystem::remove(path("d.uda/" + file));
    else
      write("d.uda/" + file, text);
    return archive.index();
  };
  expectError(path(""), "this is a directory");
  expectError(damaged(false, "t00000/timestep.xml", ""), "t00000/timestep.xml");
  expectError(damaged(false, "t00000/l0/p00001.data", ""), "there is no file");
  expectError(damaged(false, "t00000/l0/p00001.data", "short"), "it is truncated");
  expectError(damaged(false, "t00000/l0/p00001.xml", "<Uintah_Output><Variable"),
    "the file ends within '<Variable'");
  expectError(damaged(false, "t00000/timestep.xml", "<Uintah_timestep></Uintah_timestep>"),
    "names no files of data");
  expectError(damaged(true, "t00000/l0/p00001.data", std::string(2000, 'x')), "damaged");
  expectError(damaged(false, "index.xml", "<Uintah_DataArchive></Uintah_DataArchive>"),
    "lists no time steps");
  expectError(damaged(false, "index.xml",
                "<Uintah_DataArchive><outputFormat>PIDX</outputFormat></Uintah_DataArchive>"),
    "was written with PIDX");
  expectError(damaged(false, "index.xml",
                "<Uintah_DataArchive><timesteps><timestep href=\"a\" time=\"x\"/></timesteps>"
                "</Uintah_DataArchive>"),
    "its time 'x' is no number");
  const std::string variable =
    "<Uintah_Output><Variable type=\"ParticleVariable&lt;Point&gt;\"><variable>p.x</variable>"
    "<index>0</index><patch>0</patch><start>0</start><end>24</end>"
    "<filename>p00000.data</filename><numParticles>99999999999</numParticles>";
  expectError(damaged(false, "t00000/l0/p00000.xml", variable + "</Variable></Uintah_Output>"),
    "it says that 24 bytes hold 99999999999 values");
  expectError(damaged(false, "t00000/l0/p00000.xml",
                variable + "<compression>rle</compression></Variable></Uintah_Output>"),
    "compressed as 'rle'");
}

} // namespace
