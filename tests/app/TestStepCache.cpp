// Time steps that are read and built ahead on another thread are what reading and building here
// gives, and stay within their budget.

#include <base/Failure.h>
#include <stage/Input.h>
#include <stage/KeptData.h>
#include <stage/ParticlePaths.h>
#include <stage/Stage.h>
#include <stage/StepCache.h>
#include <stage/ValuesOverTime.h>

#include <gtest/gtest.h>
#include <vtkMoteMeshMapper.h>
#include <vtkMoteParticleMapper.h>
#include <vtkMoteVolumeMapper.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkVolume.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

using namespace mote::app;

namespace
{

constexpr int steps = 6;

class StepCacheTest : public testing::Test
{
protected:
  StepCacheTest()
    : folder(
        std::filesystem::temp_directory_path() /
        ("mote-step-cache-" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) +
          "-" + std::to_string(reinterpret_cast<std::uintptr_t>(this))))
  {
    std::filesystem::create_directory(folder);
  }
  ~StepCacheTest() override { std::filesystem::remove_all(folder); }

  /// A dump whose steps have 100, 101, 102... particles of three types in a row that moves.
  std::string dump(int count = 100) const
  {
    const std::string name = (folder / "run.dump").string();
    std::ofstream file(name);
    for (int step = 0; step < steps; ++step)
    {
      file << "ITEM: TIMESTEP\n"
           << 10 * step << "\nITEM: NUMBER OF ATOMS\n"
           << count + step << "\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\n"
           << "ITEM: ATOMS id type x y z\n";
      for (int i = 0; i < count + step; ++i)
        file << i + 1 << " " << 1 + i % 3 << " " << i << " " << 0.1 * step << " 0\n";
    }
    return name;
  }

  /// Two unit cubes side by side, with values that are those of the step.
  std::vector<std::string> grids() const
  {
    std::vector<std::string> names;
    for (int step = 0; step < steps; ++step)
    {
      names.push_back((folder / ("grid." + std::to_string(step) + ".vtk")).string());
      std::ofstream file(names.back());
      file << "# vtk DataFile Version 3.0\ngrid\nASCII\nDATASET UNSTRUCTURED_GRID\n"
           << "POINTS 12 double\n0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1 2 0 0 2 1 0 2 0 1 "
              "2 1 1\nCELLS 2 18\n8 0 1 2 3 4 5 6 7\n8 1 8 9 2 5 10 11 6\nCELL_TYPES 2\n12 12\n"
           << "POINT_DATA 12\nSCALARS p double 1\nLOOKUP_TABLE default\n";
      for (int i = 0; i < 12; ++i)
        file << i + 100 * step << "\n";
    }
    return names;
  }

  /// A tent of four triangles without normals, with values of the points that are those of the
  /// step; its top rises with the steps where it `moves`.
  std::vector<std::string> tents(bool moves) const
  {
    std::vector<std::string> names;
    for (int step = 0; step < steps; ++step)
    {
      names.push_back((folder / ("tent." + std::to_string(step) + ".vtk")).string());
      std::ofstream file(names.back());
      file << "# vtk DataFile Version 3.0\ntent\nASCII\nDATASET POLYDATA\nPOINTS 5 double\n"
           << "0 0 0 2 0 0 2 2 0 0 2 0 1 1 " << (moves ? 1.0 + step : 1.0) << "\n"
           << "POLYGONS 4 16\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n"
           << "POINT_DATA 5\nSCALARS q double 1\nLOOKUP_TABLE default\n";
      for (int i = 0; i < 5; ++i)
        file << i + 100 * step << "\n";
    }
    return names;
  }

