// What vtkMoteParticleMapper draws while a structure is built on another thread, and how that ends.
#include "VTKTestSupport.h"

#include "vtkCamera.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkMath.h"
#include "vtkMoteParticleFileWriter.h"
#include "vtkMoteParticlePicker.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <kernels/particles/ParticleSample.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sys/resource.h>
#include <thread>

using namespace mote::testing;

namespace
{

constexpr int count = 200000;
constexpr int previewed = 2000;

/// A mapper that previews particles with a value each, their index.
struct Preview : ::testing::Test
{
  vtkSmartPointer<vtkPolyData> data = makeData();
  Stage stage{data};
  vtkMoteParticleMapper* mapper = stage.mapper;

  Preview()
  {
    mapper->PreviewOn();
    mapper->SetPreviewSize(previewed);
    mapper->SetScalarRange(0, count);
  }

  static vtkSmartPointer<vtkPolyData> makeData()
  {
    std::vector<Ball> balls = someBalls(count);
    std::vector<double> values;
    for (Ball& ball : balls)
    {
      ball.r *= 0.05;
      values.push_back(double(values.size()));
    }
    auto made = makeParticles(balls);
    addValues(made, "value", values);
    return made;
  }

  /// Frames until the exact structure is there; false after a minute.
  bool waitByUpdates()
  {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (mapper->IsPreview() && std::chrono::steady_clock::now() < end)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      mapper->Update();
    }
    return !mapper->IsPreview();
  }

  /// What a mapper without a preview shows.
  Picture exact()
  {
    Stage other(data);
    other.mapper->SetScalarRange(0, count);
    other.mapper->SetRadiusScale(mapper->GetRadiusScale());
    return other.trace();
  }
};

void expectSame(const Picture& a, const Picture& b)
{
  ASSERT_EQ(a.count(), b.count());
  EXPECT_EQ(a.particles(), b.particles());
  for (int i = 0; i < a.count(); ++i)
  {
    for (int c = 0; c < 4; ++c)
      ASSERT_EQ(a.color(i)[c], b.color(i)[c]) << i;
    ASSERT_EQ(a.depth(i), b.depth(i)) << i;
  }
}

/// Counts events, and those from a thread of its own.
struct Listener
{
  int starts = 0, ends = 0, steps = 0, elsewhere = 0;
  bool abort = false;
  vtkMoteParticleMapper* mapper;
  std::thread::id thread = std::this_thread::get_id();

  explicit Listener(vtkMoteParticleMapper* m)
    : mapper(m)
  {
    m->AddObserver(vtkCommand::StartEvent, this, &Listener::note);
    m->AddObserver(vtkCommand::ProgressEvent, this, &Listener::note);
    m->AddObserver(vtkCommand::EndEvent, this, &Listener::note);
  }
  ~Listener() { mapper->RemoveAllObservers(); }
  void note(vtkObject*, unsigned long event, void*)
  {
    elsewhere += std::this_thread::get_id() != thread;
    starts += event == vtkCommand::StartEvent;
    ends += event == vtkCommand::EndEvent;
    steps += event == vtkCommand::ProgressEvent;
    if (abort && event == vtkCommand::ProgressEvent)
      mapper->SetAbortExecute(1);
  }
};

} // namespace

TEST(MapperPreview, IsOffUnlessAskedFor)
{
  vtkNew<vtkMoteParticleMapper> mapper;
  EXPECT_FALSE(mapper->GetPreview());
  mapper->SetInputData(Preview::makeData());
  mapper->SetPreviewSize(10);
  mapper->Update();
  EXPECT_FALSE(mapper->IsPreview());
  EXPECT_FALSE(mapper->IsBuilding());
  EXPECT_EQ(mapper->GetNumberOfBuilds(), 1);
  EXPECT_EQ(mapper->GetBuildProgress(), 1.0);
}

TEST_F(Preview, BecomesTheExactPicture)
{
  mapper->Update();
  ASSERT_TRUE(mapper->IsPreview());
  EXPECT_TRUE(mapper->IsBuilding());
  EXPECT_EQ(mapper->GetNumberOfPreviewParticles(), previewed);
  EXPECT_EQ(mapper->GetNumberOfParticles(), count);
  EXPECT_EQ(mapper->GetNumberOfBuilds(), 0);
  double before[6], after[6];
  mapper->GetVisibleBounds(before);
  ASSERT_TRUE(waitByUpdates());
  EXPECT_FALSE(mapper->IsBuilding());
  EXPECT_EQ(mapper->GetNumberOfPreviewParticles(), 0);
  EXPECT_EQ(mapper->GetNumberOfBuilds(), 1);
  EXPECT_EQ(mapper->GetNumberOfVisibleParticles(), count);
  mapper->GetVisibleBounds(after);
  for (int i = 0; i < 6; ++i)
    EXPECT_EQ(before[i], after[i]) << "the view would jump";
  expectSame(stage.trace(), exact());
  EXPECT_EQ(mapper->GetNumberOfBuilds(), 1);
}

