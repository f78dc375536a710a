// vtkMoteRendererSource as a pipeline source: arrays, background, errors, and when it runs again.
#include "VTKTestSupport.h"

#include "vtkCamera.h"
#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTextActor.h"

#include <cmath>
#include <sstream>

using namespace mote::testing;

namespace
{

struct Source : ::testing::Test
{
  Stage stage{makeParticles({{0, 0, 0, 0.5}})};
  vtkNew<vtkMoteRendererSource> source;

  Source()
  {
    source->SetRenderer(stage.renderer);
    source->SetSize(32, 24);
    source->SetSamplesPerPixel(1);
  }

  const float* color(int x, int y)
  {
    auto* array = vtkFloatArray::SafeDownCast(source->GetOutput()->GetPointData()->GetScalars());
    return array->GetPointer(4 * (y * source->GetSize()[0] + x));
  }
};

/// Whether updating the source makes it run.
bool runs(vtkMoteRendererSource* source)
{
  const vtkMTimeType before = source->GetOutput()->GetMTime();
  source->Update();
  return source->GetOutput()->GetMTime() > before;
}

} // namespace

TEST_F(Source, MakesTheArraysAskedFor)
{
  source->Update();
  vtkImageData* image = source->GetOutput();
  EXPECT_EQ(image->GetDimensions()[0], 32);
  EXPECT_EQ(image->GetDimensions()[1], 24);
  EXPECT_EQ(image->GetDimensions()[2], 1);
  vtkPointData* arrays = image->GetPointData();
  ASSERT_EQ(arrays->GetNumberOfArrays(), 1);
  EXPECT_STREQ(arrays->GetScalars()->GetName(), "color");
  EXPECT_EQ(arrays->GetScalars()->GetNumberOfComponents(), 4);
  EXPECT_EQ(arrays->GetScalars()->GetDataType(), VTK_FLOAT);

  source->DepthOn();
  source->NormalsOn();
  source->IdsOn();
  source->Update();
  const auto expect = [&](const char* name, int type, int components)
  {
    vtkDataArray* array = source->GetOutput()->GetPointData()->GetArray(name);
    ASSERT_NE(array, nullptr) << name;
    EXPECT_EQ(array->GetNumberOfTuples(), 32 * 24) << name;
    EXPECT_EQ(array->GetNumberOfComponents(), components) << name;
    EXPECT_EQ(array->GetDataType(), type) << name;
  };
  expect("color", VTK_FLOAT, 4);
  expect("depth", VTK_FLOAT, 1);
  expect("normal", VTK_FLOAT, 3);
  expect("particle", VTK_TYPE_INT64, 1);
  expect("object", VTK_INT, 1);
  source->DepthOff();
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetPointData()->GetArray("depth"), nullptr);
}

TEST_F(Source, NothingIsInfinitelyFar)
{
  const Picture picture = stage.trace(32, 32);
  EXPECT_TRUE(std::isinf(picture.depth(0)));
  EXPECT_GT(picture.depth(0), 0);
  EXPECT_EQ(picture.particle(0), -1);
  EXPECT_EQ(picture.object(0), -1);
  for (int k = 0; k < 4; ++k)
    EXPECT_EQ(picture.color(0)[k], 0);
  for (int k = 0; k < 3; ++k)
    EXPECT_EQ(picture.normal(0)[k], 0);
  EXPECT_EQ(picture.particle(picture.at(16, 16)), 0);
  EXPECT_EQ(picture.object(picture.at(16, 16)), 0);
}

TEST_F(Source, EvenBackground)
{
  stage.renderer->SetBackground(0.25, 0.5, 0.75);
  source->Update();
  EXPECT_FLOAT_EQ(color(0, 0)[0], 0.25f);
  EXPECT_FLOAT_EQ(color(0, 0)[1], 0.5f);
  EXPECT_FLOAT_EQ(color(0, 0)[2], 0.75f);
  EXPECT_FLOAT_EQ(color(0, 0)[3], 1.0f);
}

