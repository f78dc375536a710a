// vtkMoteVolumeMapper: what is refused, what is told once, and what stopping it leaves.
#include "VolumeTestSupport.h"

#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkFloatArray.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"

#include <cmath>
#include <string>

using namespace mote::testing;

namespace
{

double one(const Point&)
{
  return 1.0;
}

/// Expects one error with these words however often it is drawn, and an empty picture.
void expectRefused(VolumeStage& stage, const std::string& words)
{
  Complaints complaints(stage.mapper);
  for (int i = 0; i < 2; ++i)
  {
    const Picture picture = stage.trace(8, 8);
    for (int p = 0; p < picture.count(); ++p)
      ASSERT_EQ(picture.color(p)[3], 0) << words;
  }
  EXPECT_EQ(complaints.errors, 1) << words;
  EXPECT_EQ(complaints.warnings, 0) << complaints.text;
  EXPECT_NE(complaints.text.find(words), std::string::npos) << complaints.text;
}

} // namespace

TEST(VolumeErrors, NoCells)
{
  vtkNew<vtkUnstructuredGrid> empty;
  VolumeStage stage(empty);
  expectRefused(stage, "The input has no cells.");
}

TEST(VolumeErrors, NoCellThatCanBeDrawn)
{
  auto grid = makeBox(1, one);
  vtkNew<vtkUnstructuredGrid> flat;
  flat->SetPoints(grid->GetPoints());
  const vtkIdType ids[4] = {0, 1, 3, 2};
  flat->InsertNextCell(VTK_QUAD, 4, ids);
  VolumeStage stage(flat);
  expectRefused(stage, "No cell of the input can be drawn. Of 1 cells: 1 of other types left out.");
}

TEST(VolumeErrors, BadConnectivity)
{
  auto grid = makeBox(2, one);
  grid->GetCells()->GetConnectivityArray()->SetTuple1(11, 99);
  VolumeStage stage(grid);
  expectRefused(stage, "names the point 99, and there are 27 points.");
  grid->GetCells()->GetConnectivityArray()->SetTuple1(11, -3);
  grid->GetCells()->GetConnectivityArray()->Modified();
  grid->Modified();
  expectRefused(stage, "names the point -3");
}

TEST(VolumeErrors, NoSuchArray)
{
  VolumeStage stage(makeBox(2, one));
  stage.mapper->SetScalarModeToUsePointFieldData();
  stage.mapper->SelectScalarArray("temperature");
  expectRefused(stage, "There is no point array \"temperature\" to draw; there are: f.");
  stage.mapper->SetScalarModeToUseCellFieldData();
  expectRefused(stage, "There is no cell array \"temperature\" to draw; there are: c.");
  stage.mapper->SelectScalarArray("c");
  EXPECT_GT(stage.trace().color(16 + 32 * 16)[3], 0.5) << "as soon as there is one";
}

TEST(VolumeErrors, NoScalars)
{
  auto grid = makeBox(2, one);
  grid->GetPointData()->SetActiveScalars(nullptr);
  VolumeStage stage(grid);
  expectRefused(
    stage, "There are no active scalars to draw; there are point arrays: f, and cell arrays: c.");
}

TEST(VolumeErrors, ArrayOfAnotherLength)
{
  auto grid = makeBox(2, one);
  addValues(grid, "short", {1, 2, 3});
  VolumeStage stage(grid);
  expectRefused(stage, "There are 3 scalars for 27 points.");
}

TEST(VolumeErrors, NoSuchComponent)
{
  auto grid = makeBox(2, one);
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("v");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(27);
  vectors->Fill(1);
  grid->GetPointData()->SetScalars(vectors);
  VolumeStage stage(grid);
  stage.mapper->SetVectorComponent(3);
  expectRefused(stage, "The scalars have no component 3.");
}

TEST(VolumeErrors, NoSuchStructureOrIntegrator)
{
  VolumeStage stage(makeBox(2, one));
  stage.mapper->SetStructureName("octree");
  std::string names;
  for (const std::string& name : vtkMoteVolumeMapper::GetStructureNames())
    names += (names.empty() ? "" : ", ") + name;
  expectRefused(stage, "There is no structure \"octree\"; there are: " + names + ".");
  stage.mapper->SetStructureName("cartbvh");
  stage.mapper->SetIntegratorName("splats");
  expectRefused(stage, "There is no integrator \"splats\"; there are: inverse-distance, trilinear");
}