TEST_F(Preview, IsForLargeSetsOnly)
{
  mapper->SetPreviewSize(count / 4);
  mapper->Update();
  EXPECT_FALSE(mapper->IsPreview());
  EXPECT_EQ(mapper->GetNumberOfBuilds(), 1);
}

TEST_F(Preview, PictureTimeChangesWithTheStructure)
{
  mapper->Update();
  const vtkMTimeType before = mapper->GetPictureMTime();
  EXPECT_EQ(mapper->GetPictureMTime(), before);
  ASSERT_TRUE(mapper->FinishBuild());
  EXPECT_GT(mapper->GetPictureMTime(), before);
}

TEST_F(Preview, IsNeverInAnImageOfTheSource)
{
  const Picture picture = stage.trace();
  EXPECT_FALSE(mapper->IsPreview());
  expectSame(picture, exact());
}

TEST_F(Preview, IsNeverWritten)
{
  const auto file = std::filesystem::temp_directory_path() / "mote-preview-test.mote";
  mapper->SetStructureName("pkd-tree");
  mapper->Update();
  ASSERT_TRUE(mapper->IsPreview());
  vtkNew<vtkMoteParticleFileWriter> writer;
  writer->SetMapper(mapper);
  writer->SetFileName(file.c_str());
  EXPECT_TRUE(writer->Write());
  EXPECT_GT(std::filesystem::file_size(file), std::uintmax_t{12} * count);
  std::filesystem::remove(file);
}

TEST_F(Preview, PicksAreParticlesOfTheInput)
{
  vtkNew<vtkGenericOpenGLRenderWindow> window; // never opened: it lends the renderer its size
  window->SetSize(100, 100);
  window->AddRenderer(stage.renderer);
  vtkDataArray* radii = data->GetPointData()->GetArray("radius");
  const double enlarged = std::cbrt(double(count) / previewed);
  vtkNew<vtkMoteParticlePicker> picker;
  int hits = 0;
  for (int i = 0; i < 500 && hits < 30; ++i)
  {
    const bool hit = picker->Pick(30 + i % 7 * 5, 30 + i % 9 * 4, 0, stage.renderer);
    if (!mapper->IsPreview()) // the build was faster
      mapper->SetRadiusScale(mapper->GetRadiusScale() * 1.0001);
    if (!hit || !mapper->IsPreview())
      continue;
    ++hits;
    const vtkIdType id = picker->GetParticleId();
    double center[3];
    data->GetPoint(id, center);
    EXPECT_NEAR(std::sqrt(vtkMath::Distance2BetweenPoints(center, picker->GetPickPosition())),
      enlarged * mapper->GetRadiusScale() * radii->GetTuple1(id), 1e-5);
    EXPECT_EQ(picker->GetValue(), double(id));
  }
  EXPECT_EQ(hits, 30);
}

TEST_F(Preview, RangesHold)
{
  mapper->AddRange("value", 0, count / 4 - 1);
  mapper->Update();
  ASSERT_TRUE(mapper->IsPreview());
  EXPECT_EQ(mapper->GetNumberOfVisibleParticles(), previewed / 4) << "one of each stretch";
  ASSERT_TRUE(mapper->FinishBuild());
  EXPECT_EQ(mapper->GetNumberOfVisibleParticles(), count / 4);
}

TEST_F(Preview, RangesOfRadiusSpeakOfTheInput)
{
  vtkDataArray* radii = data->GetPointData()->GetArray("radius");
  mote::ParticleSet set;
  set.positions =
    mote::ArrayView(static_cast<const float*>(data->GetPoints()->GetVoidPointer(0)), count, 3);
  if (data->GetPoints()->GetDataType() == VTK_DOUBLE)
    set.positions =
      mote::ArrayView(static_cast<const double*>(data->GetPoints()->GetVoidPointer(0)), count, 3);
  set.radii = mote::ArrayView(static_cast<const double*>(radii->GetVoidPointer(0)), count, 1);
  vtkIdType sampled = 0, all = 0;
  const mote::ParticleSample sample(set, previewed);
  for (const std::uint64_t i : sample.indices())
    sampled += radii->GetTuple1(static_cast<vtkIdType>(i)) >= 0.007;
  for (vtkIdType i = 0; i < count; ++i)
    all += radii->GetTuple1(i) >= 0.007;
  mapper->SetRadiusRange(0.007, HUGE_VAL);
  mapper->Update();
  ASSERT_TRUE(mapper->IsPreview());
  EXPECT_EQ(mapper->GetNumberOfVisibleParticles(), sampled);
  EXPECT_GT(sampled, 0);
  EXPECT_LT(sampled, previewed);
  ASSERT_TRUE(mapper->FinishBuild());
  EXPECT_EQ(mapper->GetNumberOfVisibleParticles(), all);
}

