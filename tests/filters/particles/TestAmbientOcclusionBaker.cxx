// vtkMoteAmbientOcclusionBaker: what is baked, kept, saved, and used by a mapper.
#include "rendering/vtk/VTKTestSupport.h"

#include "vtkCallbackCommand.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMoteAmbientOcclusionBaker.h"
#include "vtkMoteShading.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <unistd.h>

using namespace mote::testing;

namespace
{

constexpr int notBaked = 15;

/// A filter with a small job over some balls.
struct Job
{
  std::vector<Ball> balls = someBalls(120);
  vtkSmartPointer<vtkPolyData> data = makeParticles(balls);
  vtkNew<vtkMoteAmbientOcclusionBaker> baker;

  Job()
  {
    baker->SetInputData(data);
    baker->SetSide(8);
    baker->SetSamples(8);
    baker->SetReach(0.5);
  }

  std::vector<int> levels()
  {
    baker->Update();
    std::vector<int> all;
    auto* array = vtkUnsignedCharArray::SafeDownCast(
      baker->GetOutput()->GetFieldData()->GetArray("MoteOcclusionLevels"));
    for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
      all.push_back(array->GetValue(i));
    return all;
  }
  std::vector<int> texels()
  {
    std::vector<int> all;
    auto* array = vtkUnsignedCharArray::SafeDownCast(
      baker->GetOutput()->GetFieldData()->GetArray("MoteOcclusionTexels"));
    for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
      all.push_back(array->GetValue(i));
    return all;
  }
};

/// A file that is not there before the test, nor after.
struct TemporaryFile
{
  std::string name = (std::filesystem::temp_directory_path() /
                      ("mote-baker-" + std::to_string(::getpid()) + ".moteao"))
                       .string();
  TemporaryFile() { std::filesystem::remove(name); }
  ~TemporaryFile() { std::filesystem::remove(name); }
};

/// What red is where ambient light is all there is.
Picture ambientPicture(vtkPolyData* data, int occlusion, double radiusScale = 1.0)
{
  Stage stage(data);
  stage.mapper->SetRadiusScale(radiusScale);
  stage.mapper->ScalarVisibilityOff();
  stage.actor->GetProperty()->SetAmbient(1.0);
  stage.actor->GetProperty()->SetDiffuse(0.0);
  vtkNew<vtkMoteRendererSource> source;
  source->SetRenderer(stage.renderer);
  source->SetSize(64, 64);
  source->SetSamplesPerPixel(4);
  source->TransparentBackgroundOn();
  source->DepthOn();
  source->GetShading()->SetAmbientOcclusionSamples(64);
  source->GetShading()->SetAmbientOcclusion(occlusion);
  source->GetShading()->SetAmbientOcclusionReach(0.5);
  source->Update();
  return {64, 64, source->GetOutput()};
}

double rmsOf(const Picture& a, const Picture& b)
{
  double sum = 0.0;
  for (int i = 0; i < a.count(); ++i)
    sum += std::pow(a.color(i)[0] - b.color(i)[0], 2.0);
  return std::sqrt(sum / a.covered());
}

} // namespace

