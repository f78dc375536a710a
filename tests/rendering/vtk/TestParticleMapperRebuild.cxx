// When vtkMoteParticleMapper builds its structure, and when it must not.
#include "VTKTestSupport.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkProperty.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <thread>

using namespace mote::testing;

namespace
{

/// One particle that moves along x with the time.
class MovingParticle : public vtkPolyDataAlgorithm
{
public:
  static MovingParticle* New();
  vtkTypeMacro(MovingParticle, vtkPolyDataAlgorithm);

protected:
  MovingParticle() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override
  {
    const double steps[3] = {0, 1, 2}, range[2] = {0, 2};
    vtkInformation* info = output->GetInformationObject(0);
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), steps, 3);
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override
  {
    vtkInformation* info = output->GetInformationObject(0);
    const double time = info->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP())
                          ? info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP())
                          : 0.0;
    vtkPolyData::GetData(output)->ShallowCopy(makeParticles({{time, 0, 0, 0.5}}));
    return 1;
  }
};

vtkStandardNewMacro(MovingParticle);

struct Rebuild : ::testing::Test
{
  vtkSmartPointer<vtkPolyData> data = makeParticles(someBalls(100));
  Stage stage{data};

  Rebuild()
  {
    std::vector<double> values;
    for (int i = 0; i < 100; ++i)
      values.push_back(i);
    addValues(data, "value", values);
    stage.mapper->SetScalarRange(0, 99);
    stage.trace();
  }

  /// Builds that drawing takes.
  int builds()
  {
    const int before = stage.mapper->GetNumberOfBuilds();
    stage.trace();
    stage.mapper->GetBounds();
    stage.trace();
    return stage.mapper->GetNumberOfBuilds() - before;
  }
};

} // namespace

TEST_F(Rebuild, NoneWhileNothingChanges)
{
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), 1);
  EXPECT_EQ(builds(), 0);
}

TEST_F(Rebuild, NoneForColours)
{
  stage.mapper->SetScalarRange(10, 20);
  EXPECT_EQ(builds(), 0);
  vtkNew<vtkLookupTable> table;
  table->SetHueRange(0, 0.5);
  stage.mapper->SetLookupTable(table);
  EXPECT_EQ(builds(), 0);
  table->SetNumberOfTableValues(7);
  EXPECT_EQ(builds(), 0);
  stage.mapper->ScalarVisibilityOff();
  EXPECT_EQ(builds(), 0);
  stage.mapper->ScalarVisibilityOn();
  stage.mapper->SetScalarModeToUsePointFieldData();
  stage.mapper->SelectColorArray("radius");
  EXPECT_EQ(builds(), 0);
  data->GetPointData()->GetArray("value")->SetTuple1(0, 50);
  data->GetPointData()->GetArray("value")->Modified();
  EXPECT_EQ(builds(), 0);
}

TEST_F(Rebuild, NoneForANewColourArray)
{
  addValues(data, "other", std::vector<double>(100, 1.0));
  data->Modified();
  EXPECT_EQ(builds(), 0);
}

TEST_F(Rebuild, NoneForCameraLightPropertyAndPlace)
{
  stage.renderer->GetActiveCamera()->Azimuth(30);
  EXPECT_EQ(builds(), 0);
  stage.renderer->GetActiveCamera()->ParallelProjectionOn();
  EXPECT_EQ(builds(), 0);
  vtkNew<vtkLight> light;
  stage.renderer->AddLight(light);
  EXPECT_EQ(builds(), 0);
  light->SetPosition(1, 2, 3);
  EXPECT_EQ(builds(), 0);
  stage.actor->GetProperty()->SetColor(1, 0, 0);
  EXPECT_EQ(builds(), 0);
  stage.actor->SetPosition(1, 0, 0);
  EXPECT_EQ(builds(), 0);
}

TEST_F(Rebuild, NoneForVisibility)
{
  stage.mapper->UseVisibilityRangeOn();
  stage.mapper->SetVisibilityRange(10, 20);
  EXPECT_EQ(builds(), 0);
  stage.mapper->SetVisibilityArrayName("radius");
  EXPECT_EQ(builds(), 0);
  stage.mapper->UseVisibilityRangeOff();
  EXPECT_EQ(builds(), 0);
}

TEST_F(Rebuild, OneForEveryChangeOfRadii)
{
  stage.mapper->SetRadiusScale(0.5);
  EXPECT_EQ(builds(), 1);
  stage.mapper->SetRadiusModeToConstant();
  EXPECT_EQ(builds(), 1);
  stage.mapper->SetRadius(0.1);
  EXPECT_EQ(builds(), 1);
  stage.mapper->SetRadiusModeToArray();
  stage.mapper->SetRadiusArrayName("value");
  EXPECT_EQ(builds(), 1);
  data->GetPointData()->GetArray("value")->SetTuple1(3, 0.5);
  data->GetPointData()->GetArray("value")->Modified();
  EXPECT_EQ(builds(), 1);
  stage.mapper->SetRadiusModeToType();
  stage.mapper->SetTypeArrayName("value");
  EXPECT_EQ(builds(), 1);
  stage.mapper->SetTypeRadius(3, 0.25);
  EXPECT_EQ(builds(), 1);
}