TEST_F(Source, GradientBackgroundRunsUpwards)
{
  stage.renderer->GradientBackgroundOn();
  stage.renderer->SetBackground(0, 0, 0);
  stage.renderer->SetBackground2(1, 0.5, 0);
  source->Update();
  for (int y = 0; y < 24; ++y)
    EXPECT_NEAR(color(0, y)[0], (y + 0.5) / 24, 1e-6);
  EXPECT_NEAR(color(31, 23)[1], 0.5 * 23.5 / 24, 1e-6);
}

TEST_F(Source, TransparentBackgroundIsPremultiplied)
{
  stage.renderer->SetBackground(1, 1, 1);
  stage.actor->GetProperty()->SetOpacity(0.5);
  stage.actor->GetProperty()->SetAmbient(1);
  stage.actor->GetProperty()->SetDiffuse(0);
  stage.actor->GetProperty()->SetColor(1, 0.5, 0);
  source->TransparentBackgroundOn();
  source->Update();
  EXPECT_EQ(color(0, 0)[3], 0.0f);
  EXPECT_EQ(color(0, 0)[0], 0.0f);
  EXPECT_NEAR(color(16, 12)[0], 0.5, 1e-6);
  EXPECT_NEAR(color(16, 12)[1], 0.25, 1e-6);
  EXPECT_NEAR(color(16, 12)[3], 0.5, 1e-6);
  source->TransparentBackgroundOff();
  source->Update();
  EXPECT_NEAR(color(16, 12)[0], 1.0, 1e-6);
  EXPECT_NEAR(color(16, 12)[1], 0.75, 1e-6);
  EXPECT_NEAR(color(16, 12)[2], 0.5, 1e-6);
}

TEST_F(Source, CoverageOfManySamplesIsTheDisksArea)
{
  stage.renderer->GetActiveCamera()->ParallelProjectionOn();
  source->SetSize(24, 24);
  source->SetSamplesPerPixel(64);
  source->TransparentBackgroundOn();
  source->Update();
  double sum = 0;
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 24; ++x)
      sum += color(x, y)[3];
  const double disk = M_PI * 0.25 / 9 * 24 * 24; // radius 0.5 in a view 3 high
  EXPECT_NEAR(sum / disk, 1.0, 0.005);
}

TEST_F(Source, LeavesOutAndCountsOtherProps)
{
  vtkNew<vtkActor> plain, hidden;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(makeParticles({{0, 0, 0, 1}}));
  plain->SetMapper(mapper);
  hidden->SetMapper(mapper);
  hidden->VisibilityOff();
  vtkNew<vtkTextActor> text;
  stage.renderer->AddActor(plain);
  stage.renderer->AddActor(hidden);
  stage.renderer->AddViewProp(text);
  Complaints complaints(source);
  source->Update();
  EXPECT_EQ(source->GetNumberOfIgnoredProps(), 2);
  EXPECT_EQ(complaints.warnings, 1) << complaints.text;
  source->Modified();
  source->Update();
  EXPECT_EQ(complaints.warnings, 1) << "told once";
  text->VisibilityOff();
  source->Update();
  EXPECT_EQ(source->GetNumberOfIgnoredProps(), 1);
}

TEST_F(Source, InvisibleActorsAreNotTraced)
{
  EXPECT_GT(stage.trace().covered(), 0);
  stage.actor->VisibilityOff();
  EXPECT_EQ(stage.trace().covered(), 0);
}

TEST_F(Source, NumbersActors)
{
  Stage other(makeParticles({{1, 0, 0, 0.25}, {-1, 0, 0, 0.25}}));
  vtkNew<vtkActor> empty;
  stage.renderer->AddActor(empty);
  stage.renderer->AddActor(other.actor);
  const Picture picture = stage.trace(96, 96);
  bool seen[2] = {false, false};
  for (int i = 0; i < picture.count(); ++i)
    if (picture.object(i) >= 0)
    {
      ASSERT_LE(picture.object(i), 1);
      seen[picture.object(i)] = true;
      EXPECT_EQ(picture.object(i) == 1, std::abs(i % 96 - 47.5) > 20);
    }
  EXPECT_TRUE(seen[0] && seen[1]);
}