TEST(AmbientOcclusionBaker, BakesAllAndLeavesTheInputAlone)
{
  Job job;
  const vtkMTimeType before = job.data->GetMTime();
  const std::vector<int> levels = job.levels();
  ASSERT_EQ(levels.size(), 120u);
  for (const int level : levels)
    EXPECT_NE(level, notBaked);
  EXPECT_EQ(job.data->GetMTime(), before);
  EXPECT_EQ(job.data->GetFieldData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(job.baker->GetOutput()->GetNumberOfPoints(), 120);
  EXPECT_NE(job.baker->GetOutput()->GetPointData()->GetArray("radius"), nullptr);
  EXPECT_EQ(job.baker->GetNumberOfBaked(), 120);
  EXPECT_EQ(job.baker->GetNumberOfNewlyBaked(), 120);
  EXPECT_GT(job.baker->GetNumberOfRays(), 0);
  EXPECT_GT(job.baker->GetBytesPerParticle(), 1.0);
  EXPECT_EQ(job.baker->GetRemainingTime(), 0.0);
}

TEST(AmbientOcclusionBaker, MapperLightsByItsMaps)
{
  Job job;
  job.baker->SetSide(16);
  job.baker->SetSamples(49);
  job.baker->Update();
  const Picture live = ambientPicture(job.data, vtkMoteShading::OCCLUSION_LIVE);
  const Picture none = ambientPicture(job.data, vtkMoteShading::OCCLUSION_NONE);
  EXPECT_GT(rmsOf(live, none), 0.1);
  EXPECT_LT(
    rmsOf(ambientPicture(job.baker->GetOutput(), vtkMoteShading::OCCLUSION_BAKED), live), 0.03);
  // And really by them: maps of a dark sky make it dark.
  job.baker->SetSkyTop(0.25);
  job.baker->SetSkyBottom(0.25);
  job.baker->Update();
  const Picture dark = ambientPicture(job.baker->GetOutput(), vtkMoteShading::OCCLUSION_BAKED);
  for (int i = 0; i < dark.count(); ++i)
    EXPECT_LE(dark.color(i)[0], 0.2501f);
}

TEST(AmbientOcclusionBaker, MapsOfOtherParticlesAreRefused)
{
  Job job;
  job.baker->SetSkyTop(0.1);
  job.baker->SetSkyBottom(0.1);
  job.baker->Update();
  vtkNew<vtkPolyData> other;
  other->ShallowCopy(makeParticles(someBalls(120, 2)));
  other->GetFieldData()->ShallowCopy(job.baker->GetOutput()->GetFieldData());
  const Picture live = ambientPicture(other, vtkMoteShading::OCCLUSION_LIVE);
  vtkObject::GlobalWarningDisplayOff();
  EXPECT_LT(rmsOf(ambientPicture(other, vtkMoteShading::OCCLUSION_BAKED), live), 0.05);
  // Nor those of other radii.
  EXPECT_LT(rmsOf(ambientPicture(job.baker->GetOutput(), vtkMoteShading::OCCLUSION_BAKED, 0.9),
              ambientPicture(job.data, vtkMoteShading::OCCLUSION_LIVE, 0.9)),
    0.05);
  vtkObject::GlobalWarningDisplayOn();

  Stage stage(other);
  vtkNew<vtkMoteRendererSource> source;
  source->SetRenderer(stage.renderer);
  source->SetSize(8, 8);
  source->SetSamplesPerPixel(1);
  source->GetShading()->SetAmbientOcclusionToBaked();
  Complaints complaints(stage.mapper);
  source->Update();
  EXPECT_EQ(complaints.warnings, 1);
  EXPECT_NE(complaints.text.find("other particles or other radii"), std::string::npos);
  source->Modified();
  source->Update();
  EXPECT_EQ(complaints.warnings, 1) << "told once";
}

TEST(AmbientOcclusionBaker, HiddenParticlesNeitherOccludeNorAreBaked)
{
  Job job;
  std::vector<double> x;
  for (const Ball& ball : job.balls)
    x.push_back(ball.x);
  addValues(job.data, "x", x, false);
  job.baker->SetSelectionArrayName("x");
  job.baker->SetSelectionRange(-2.0, 0.0);
  const std::vector<int> levels = job.levels();
  std::vector<Ball> left;
  std::vector<int> leftLevels;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    EXPECT_EQ(levels[i] == notBaked, x[i] > 0.0) << i;
    if (x[i] <= 0.0)
    {
      left.push_back(job.balls[i]);
      leftLevels.push_back(levels[i]);
    }
  }
  // The same as if they were not there, but for the numbers that rays are spread by.
  Job without;
  without.baker->SetInputData(makeParticles(left));
  const std::vector<int> alone = without.levels();
  ASSERT_EQ(alone.size(), leftLevels.size());
  int dark[2] = {0, 0};
  for (std::size_t i = 0; i < alone.size(); ++i)
  {
    dark[0] += alone[i] == 0;
    dark[1] += leftLevels[i] == 0;
  }
  EXPECT_EQ(dark[0], dark[1]);

  // A wider range bakes what is new and what that may darken, and ends as if baked at once.
  job.baker->SetSelectionRange(-2.0, 0.2);
  const std::vector<int> wider = job.levels();
  const std::vector<int> texels = job.texels();
  EXPECT_GT(job.baker->GetNumberOfNewlyBaked(), 0);
  EXPECT_LT(job.baker->GetNumberOfNewlyBaked(), job.baker->GetNumberOfBaked());
  Job atOnce;
  addValues(atOnce.data, "x", x, false);
  atOnce.baker->SetSelectionArrayName("x");
  atOnce.baker->SetSelectionRange(-2.0, 0.2);
  EXPECT_EQ(atOnce.levels(), wider);
  EXPECT_EQ(atOnce.texels(), texels);
}