TEST_F(Preview, RadiusInUseIsTheExactOne)
{
  mapper->SetRadiusModeToSpacing();
  mapper->Update();
  ASSERT_TRUE(mapper->IsPreview());
  const double radius = mapper->GetRadiusInUse();
  EXPECT_GT(radius, 0.0);
  ASSERT_TRUE(mapper->FinishBuild());
  EXPECT_EQ(mapper->GetRadiusInUse(), radius);
}

TEST_F(Preview, TreesBehindItAreBuiltAsAnyOther)
{
  mapper->SetStructureName("pkd-tree");
  mapper->KeepPointIdsOff();
  mapper->PreviewOff();
  mapper->Update();
  const vtkTypeInt64 bytes = mapper->GetStructureBytes();
  mapper->PreviewOn();
  mapper->SetRadiusScale(2.0);
  mapper->Update();
  ASSERT_TRUE(mapper->IsPreview());
  ASSERT_TRUE(mapper->FinishBuild());
  EXPECT_EQ(mapper->GetStructureBytes(), bytes) << "without ids";
}

//------------------------------------------------------------------------------------------------
// How a build ends

TEST_F(Preview, EventsComeInPairsFromTheCallersThread)
{
  Listener listener(mapper);
  mapper->Update();
  EXPECT_EQ(listener.starts, 1);
  EXPECT_EQ(listener.ends, 0);
  ASSERT_TRUE(waitByUpdates());
  EXPECT_EQ(listener.ends, 1);
  EXPECT_GE(listener.steps, 1);
  mapper->SetRadiusScale(2.0);
  mapper->Update();
  mapper->StopBuild();
  EXPECT_EQ(listener.starts, 2);
  EXPECT_EQ(listener.ends, 2);
  mapper->StopBuild();
  EXPECT_EQ(listener.ends, 2);
  EXPECT_EQ(listener.elsewhere, 0);
}

TEST_F(Preview, SoDoThoseOfATreeThatIsWaitedFor)
{
  mapper->PreviewOff();
  mapper->SetStructureName("pkd-tree");
  Listener listener(mapper);
  for (int i = 1; i <= 20; ++i)
  {
    mapper->SetRadiusScale(i);
    mapper->Update();
  }
  EXPECT_EQ(listener.starts, 20);
  EXPECT_EQ(listener.ends, 20);
  EXPECT_GE(listener.steps, 20);
  EXPECT_EQ(listener.elsewhere, 0);
}

TEST_F(Preview, SwitchedOffWaits)
{
  mapper->Update();
  ASSERT_TRUE(mapper->IsPreview());
  mapper->PreviewOff();
  mapper->Update();
  EXPECT_FALSE(mapper->IsPreview());
  EXPECT_EQ(mapper->GetNumberOfBuilds(), 1);
}

TEST_F(Preview, DeletedAmidABuild)
{
  for (int i = 0; i < 10; ++i)
  {
    vtkNew<vtkMoteParticleMapper> other;
    other->SetInputData(data);
    other->PreviewOn();
    other->SetPreviewSize(previewed);
    other->Update();
    EXPECT_TRUE(other->IsPreview());
    std::this_thread::sleep_for(std::chrono::milliseconds(3 * i));
  }
}

TEST_F(Preview, OtherRadiiBeginAnew)
{
  for (int i = 0; i < 10; ++i)
  {
    mapper->SetRadiusScale(1.0 + 0.1 * i);
    mapper->Update();
    EXPECT_TRUE(mapper->IsPreview());
  }
  ASSERT_TRUE(waitByUpdates());
  EXPECT_EQ(mapper->GetNumberOfBuilds(), 1) << "the others were stopped";
  expectSame(stage.trace(), exact());
}

TEST_F(Preview, OtherInputBeginsAnew)
{
  mapper->Update();
  mapper->SetInputData(makeParticles({{0, 0, 0, 1}}));
  data = nullptr; // the build alone holds it, and must let go
  mapper->Update();
  EXPECT_FALSE(mapper->IsPreview());
  EXPECT_FALSE(mapper->IsBuilding());
  EXPECT_EQ(mapper->GetNumberOfParticles(), 1);
  mapper->SetInputData(makeData());
  mapper->Update();
  EXPECT_TRUE(mapper->IsPreview());
  mapper->RemoveAllInputConnections(0);
  mapper->Update();
  EXPECT_FALSE(mapper->IsPreview());
  EXPECT_EQ(mapper->GetNumberOfParticles(), 0);
}