TEST(VolumeErrors, BlendModesAndFunctionsOfTwoVariables)
{
  VolumeStage stage(makeBox(2, one));
  stage.mapper->SetBlendModeToMaximumIntensity();
  expectRefused(stage, "Volumes are drawn in the composite blend mode only.");
  stage.mapper->SetBlendModeToComposite();
  stage.property()->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  expectRefused(stage, "Volumes are drawn with one-dimensional transfer functions only.");
  stage.property()->SetTransferFunctionMode(vtkVolumeProperty::TF_1D);
  EXPECT_GT(stage.trace().color(16 + 32 * 16)[3], 0.5);
}

TEST(VolumeErrors, WithoutInputNothingHappens)
{
  VolumeStage stage;
  Complaints complaints(stage.mapper);
  EXPECT_EQ(stage.trace().color(16 + 32 * 16)[3], 0);
  EXPECT_EQ(complaints.errors + complaints.warnings, 0);
  EXPECT_EQ(stage.mapper->GetNumberOfCells(), 0);
}

TEST(VolumeWarnings, ToldOnce)
{
  auto grid = makeBox(2, one);
  double p[3];
  grid->GetPoint(0, p);
  grid->GetPoints()->SetPoint(0, std::nan(""), p[1], p[2]);
  VolumeStage stage(grid, true);
  {
    Complaints complaints(stage.mapper);
    EXPECT_GT(stage.trace().color(20 + 32 * 20)[3], 0.5);
    stage.trace();
    EXPECT_EQ(complaints.warnings, 1);
    EXPECT_NE(complaints.text.find("Of 8 cells: 1 with points that are not finite left out."),
      std::string::npos)
      << complaints.text;
    EXPECT_EQ(stage.mapper->GetReport(), "Of 8 cells: 1 with points that are not finite left out.");
    EXPECT_EQ(stage.mapper->GetNumberOfCells(), 7);
  }
  Complaints complaints(stage.mapper);
  vtkNew<vtkPiecewiseFunction> gradient;
  gradient->AddPoint(0, 1);
  stage.property()->SetGradientOpacity(gradient);
  stage.trace();
  EXPECT_EQ(complaints.warnings, 0) << "that changes nothing";
  gradient->AddPoint(1, 0);
  stage.trace();
  stage.trace();
  EXPECT_EQ(complaints.warnings, 1);
  EXPECT_NE(complaints.text.find("Gradient opacity is not used."), std::string::npos);
  stage.property()->DisableGradientOpacityOn();
  stage.trace();
  EXPECT_EQ(complaints.warnings, 1);
  EXPECT_EQ(complaints.errors, 0);
}

namespace
{

struct Watch
{
  vtkMoteVolumeMapper* mapper;
  double abortAt;
  int starts = 0, ends = 0;
  double last = -1.0;

  Watch(vtkMoteVolumeMapper* m, double at)
    : mapper(m)
    , abortAt(at)
  {
    m->AddObserver(vtkCommand::StartEvent, this, &Watch::start);
    m->AddObserver(vtkCommand::ProgressEvent, this, &Watch::progress);
    m->AddObserver(vtkCommand::EndEvent, this, &Watch::end);
  }
  ~Watch() { mapper->RemoveAllObservers(); }
  void start() { ++starts; }
  void end() { ++ends; }
  void progress(vtkObject*, unsigned long, void* done)
  {
    EXPECT_GE(*static_cast<double*>(done), last);
    last = *static_cast<double*>(done);
    if (last >= abortAt)
      mapper->SetAbortExecute(1);
  }
};

} // namespace

TEST(VolumeAbort, LeavesNothingAndLaterBuildsAgain)
{
  for (const double at : {0.0, 0.3, 1.0})
  {
    VolumeStage stage(makeBox(2, one), true);
    Complaints complaints(stage.mapper);
    {
      Watch watch(stage.mapper, at);
      stage.mapper->Update();
      EXPECT_EQ(watch.starts, 1);
      EXPECT_EQ(watch.ends, 1);
    }
    EXPECT_EQ(stage.mapper->GetNumberOfCells(), 0) << at;
    Watch watch(stage.mapper, 2.0);
    EXPECT_GT(stage.trace().color(16 + 32 * 16)[3], 0.5);
    EXPECT_EQ(watch.last, 1.0);
    EXPECT_EQ(watch.starts, 1);
    EXPECT_EQ(complaints.errors + complaints.warnings, 0) << complaints.text;
  }
}