TEST_F(Source, WithoutRendererIsAnError)
{
  vtkNew<vtkMoteRendererSource> lonely;
  Complaints complaints(lonely), executive(lonely->GetExecutive());
  lonely->Update();
  EXPECT_EQ(complaints.errors, 1);
  EXPECT_NE(complaints.text.find("no renderer"), std::string::npos);
  EXPECT_EQ(lonely->GetOutput()->GetNumberOfPoints(), 0);
}

TEST_F(Source, BadSizesAreErrors)
{
  for (const auto& size : {std::array<int, 2>{0, 10}, {10, 0}, {-5, 5}, {70000, 1}})
  {
    Complaints complaints(source), executive(source->GetExecutive());
    source->SetSize(size.data());
    source->Update();
    EXPECT_EQ(complaints.errors, 1) << size[0];
    EXPECT_NE(complaints.text.find(std::to_string(size[0])), std::string::npos);
  }
  Complaints complaints(source);
  source->SetSize(1, 1);
  source->Update();
  EXPECT_EQ(complaints.errors, 0);
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 1);
}

TEST_F(Source, CameraWithoutDirectionIsAnError)
{
  Complaints complaints(source), executive(source->GetExecutive());
  stage.renderer->GetActiveCamera()->SetViewUp(0, 0, 1);
  source->Update();
  EXPECT_EQ(complaints.errors, 1);
  EXPECT_NE(complaints.text.find("view-up"), std::string::npos) << complaints.text;
}

TEST_F(Source, MakesACameraThatShowsEverything)
{
  vtkNew<vtkRenderer> fresh;
  fresh->AddActor(stage.actor);
  const Picture picture = mote::testing::trace(fresh, 64, 64);
  EXPECT_GT(picture.covered(), 200);
  for (int i = 0; i < 64; ++i)
    EXPECT_EQ(picture.particle(i), -1) << "cut off below";
}

TEST_F(Source, EmptyRendererGivesTheBackground)
{
  vtkNew<vtkRenderer> fresh;
  Complaints complaints(source);
  source->SetRenderer(fresh);
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 32 * 24);
  EXPECT_EQ(complaints.errors + complaints.warnings, 0) << complaints.text;
}

TEST_F(Source, AbortGivesNoImageAndTheNextUpdateIsComplete)
{
  struct Aborter
  {
    vtkAlgorithm* source;
    bool on = true;
    void progress()
    {
      if (on)
        source->SetAbortExecute(1);
    }
  } aborter{source};
  source->AddObserver(vtkCommand::ProgressEvent, &aborter, &Aborter::progress);
  source->SetSize(512, 512);
  source->SetSamplesPerPixel(16);
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
  aborter.on = false;
  source->SetSamplesPerPixel(1);
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 512 * 512);
  EXPECT_EQ(source->GetOutput()->GetPointData()->GetNumberOfArrays(), 1);
}

TEST_F(Source, RunsAgainOnlyWhereSomethingChanged)
{
  EXPECT_TRUE(runs(source));
  EXPECT_FALSE(runs(source));
  EXPECT_FALSE(runs(source));
  vtkCamera* camera = stage.renderer->GetActiveCamera();
  camera->Azimuth(10);
  EXPECT_TRUE(runs(source)) << "camera";
  EXPECT_FALSE(runs(source));
  stage.actor->SetPosition(0.1, 0, 0);
  EXPECT_TRUE(runs(source)) << "actor";
  stage.actor->GetProperty()->SetColor(1, 0, 0);
  EXPECT_TRUE(runs(source)) << "property";
  stage.mapper->SetRadiusScale(2);
  EXPECT_TRUE(runs(source)) << "mapper";
  stage.mapper->GetInput()->GetPoints()->SetPoint(0, 0.2, 0, 0);
  stage.mapper->GetInput()->GetPoints()->Modified();
  EXPECT_TRUE(runs(source)) << "data";
  stage.mapper->GetLookupTable()->Modified();
  EXPECT_TRUE(runs(source)) << "colours";
  stage.renderer->SetBackground(1, 1, 1);
  EXPECT_TRUE(runs(source)) << "background";
  source->SetSamplesPerPixel(2);
  EXPECT_TRUE(runs(source)) << "samples";
  stage.actor->VisibilityOff();
  EXPECT_TRUE(runs(source)) << "visibility";
  stage.actor->VisibilityOn();
  EXPECT_TRUE(runs(source)) << "visibility";
  EXPECT_FALSE(runs(source));
}