TEST_F(Rebuild, NoneForRadiiThatAreNotInUse)
{
  stage.mapper->SetRadius(3);
  stage.mapper->SetTypeRadius(1, 3);
  EXPECT_EQ(builds(), 0) << "radii come from the array";
}

TEST_F(Rebuild, OneForPointsChangedInPlace)
{
  data->GetPoints()->SetPoint(0, 5, 0, 0);
  data->GetPoints()->Modified();
  EXPECT_EQ(builds(), 1);
  EXPECT_GT(stage.mapper->GetBounds()[1], 5);
  data->GetPoints()->GetData()->SetComponent(0, 0, 7);
  data->GetPoints()->GetData()->Modified();
  EXPECT_EQ(builds(), 1);
  EXPECT_GT(stage.mapper->GetBounds()[1], 7);
}

TEST_F(Rebuild, OneForOtherPoints)
{
  vtkNew<vtkPoints> points;
  points->DeepCopy(data->GetPoints());
  data->SetPoints(points);
  EXPECT_EQ(builds(), 1);
}

TEST_F(Rebuild, OneForANewInput)
{
  stage.mapper->SetInputData(makeParticles({{0, 0, 0, 1}}));
  EXPECT_EQ(builds(), 1);
  EXPECT_EQ(stage.mapper->GetNumberOfParticles(), 1);
}

TEST_F(Rebuild, SharedArraysAreTheSameInput)
{
  // As a filter that only adds arrays passes them on.
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(data);
  stage.mapper->SetInputData(copy);
  EXPECT_EQ(builds(), 0);
}

TEST(MapperPipeline, FollowsTimeSteps)
{
  vtkNew<MovingParticle> source;
  Stage stage;
  stage.mapper->SetInputConnection(source->GetOutputPort());
  for (const double time : {0.0, 1.0, 2.0, 1.0})
  {
    source->UpdateTimeStep(time);
    stage.trace();
    EXPECT_NEAR(stage.mapper->GetBounds()[0], time - 0.5, 1e-6);
  }
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), 4);
  stage.trace();
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), 4);
  source->Modified();
  stage.trace();
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), 5);
}

namespace
{

/// Aborts at the first progress of a build.
struct Aborter
{
  vtkMoteParticleMapper* mapper;
  bool abort = true;
  bool otherThread = false;
  int starts = 0, ends = 0, steps = 0;
  double last = -1.0;
  std::thread::id thread = std::this_thread::get_id();

  explicit Aborter(vtkMoteParticleMapper* m)
    : mapper(m)
  {
    m->AddObserver(vtkCommand::StartEvent, this, &Aborter::start);
    m->AddObserver(vtkCommand::ProgressEvent, this, &Aborter::progress);
    m->AddObserver(vtkCommand::EndEvent, this, &Aborter::end);
  }
  ~Aborter() { mapper->RemoveAllObservers(); }
  void start() { ++starts; }
  void end() { ++ends; }
  void progress(vtkObject*, unsigned long, void* done)
  {
    last = *static_cast<double*>(done);
    EXPECT_GE(last, 0.0);
    EXPECT_LE(last, 1.0);
    otherThread = otherThread || std::this_thread::get_id() != thread;
    ++steps;
    if (abort)
      mapper->SetAbortExecute(1);
  }
};

} // namespace

TEST(MapperAbort, LeavesNothingAndLaterBuildsAgain)
{
  Stage stage(makeParticles(someBalls(20000)));
  Complaints complaints(stage.mapper);
  Aborter aborter(stage.mapper);
  EXPECT_EQ(stage.trace().covered(), 0);
  EXPECT_EQ(stage.mapper->GetNumberOfParticles(), 0);
  EXPECT_GE(aborter.steps, 1);
  aborter.abort = false;
  EXPECT_GT(stage.trace().covered(), 0);
  EXPECT_EQ(stage.mapper->GetNumberOfParticles(), 20000);
  EXPECT_EQ(aborter.starts, aborter.ends);
  EXPECT_EQ(complaints.errors + complaints.warnings, 0);
}

TEST(MapperAbort, EventsComeFromTheCallersThread)
{
  Stage stage(makeParticles(someBalls(200000)));
  Aborter aborter(stage.mapper);
  aborter.abort = false;
  stage.mapper->Update();
  EXPECT_GT(aborter.steps, 1);
  EXPECT_FALSE(aborter.otherThread);
}

TEST(MapperAbort, EventsPairWhereTheInputIsUnfit)
{
  Stage stage(makeParticles({{0, 0, 0, 1}, {1, 0, 0, 1}}));
  addValues(stage.mapper->GetInput(), "radius", {1}, false); // too short
  Complaints complaints(stage.mapper);
  Aborter aborter(stage.mapper);
  stage.mapper->Update();
  EXPECT_EQ(complaints.errors, 1);
  EXPECT_EQ(aborter.starts, aborter.ends);
}