TEST(AmbientOcclusionBaker, BakesWhatItIsToldTo)
{
  Job job;
  vtkNew<vtkIdTypeArray> ids;
  for (const vtkIdType id : {3, 7, -1, 7, 119, 120, 5000})
    ids->InsertNextValue(id);
  job.baker->SetVisibleIds(ids);
  std::vector<int> levels = job.levels();
  for (int i = 0; i < 120; ++i)
    EXPECT_EQ(levels[i] != notBaked, i == 3 || i == 7 || i == 119) << i;
  EXPECT_EQ(job.baker->GetNumberOfNewlyBaked(), 3);

  std::vector<double> mask(120, 0.0);
  mask[7] = mask[8] = 1.0;
  addValues(job.data, "mask", mask, false);
  job.baker->SetVisibleIds(nullptr);
  job.baker->SetMaskArrayName("mask");
  levels = job.levels();
  EXPECT_NE(levels[8], notBaked);
  EXPECT_NE(levels[3], notBaked) << "what is known stays";
  EXPECT_EQ(job.baker->GetNumberOfNewlyBaked(), 1);
}

TEST(AmbientOcclusionBaker, SavesAndLoads)
{
  const TemporaryFile file;
  Job first;
  first.baker->SetFileName(file.name.c_str());
  const std::vector<int> levels = first.levels(), texels = first.texels();
  EXPECT_FALSE(first.baker->GetReadFromFile());
  ASSERT_TRUE(std::filesystem::exists(file.name));

  Job second;
  second.baker->SetFileName(file.name.c_str());
  EXPECT_EQ(second.levels(), levels);
  EXPECT_EQ(second.texels(), texels);
  EXPECT_TRUE(second.baker->GetReadFromFile());
  EXPECT_EQ(second.baker->GetNumberOfNewlyBaked(), 0);

  Job other; // with other settings all is baked anew
  other.baker->SetFileName(file.name.c_str());
  other.baker->SetReach(0.25);
  other.baker->Update();
  EXPECT_FALSE(other.baker->GetReadFromFile());
  EXPECT_EQ(other.baker->GetNumberOfNewlyBaked(), 120);

  std::ofstream(file.name) << "nonsense";
  Job damaged;
  Complaints complaints(damaged.baker);
  damaged.baker->SetFileName(file.name.c_str());
  EXPECT_EQ(damaged.levels(), levels);
  EXPECT_EQ(complaints.warnings, 1);
  EXPECT_EQ(complaints.errors, 0);
}