TEST_F(Preview, InputOutlivesTheBuild)
{
  mapper->Update();
  vtkDataArray* array = data->GetPoints()->GetData();
  const int held = array->GetReferenceCount();
  ASSERT_TRUE(mapper->FinishBuild());
  EXPECT_EQ(array->GetReferenceCount(), held - 1);
}

TEST_F(Preview, AbortLeavesNothingAndLaterBuildsAgain)
{
  Complaints complaints(mapper);
  mapper->Update();
  {
    Listener listener(mapper);
    listener.abort = true;
    mapper->Update();
    EXPECT_EQ(listener.ends, 1);
  }
  EXPECT_FALSE(mapper->IsPreview());
  EXPECT_FALSE(mapper->IsBuilding());
  EXPECT_EQ(mapper->GetNumberOfParticles(), 0);
  mapper->Update();
  EXPECT_TRUE(mapper->IsPreview());
  {
    Listener listener(mapper);
    listener.abort = true;
    EXPECT_FALSE(mapper->FinishBuild());
  }
  ASSERT_TRUE(mapper->FinishBuild());
  EXPECT_EQ(mapper->GetNumberOfParticles(), count);
  EXPECT_EQ(complaints.errors + complaints.warnings, 0);
}

TEST_F(Preview, UnfitInputIsOneError)
{
  addValues(data, "radius", {1, 2, 3}, false);
  Complaints complaints(mapper);
  for (int i = 0; i < 3; ++i)
    mapper->Update();
  EXPECT_FALSE(mapper->IsPreview());
  EXPECT_FALSE(mapper->FinishBuild());
  EXPECT_EQ(complaints.errors, 1);
}

TEST_F(Preview, LeftOutParticlesAreCountedAtOnce)
{
  for (const vtkIdType i : {5, 77, 1234})
    data->GetPoints()->SetPoint(i, NAN, 0, 0);
  data->GetPoints()->Modified();
  Complaints complaints(mapper);
  mapper->Update();
  ASSERT_TRUE(mapper->IsPreview());
  EXPECT_EQ(mapper->GetNumberOfUnfitParticles(), 3);
  EXPECT_EQ(mapper->GetNumberOfParticles(), count - 3);
  ASSERT_TRUE(mapper->FinishBuild());
  EXPECT_EQ(mapper->GetNumberOfUnfitParticles(), 3);
  EXPECT_EQ(mapper->GetNumberOfParticles(), count - 3);
  EXPECT_EQ(complaints.warnings, 1);
}

// Sanitizers end the program where there is no memory.
#if !defined(MOTE_SANITIZE) && !defined(__SANITIZE_THREAD__)
TEST_F(Preview, StaysWhereMemoryIsShort)
{
  // Some 200 MB are asked for, and 60 there.
  constexpr vtkIdType many = 4000000;
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(many);
  for (vtkIdType i = 0; i < many; ++i)
    points->SetPoint(i, double(i % 200), double(i / 200 % 200), double(i / 40000));
  vtkNew<vtkPolyData> large;
  large->SetPoints(points);
  mapper->SetInputData(large);
  mapper->SetRadiusModeToConstant();
  mapper->ScalarVisibilityOff();
  Complaints complaints(mapper);

  rlimit limit, whole;
  getrlimit(RLIMIT_AS, &whole);
  limit = whole;
  std::ifstream("/proc/self/statm") >> limit.rlim_cur;
  limit.rlim_cur = limit.rlim_cur * 4096 + (60 << 20);
  setrlimit(RLIMIT_AS, &limit);
  mapper->Update();
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (mapper->IsBuilding() && std::chrono::steady_clock::now() < end)
    mapper->Update();
  setrlimit(RLIMIT_AS, &whole);

  EXPECT_TRUE(mapper->IsPreview());
  EXPECT_FALSE(mapper->IsBuilding());
  EXPECT_EQ(mapper->GetBuildProgress(), 0.0);
  EXPECT_EQ(complaints.errors, 1);
  EXPECT_NE(complaints.text.find("enough memory"), std::string::npos) << complaints.text;
  mapper->Update();
  EXPECT_FALSE(mapper->IsBuilding()) << "it would fail again";
  EXPECT_EQ(complaints.errors, 1);
  EXPECT_TRUE(mapper->FinishBuild()) << "there is memory now";
  EXPECT_FALSE(mapper->IsPreview());
}
#endif