  /// Shows the first step, and begins to read the others ahead.
  void begin(const std::vector<std::string>& files, std::uint64_t budget = 1'000'000'000)
  {
    settings.data.files = files;
    input = std::make_unique<Input>(files);
    input->open(progress);
    stage = std::make_unique<Stage>(settings);
    this->show(input->read(0, progress), nullptr);
    cache = std::make_shared<StepCache>(budget);
    cache->setPlace(0, 1, false);
    cache->setInput(input->again(), true);
    cache->setPlan(stage->readyPlan());
  }

  void show(const std::vector<NamedData>& data, const ReadyStep* ready)
  {
    stage->setData(data, ready);
    stage->build(progress);
    stage->applyColors();
  }

  /// Whether the step comes within a while.
  bool comes(int step) const
  {
    for (int i = 0; i < 3000 && !cache->has(step); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return cache->has(step);
  }
  /// Whether all that is wanted is there, and built, within a while.
  bool rests() const
  {
    for (int i = 0; i < 3000 && !cache->isAtRest(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return cache->isAtRest();
  }

  std::filesystem::path folder;
  Settings settings;
  ProgressRelay progress;
  std::unique_ptr<Input> input;
  std::unique_ptr<Stage> stage;
  std::shared_ptr<StepCache> cache;
};

} // namespace

TEST_F(StepCacheTest, ParticlesAreTakenAsTheyWereBuilt)
{
  this->begin({this->dump()});
  const int builds = stage->parts().front()->particles()->GetNumberOfBuilds();
  for (int step = 1; step < steps; ++step)
  {
    ASSERT_TRUE(this->comes(step)) << step;
    auto ready = cache->take(step);
    ASSERT_TRUE(ready);
    ASSERT_EQ(ready->parts.size(), 1u);
    this->show(ready->original, &*ready);
    EXPECT_EQ(stage->numberOfParticles(), 100 + step);
    double bounds[6];
    stage->bounds(bounds);
    EXPECT_NEAR(0.5 * (bounds[2] + bounds[3]), 0.1 * step, 1e-6);
    cache->setPlace(step, 1, false);
  }
  EXPECT_EQ(stage->parts().front()->particles()->GetNumberOfBuilds(), builds);
}

TEST_F(StepCacheTest, RangesStayWithTheViewAndNotWithTheStep)
{
  this->begin({this->dump()});
  ASSERT_TRUE(this->comes(1));
  const auto go = [&](int step)
  {
    cache->keep(step == 1 ? 0 : 1, stage->ready());
    ASSERT_TRUE(this->comes(step)); // what had no radius to keep is built once more
    auto ready = cache->take(step);
    ASSERT_TRUE(ready);
    this->show(ready->original, &*ready);
    cache->setPlace(step, 1, false);
  };
  settings.selection.ranges = {{"type", {{1.0, 1.0}}}, {"x", {{0.0, 50.0}}}};
  stage->apply(settings);
  go(1);
  EXPECT_EQ(stage->numberShown(), 17);
  settings.selection.ranges.clear();
  stage->apply(settings);
  go(0);
  EXPECT_EQ(stage->numberShown(), 100);
  go(1);
  EXPECT_EQ(stage->numberShown(), 101);
}

TEST_F(StepCacheTest, CalculatedArraysAreMadeAhead)
{
  settings.data.calculations = {{"twice", "2*x"}};
  settings.selection.where = "type == 2";
  settings.color.array = "twice";
  this->begin({this->dump()});
  ASSERT_TRUE(this->comes(2));
  auto ready = cache->take(2);
  ASSERT_TRUE(ready);
  ASSERT_FALSE(ready->data.empty());
  EXPECT_TRUE(findArray(ready->data.front().data, "twice"));
  this->show(ready->original, &*ready);
  EXPECT_EQ(stage->numberShown(), 34);
}

TEST_F(StepCacheTest, OtherRadiiAreBuiltAnew)
{
  this->begin({this->dump()});
  ASSERT_TRUE(this->comes(1));
  settings.particles.radius = "0.25";
  stage->apply(settings);
  stage->build(progress);
  const int builds = stage->parts().front()->particles()->GetNumberOfBuilds();
  cache->setPlan(stage->readyPlan());
  ASSERT_TRUE(this->rests());
  auto ready = cache->take(1);
  ASSERT_TRUE(ready);
  this->show(ready->original, &*ready);
  EXPECT_EQ(stage->parts().front()->particles()->GetRadiusInUse(), 0.25);
  EXPECT_EQ(stage->parts().front()->particles()->GetNumberOfBuilds(), builds);
}

TEST_F(StepCacheTest, VolumesAreTakenAsTheyWereBuilt)
{
  this->begin(this->grids());
  auto* mapper = vtkMoteVolumeMapper::SafeDownCast(
    vtkVolume::SafeDownCast(stage->parts().front()->prop())->GetMapper());
  ASSERT_TRUE(mapper);
  const int builds = mapper->GetNumberOfBuilds(), fields = mapper->GetNumberOfFieldUpdates();
  for (int step = 1; step < steps; ++step)
  {
    ASSERT_TRUE(this->comes(step)) << step;
    auto ready = cache->take(step);
    ASSERT_TRUE(ready);
    this->show(ready->original, &*ready);
    double range[2];
    mapper->GetScalarRange(range);
    EXPECT_EQ(range[0], 100.0 * step);
    EXPECT_EQ(range[1], 100.0 * step + 11.0);
    cache->setPlace(step, 1, false);
  }
  EXPECT_EQ(mapper->GetNumberOfBuilds(), builds);
  EXPECT_EQ(mapper->GetNumberOfFieldUpdates(), fields);
}

TEST_F(StepCacheTest, MeshesAreTakenAsTheyWereBuilt)
{
  for (const bool moves : {true, false})
  {
    SCOPED_TRACE(moves);
    this->begin(this->tents(moves));
    vtkMoteMeshMapper* mapper = stage->parts().front()->surface()->mapper();
    const int builds = mapper->GetNumberOfBuilds();
    std::set<const void*> structures;
    for (int step = 1; step < steps; ++step)
    {
      ASSERT_TRUE(this->comes(step)) << step;
      auto ready = cache->take(step);
      ASSERT_TRUE(ready);
      ASSERT_EQ(ready->parts.size(), 1u);
      ASSERT_TRUE(ready->parts.front().drawn) << "normals were made";
      this->show(ready->original, &*ready);
      EXPECT_EQ(mapper->GetInput(), ready->parts.front().drawn) << "normals are not made again";
      EXPECT_TRUE(mapper->GetInput()->GetPointData()->GetNormals());
      double bounds[6], range[2];
      mapper->GetBounds(bounds);
      EXPECT_NEAR(bounds[5], moves ? 1.0 + step : 1.0, 1e-6);
      mapper->GetColorArrayRange(range);
      EXPECT_EQ(range[0], 100.0 * step);
      ASSERT_EQ(mapper->GetMemory().size(), 1u);
      structures.insert(mapper->GetMemory().front().first);
      cache->setPlace(step, 1, false);
    }
    EXPECT_EQ(mapper->GetNumberOfBuilds() + mapper->GetNumberOfRefits(), builds);
    EXPECT_EQ(structures.size(), moves ? steps - 1u : 1u) << "one where nothing moves";
  }
}

TEST_F(StepCacheTest, WhatStepsShareCountsOnce)
{
  constexpr int all = 80;
  this->begin({"pump:0.002:rotor"});
  ASSERT_TRUE(this->rests());
  const auto facts = cache->facts();
  EXPECT_EQ(std::count(facts.marks.begin(), facts.marks.end(), StepCache::Mark::Here), all);
  // Each has values of its own, in two forms; the mesh and its neighbours take as much.
  const auto structure = static_cast<double>(stage->structureBytes());
  EXPECT_LT(static_cast<double>(facts.bytes), 0.65 * all * structure);
  const std::uint64_t budget = facts.bytes;
  this->begin({"pump:0.002:rotor"}, budget);
  ASSERT_TRUE(this->rests());
  EXPECT_EQ(cache->facts().marks, facts.marks) << "what counts once fits once";
}

TEST_F(StepCacheTest, BudgetHolds)
{
  const std::string file = this->dump(20000);
  this->begin({file});
  ASSERT_TRUE(this->comes(1));
  ASSERT_TRUE(this->rests());
  const std::uint64_t one = cache->facts().bytes / (steps - 1);
  this->begin({file}, 5 * one / 2); // two steps and a half
  using Mark = StepCache::Mark;
  const auto here = [&]
  {
    std::vector<int> list;
    const auto facts = cache->facts();
    EXPECT_LE(facts.bytes, facts.budget);
    for (int step = 0; step < steps; ++step)
      if (facts.marks[static_cast<std::size_t>(step)] == Mark::Here)
        list.push_back(step);
    return list;
  };
  ASSERT_TRUE(this->comes(2));
  ASSERT_TRUE(this->rests());
  EXPECT_EQ(here(), (std::vector<int>{0, 1, 2}));
  cache->setPlace(3, 1, false);
  ASSERT_TRUE(this->comes(4));
  ASSERT_TRUE(this->rests());
  EXPECT_EQ(here(), (std::vector<int>{2, 3, 4}));
  cache->setPlace(3, -1, false);
  ASSERT_TRUE(this->comes(2));
  EXPECT_EQ(cache->nearest(0), 2);
  cache->want(0); // before all others
  ASSERT_TRUE(this->comes(0));
  EXPECT_LE(cache->facts().bytes, cache->facts().budget);
}

TEST_F(StepCacheTest, StepsThatCannotBeReadAreLeftToWhoShowsThem)
{
  auto files = this->grids();
  std::ofstream(files[2]) << "# vtk DataFile Version 3.0\ngrid\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                          << "POINTS 12 double\n0 0";
  this->begin(files);
  for (const int step : {1, 3, 4, 5})
    EXPECT_TRUE(this->comes(step)) << step;
  EXPECT_FALSE(cache->has(2));
  EXPECT_FALSE(cache->take(2));
}

TEST_F(StepCacheTest, OthersNeedNotReadWhatIsThere)
{
  const std::string file = this->dump();
  this->begin({file});
  cache->keep(0, stage->ready());
  ASSERT_TRUE(this->rests());
  auto forPaths = input->again(), forValues = input->again();
  std::filesystem::remove(file);
  settings.data.calculations = {{"twice", "2*y"}};
  const ParticlePaths paths(std::move(forPaths), IdRanges({{0, 5, 5}}), settings, cache);
  const ValuesOverTime values(
    std::move(forValues), Followed{IdRanges({{0, 5, 5}}), {}}, settings, cache);
  paths.finish(progress);
  while (values.stepsRead() < steps)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  vtkNew<vtkPolyData> lines;
  paths.fill(lines, {0});
  EXPECT_EQ(lines->GetNumberOfCells(), steps - 1);
  const auto curves = values.curves("twice");
  ASSERT_EQ(curves.size(), 1u);
  for (int step = 0; step < steps; ++step)
    EXPECT_NEAR(curves.front().values[static_cast<std::size_t>(step)], 0.2 * step, 1e-5) << step;
}

TEST_F(StepCacheTest, WhatOthersReadIsKept)
{
  this->begin({this->dump()});
  const ReadyPlan plan = stage->readyPlan();
  cache = std::make_shared<StepCache>(1'000'000'000); // without a plan it reads nothing itself
  cache->setInput(input->again(), true);
  cache->setPlace(0, 1, false);
  ParticlePaths(input->again(), IdRanges({{0, 5, 5}}), settings, cache).finish(progress);
  std::filesystem::remove(settings.data.files.front());
  for (int step = 1; step < steps; ++step)
    EXPECT_TRUE(cache->has(step)) << step;
  EXPECT_FALSE(cache->original(1, 11.0)) << "of another time";
  cache->setPlan(plan);
  ASSERT_TRUE(this->rests());
  auto ready = cache->take(steps - 1);
  ASSERT_TRUE(ready);
  ASSERT_EQ(ready->parts.size(), 1u) << "and built";
  this->show(ready->original, &*ready);
  EXPECT_EQ(stage->numberOfParticles(), 100 + steps - 1);
}

TEST_F(StepCacheTest, AnInputAsksForWhatIsKeptFirst)
{
  ProgressRelay progress;
  Input input({this->dump()});
  input.open(progress);
  const std::vector<NamedData> second = input.read(1, progress);
  std::vector<int> asked;
  input.setKept(
    [&](int step) -> std::optional<std::vector<NamedData>>
    {
      asked.push_back(step);
      return step == 1 ? std::optional(second) : std::nullopt;
    });
  EXPECT_EQ(input.read(1, progress).front().data, second.front().data);
  EXPECT_EQ(input.read(2, progress).front().data->GetNumberOfPoints(), 102);
  EXPECT_EQ(asked, (std::vector<int>{1, 2}));
  input.setKept({});
  EXPECT_NE(input.read(1, progress).front().data, second.front().data);
  EXPECT_EQ(asked.size(), 2U);
}

TEST_F(StepCacheTest, DataOfNoFileAreReadByTheirNames)
{
  ProgressRelay progress;
  Input file({this->dump()});
  file.open(progress);
  const auto data = file.read(0, progress).front().data;
  std::string name;
  {
    KeptData kept;
    name = kept.keep("of a program", data);
    ASSERT_TRUE(isKeptData(name));
    Input input({name, this->dump()});
    input.open(progress);
    EXPECT_EQ(input.name(), "of a program and 1 more");
    const auto all = input.again()->read(3, progress);
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0].name, "of a program");
    EXPECT_NE(all[0].data, data) << "an object of its own";
    EXPECT_EQ(vtkPointSet::SafeDownCast(all[0].data)->GetPoints(),
      vtkPointSet::SafeDownCast(data)->GetPoints());
    EXPECT_EQ(all[1].data->GetNumberOfPoints(), 103);
  }
  EXPECT_FALSE(isKeptData(name));
  EXPECT_THROW(Input({name}), Failure);
}

TEST_F(StepCacheTest, EndsAtOnceWhateverIsUnderWay)
{
  const std::string file = this->dump(200000);
  for (const int wait : {0, 1, 5, 20, 50, 100})
  {
    this->begin({file});
    std::this_thread::sleep_for(std::chrono::milliseconds(wait));
    const auto start = std::chrono::steady_clock::now();
    cache.reset();
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 2.0);
  }
}