TEST(AmbientOcclusionBaker, AnAbortLeavesWhatIsFinished)
{
  const TemporaryFile file;
  Job job;
  job.balls = someBalls(3000);
  for (Ball& ball : job.balls)
    ball.r *= 0.3;
  job.data = makeParticles(job.balls);
  job.baker->SetInputData(job.data);
  job.baker->SetFileName(file.name.c_str());
  job.baker->SetNumberOfThreads(1);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void* share)
    { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(*static_cast<double*>(share) > 0.3); });
  const unsigned long tag = job.baker->AddObserver(vtkCommand::ProgressEvent, stop);
  job.baker->Update();
  const vtkIdType some = job.baker->GetNumberOfBaked();
  EXPECT_GT(some, 0);
  EXPECT_LT(some, 3000);
  job.baker->RemoveObserver(tag);
  job.baker->SetAbortExecute(0);
  Job again;
  again.baker->SetInputData(job.data);
  again.baker->SetFileName(file.name.c_str());
  again.baker->Update();
  EXPECT_EQ(again.baker->GetNumberOfNewlyBaked(), 3000 - some);
  EXPECT_EQ(again.baker->GetNumberOfBaked(), 3000);
}

TEST(AmbientOcclusionBaker, AnAbortKeepsOtherMapsThatAreComplete)
{
  const TemporaryFile file;
  const auto content = [&file]
  {
    std::ifstream in(file.name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  Job job;
  job.data = makeParticles(someBalls(3000));
  job.baker->SetInputData(job.data);
  job.baker->SetFileName(file.name.c_str());
  job.baker->Update();
  const std::string complete = content();
  Job other;
  other.baker->SetInputData(job.data);
  other.baker->SetFileName(file.name.c_str());
  other.baker->SetNumberOfThreads(1);
  other.baker->SetSamples(16);
  Complaints complaints(other.baker);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void* share)
    { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(*static_cast<double*>(share) > 0.3); });
  const unsigned long tag = other.baker->AddObserver(vtkCommand::ProgressEvent, stop);
  other.baker->Update();
  EXPECT_GT(other.baker->GetNumberOfBaked(), 0);
  EXPECT_LT(other.baker->GetNumberOfBaked(), 3000);
  EXPECT_EQ(content(), complete);
  EXPECT_EQ(complaints.warnings, 1);
  other.baker->RemoveObserver(tag); // and all of the new ones take their place
  other.baker->SetAbortExecute(0);
  other.baker->Modified();
  other.baker->Update();
  EXPECT_EQ(other.baker->GetNumberOfBaked(), 3000);
  EXPECT_NE(content(), complete);
}

TEST(AmbientOcclusionBaker, ErrorsAreSentences)
{
  const auto complaint = [](const auto& change)
  {
    Job job;
    Complaints complaints(job.baker);
    vtkNew<vtkPolyData> keep;
    change(job);
    Complaints executive(job.baker->GetExecutive());
    job.baker->Update();
    EXPECT_EQ(complaints.errors, 1);
    return complaints.text;
  };
  EXPECT_NE(complaint([](Job& job) { job.baker->SetSide(5); }).find("not 5"), std::string::npos);
  EXPECT_NE(complaint([](Job& job) { job.baker->SetMaskArrayName("no"); }).find("\"no\""),
    std::string::npos);
  EXPECT_NE(complaint([](Job& job) { job.baker->SetSelectionArrayName("no"); }).find("\"no\""),
    std::string::npos);
  EXPECT_NE(complaint([](Job& job) { job.baker->SetStructureName("no"); }).find("\"no\""),
    std::string::npos);
  EXPECT_NE(
    complaint([](Job& job) { job.baker->SetFileName("/no/such/folder.moteao"); }).find("/no"),
    std::string::npos);
  EXPECT_NE(complaint([](Job& job) { job.baker->SetSkyTop(-1.0); }).find("sky"), std::string::npos);
}

TEST(AmbientOcclusionBaker, NoDataToReadMapsFor)
{
  EXPECT_NE(vtkMoteAmbientOcclusionBaker::ReadMaps("a.moteao", nullptr).find("a.moteao"),
    std::string::npos);
}

TEST(AmbientOcclusionBaker, NoPointsAtAll)
{
  vtkNew<vtkPolyData> nothing;
  vtkNew<vtkMoteAmbientOcclusionBaker> baker;
  baker->SetInputData(nothing);
  Complaints complaints(baker);
  baker->Update();
  EXPECT_EQ(complaints.errors, 0);
  EXPECT_EQ(baker->GetNumberOfBaked(), 0);
}