TEST_F(Source, RunsAgainForPropsAndLightsAddedChangedAndRemoved)
{
  EXPECT_TRUE(runs(source));
  vtkNew<vtkLight> light;
  stage.renderer->AddLight(light);
  EXPECT_TRUE(runs(source)) << "light added";
  EXPECT_FALSE(runs(source));
  light->SetIntensity(0.5);
  EXPECT_TRUE(runs(source)) << "light changed";
  light->SwitchOff();
  EXPECT_TRUE(runs(source)) << "light off";
  stage.renderer->RemoveLight(light);
  EXPECT_TRUE(runs(source)) << "light removed";
  Stage other(makeParticles({{1, 0, 0, 0.25}}));
  stage.renderer->AddActor(other.actor);
  EXPECT_TRUE(runs(source)) << "actor added";
  stage.renderer->RemoveActor(other.actor);
  EXPECT_TRUE(runs(source)) << "actor removed";
  EXPECT_FALSE(runs(source));
}

TEST_F(Source, ManyThreadsAndOneGiveTheSamePicture)
{
  Stage many(makeParticles(someBalls(500)));
  source->SetRenderer(many.renderer);
  source->SetSize(100, 70);
  source->SetSamplesPerPixel(3);
  std::vector<float> first;
  for (const int threads : {0, 1, 4})
  {
    source->SetNumberOfThreads(threads);
    source->Update();
    const std::vector<float> now(color(0, 0), color(0, 0) + 4 * 100 * 70);
    if (first.empty())
      first = now;
    EXPECT_EQ(now, first) << threads;
  }
}

TEST_F(Source, StopsAtTheNoiseLevel)
{
  source->SetSamplesPerPixel(7);
  source->Update();
  EXPECT_EQ(source->GetNumberOfSamples(), 7);
  EXPECT_TRUE(std::isinf(source->GetNoise())) << "which nobody asked for";
  source->SetSamplesPerPixel(2000);
  source->SetNoiseLevel(0.02);
  source->Update();
  const int samples = source->GetNumberOfSamples();
  EXPECT_LE(source->GetNoise(), 0.02);
  EXPECT_LT(samples, 500);
  EXPECT_EQ(source->GetOutput()->GetPointData()->GetArray("variance"), nullptr);
  source->SetNoiseLevel(0.01);
  source->Update();
  EXPECT_LE(source->GetNoise(), 0.01);
  EXPECT_NEAR(source->GetNumberOfSamples(), 4 * samples, 2 * samples);
}

TEST_F(Source, VarianceIsAnArrayWhereAskedFor)
{
  source->SetSamplesPerPixel(16);
  source->VarianceOn();
  source->Update();
  vtkDataArray* variance = source->GetOutput()->GetPointData()->GetArray("variance");
  ASSERT_NE(variance, nullptr);
  double sum = 0.0;
  int covered = 0;
  for (int i = 0; i < 32 * 24; ++i)
    sum += variance->GetTuple1(i);
  EXPECT_EQ(variance->GetTuple1(0), 0.0) << "a corner without anything";
  for (int i = 0; i < 32 * 24; ++i)
    covered += source->GetOutput()->GetPointData()->GetScalars()->GetComponent(i, 0) > 0.0;
  EXPECT_NEAR(source->GetNoise(), std::sqrt(sum / covered / 16), 1e-6);
}

TEST_F(Source, PrintSelfTellsItsState)
{
  std::ostringstream text;
  source->Print(text);
  for (const char* part : {"Size: 32 24", "SamplesPerPixel: 1", "NoiseLevel: 0", "Variance: Off",
         "NumberOfIgnoredProps: 0"})
    EXPECT_NE(text.str().find(part), std::string::npos) << part;
}
