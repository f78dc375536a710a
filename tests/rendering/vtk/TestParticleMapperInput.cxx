// What vtkMoteParticleMapper takes as particles: data sets, arrays, bounds, and what it says
// of input that it cannot draw.
#include "VTKTestSupport.h"

#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

using namespace mote::testing;

namespace
{

const double notANumber = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

} // namespace

TEST(ParticleMapperBounds, IncludeRadii)
{
  vtkNew<vtkMoteParticleMapper> mapper;
  mapper->SetInputData(makeParticles({{0, 0, 0, 1}, {10, 0, 0, 0.5}, {5, 4, -3, 2}}));
  expectBounds(mapper, {-1, 10.5, -1, 6, -5, 1});
  mapper->SetRadiusScale(2);
  expectBounds(mapper, {-2, 11, -2, 8, -7, 2});
}

TEST(ParticleMapperBounds, FollowTheActorsTransform)
{
  Stage stage(makeParticles({{0, 0, 0, 1}, {4, 0, 0, 1}}));
  stage.actor->SetPosition(10, 0, 0);
  stage.actor->SetScale(1, 2, 1);
  stage.actor->RotateZ(90);
  const double* bounds = stage.actor->GetBounds();
  const double expected[6] = {8, 12, -1, 5, -1, 1}; // scaled first, then turned, then moved
  for (int k = 0; k < 6; ++k)
    EXPECT_NEAR(bounds[k], expected[k], 1e-6) << "bound " << k;
}

TEST(ParticleMapperBounds, AreUnsetWithoutParticles)
{
  vtkNew<vtkMoteParticleMapper> mapper;
  EXPECT_FALSE(vtkMath::AreBoundsInitialized(mapper->GetBounds()));
  vtkNew<vtkPolyData> empty;
  mapper->SetInputData(empty);
  EXPECT_FALSE(vtkMath::AreBoundsInitialized(mapper->GetBounds()));
}

TEST(ParticleMapperErrors, MissingRadiusArray)
{
  Stage stage(makeParticles({{0, 0, 0, 1}}));
  Complaints complaints(stage.mapper);
  stage.mapper->SetRadiusModeToArray();
  stage.mapper->SetRadiusArrayName("nothing");
  EXPECT_EQ(stage.trace().covered(), 0);
  stage.mapper->Update();
  stage.mapper->GetBounds();
  EXPECT_EQ(complaints.errors, 1) << complaints.text;
  EXPECT_NE(complaints.text.find("\"nothing\""), std::string::npos) << complaints.text;
  EXPECT_NE(complaints.text.find("radius"), std::string::npos) << "names what there is";
  EXPECT_EQ(stage.mapper->GetNumberOfParticles(), 0);
  stage.mapper->SetRadiusArrayName("radius");
  EXPECT_GT(stage.trace().covered(), 0);
  EXPECT_EQ(complaints.errors, 1);
}

TEST(ParticleMapperErrors, MissingColorArray)
{
  Stage stage(makeParticles({{0, 0, 0, 1}}));
  Complaints complaints(stage.mapper);
  stage.mapper->SetScalarModeToUsePointFieldData();
  stage.mapper->SelectColorArray("nothing");
  EXPECT_GT(stage.trace().covered(), 0) << "the particles themselves are there";
  stage.trace();
  EXPECT_EQ(complaints.errors, 1) << complaints.text;
  EXPECT_NE(complaints.text.find("\"nothing\""), std::string::npos) << complaints.text;
  EXPECT_NE(complaints.text.find("radius"), std::string::npos) << "names what there is";
  stage.mapper->SelectColorArray("radius");
  stage.trace();
  stage.mapper->ScalarVisibilityOff();
  stage.mapper->SelectColorArray("nothing");
  stage.trace();
  EXPECT_EQ(complaints.errors, 1);
}

TEST(ParticleMapperErrors, NoNameForTheRadiusArray)
{
  Stage stage(makeParticles({{0, 0, 0, 1}}));
  Complaints complaints(stage.mapper);
  stage.mapper->SetRadiusModeToArray();
  EXPECT_EQ(stage.trace().covered(), 0);
  EXPECT_EQ(complaints.errors, 1);
}

TEST(ParticleMapperErrors, RadiusArrayOfThreeComponents)
{
  auto data = makeParticles({{0, 0, 0, 1}});
  vtkNew<vtkFloatArray> vector;
  vector->SetName("velocity");
  vector->SetNumberOfComponents(3);
  vector->InsertNextTuple3(1, 1, 1);
  data->GetPointData()->AddArray(vector);
  Stage stage(data);
  Complaints complaints(stage.mapper);
  stage.mapper->SetRadiusModeToArray();
  stage.mapper->SetRadiusArrayName("velocity");
  EXPECT_EQ(stage.trace().covered(), 0);
  EXPECT_EQ(complaints.errors, 1);
  EXPECT_NE(complaints.text.find("3 components"), std::string::npos) << complaints.text;
}

TEST(ParticleMapperErrors, ArraysTooShort)
{
  for (const bool byType : {false, true})
  {
    auto data = makeParticles({{0, 0, 0, 1}, {1, 0, 0, 1}, {2, 0, 0, 1}});
    addValues(data, "short", {1, 1}, false);
    Stage stage(data);
    Complaints complaints(stage.mapper);
    stage.mapper->SetRadiusMode(
      byType ? vtkMoteParticleMapper::RADIUS_BY_TYPE : vtkMoteParticleMapper::RADIUS_BY_ARRAY);
    stage.mapper->SetRadiusArrayName("short");
    stage.mapper->SetTypeArrayName("short");
    EXPECT_EQ(stage.trace().covered(), 0);
    EXPECT_EQ(complaints.errors, 1) << complaints.text;
  }
}

TEST(ParticleMapperErrors, MissingTypeArray)
{
  Stage stage(makeParticles({{0, 0, 0, 1}}));
  Complaints complaints(stage.mapper);
  stage.mapper->SetRadiusModeToType();
  EXPECT_EQ(stage.trace().covered(), 0);
  EXPECT_EQ(complaints.errors, 1);
  EXPECT_NE(complaints.text.find("\"type\""), std::string::npos) << complaints.text;
}

TEST(ParticleMapperErrors, UnknownStructure)
{
  Stage stage(makeParticles({{0, 0, 0, 1}}));
  Complaints complaints(stage.mapper);
  stage.mapper->SetStructureName("no-such-tree");
  EXPECT_EQ(stage.trace().covered(), 0);
  EXPECT_EQ(complaints.errors, 1);
  EXPECT_NE(complaints.text.find("no-such-tree"), std::string::npos) << complaints.text;
  EXPECT_NE(complaints.text.find("coherent-grid"), std::string::npos) << "names what there is";
  stage.mapper->SetStructureName("coherent-grid");
  EXPECT_GT(stage.trace().covered(), 0);
}

TEST(ParticleMapperErrors, UnknownOrUnfitForm)
{
  Stage stage(makeParticles({{0, 0, 0, 1}}));
  Complaints complaints(stage.mapper);
  stage.mapper->SetStructureForm("5-byte");
  EXPECT_EQ(stage.trace().covered(), 0);
  EXPECT_NE(
    complaints.text.find("\"5-byte\"; there are: auto, exact, 8-byte, 4-byte."), std::string::npos)
    << complaints.text;
  stage.mapper->SetStructureForm("4-byte");
  stage.mapper->SetStructureName("coherent-grid");
  EXPECT_EQ(stage.trace().covered(), 0);
  EXPECT_NE(complaints.text.find("\"coherent-grid\" has no forms"), std::string::npos)
    << complaints.text;
  EXPECT_EQ(complaints.errors, 2);
  stage.mapper->SetStructureName("auto");
  EXPECT_GT(stage.trace().covered(), 0);
  EXPECT_EQ(complaints.errors, 2) << complaints.text;
}

TEST(ParticleMapperErrors, AFormThatMovesParticlesTooFar)
{
  // Two specks, far from one another: ten bits for what lies between.
  Stage stage(makeParticles({{0, 0, 0, 1e-4}, {1, 0, 0, 1e-4}}));
  Complaints complaints(stage.mapper);
  stage.mapper->SetStructureForm("4-byte");
  stage.mapper->Update();
  EXPECT_EQ(stage.mapper->GetNumberOfParticles(), 0);
  EXPECT_EQ(complaints.errors, 1);
  EXPECT_NE(complaints.text.find("% of the smallest radius, 0.0001."), std::string::npos)
    << complaints.text;
  stage.mapper->SetStructureForm("8-byte");
  stage.mapper->Update();
  EXPECT_EQ(stage.mapper->GetNumberOfParticles(), 2);
}

TEST(ParticleMapperInput, EveryStructureAndFormDrawsTheSame)
{
  Stage truth(makeParticles(someBalls(400)));
  truth.mapper->SetStructureName("coherent-grid");
  const int covered = truth.trace().covered();
  vtkTypeInt64 bytes = 0;
  for (const std::string& name : vtkMoteParticleMapper::GetStructureNames())
    for (const std::string& form : vtkMoteParticleMapper::GetStructureForms())
    {
      if (form != "auto" && name != "auto" && name != "pkd-tree")
        continue;
      Stage stage(makeParticles(someBalls(400)));
      stage.mapper->SetStructureName(name.c_str());
      stage.mapper->SetStructureForm(form.c_str());
      EXPECT_NEAR(stage.trace().covered(), covered, 0.01 * covered) << name << ", " << form;
      if (form == "exact")
        bytes = stage.mapper->GetStructureBytes();
      if (form == "8-byte" || form == "4-byte")
      {
        EXPECT_LT(stage.mapper->GetStructureBytes(), bytes) << form;
        bytes = stage.mapper->GetStructureBytes();
      }
    }
}

TEST(ParticleMapperInput, NoneOrEmptyDrawsNothingAndSaysNothing)
{
  vtkNew<vtkPolyData> noPoints;
  vtkNew<vtkPolyData> zeroPoints;
  vtkNew<vtkPoints> points;
  zeroPoints->SetPoints(points);
  for (vtkPolyData* data : {static_cast<vtkPolyData*>(nullptr), noPoints.Get(), zeroPoints.Get()})
  {
    Stage stage(data);
    Complaints complaints(stage.mapper);
    EXPECT_EQ(stage.trace().covered(), 0);
    EXPECT_EQ(stage.mapper->GetNumberOfParticles(), 0);
    EXPECT_EQ(stage.mapper->GetNumberOfUnfitParticles(), 0);
    EXPECT_TRUE(std::isnan(stage.mapper->GetParticleValue(0)));
    EXPECT_EQ(complaints.errors + complaints.warnings, 0) << complaints.text;
  }
}

TEST(ParticleMapperInput, TakenAwayLeavesNothing)
{
  Stage stage(makeParticles({{0, 0, 0, 1}}));
  EXPECT_GT(stage.trace().covered(), 0);
  stage.mapper->SetInputData(nullptr);
  EXPECT_EQ(stage.trace().covered(), 0);
}

TEST(ParticleMapperInput, UnfitParticlesAreCountedAndReportedOnce)
{
  Stage stage(makeParticles({{0, 0, 0, 0.5}, {notANumber, 0, 0, 1}, {0, infinity, 0, 1},
    {0, 0, 0, notANumber}, {0, 0, 0, 0}, {0, 0, 0, -1}, {1, 0, 0, infinity}, {1, 1, 0, 0.25}}));
  Complaints complaints(stage.mapper);
  stage.mapper->Update();
  EXPECT_EQ(stage.mapper->GetNumberOfParticles(), 2);
  EXPECT_EQ(stage.mapper->GetNumberOfUnfitParticles(), 6);
  expectBounds(stage.mapper, {-0.5, 1.25, -0.5, 1.25, -0.5, 0.5});
  for (const long long id : stage.trace().particles())
    EXPECT_TRUE(id == -1 || id == 0 || id == 7) << id;
  stage.mapper->Update();
  EXPECT_EQ(complaints.warnings, 1);
  EXPECT_EQ(complaints.errors, 0);
  EXPECT_NE(complaints.text.find("2 with a position"), std::string::npos) << complaints.text;
  EXPECT_NE(complaints.text.find("4 with a radius"), std::string::npos) << complaints.text;
}

TEST(ParticleMapperInput, AllUnfitIsNotBuiltAndReportedEveryTime)
{
  Stage stage(makeParticles({{0, 0, 0, 1}, {1, 0, 0, 1}}));
  stage.mapper->SetRadiusModeToConstant();
  stage.mapper->SetRadius(notANumber);
  Complaints complaints(stage.mapper);
  EXPECT_EQ(stage.trace().covered(), 0);
  stage.mapper->Update();
  stage.mapper->Update();
  EXPECT_EQ(complaints.warnings, 1);
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), 1);
  EXPECT_FALSE(vtkMath::AreBoundsInitialized(stage.mapper->GetBounds()));
}

TEST(ParticleMapperInput, AnyPointSetGivesTheSamePicture)
{
  const std::vector<Ball> balls = someBalls(200);
  auto poly = makeParticles(balls);
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(poly->GetPoints());
  grid->GetPointData()->ShallowCopy(poly->GetPointData());
  vtkNew<vtkStructuredGrid> structured;
  structured->SetDimensions(10, 20, 1);
  structured->SetPoints(poly->GetPoints());
  structured->GetPointData()->ShallowCopy(poly->GetPointData());
  const auto expected = Stage(poly).trace().particles();
  EXPECT_EQ(Stage(grid).trace().particles(), expected);
  EXPECT_EQ(Stage(structured).trace().particles(), expected);
}

TEST(ParticleMapperInput, StructureOfArraysAndSingleIntegersGiveTheSamePicture)
{
  std::vector<Ball> balls = someBalls(200);
  for (Ball& b : balls) // on integers, in float and in bytes the same
    b = {std::round(20 * b.x), std::round(20 * b.y), std::round(20 * b.z), 1};
  auto poly = makeParticles(balls);
  const auto look = [&](vtkDataArray* array, bool soaRadii)
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(array->GetDataType());
    points->SetData(array);
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    vtkNew<vtkSOADataArrayTemplate<float>> radii;
    radii->SetName("radius");
    radii->DeepCopy(poly->GetPointData()->GetArray("radius"));
    if (soaRadii)
      data->GetPointData()->AddArray(radii);
    else
      data->GetPointData()->AddArray(poly->GetPointData()->GetArray("radius"));
    Stage stage(data);
    stage.actor->SetScale(0.05);
    return stage.trace().particles();
  };
  vtkDataArray* source = poly->GetPoints()->GetData();
  const auto expected = look(source, false);
  EXPECT_GT(std::count_if(expected.begin(), expected.end(), [](auto id) { return id >= 0; }), 100);
  vtkNew<vtkSOADataArrayTemplate<double>> soa;
  soa->DeepCopy(source);
  EXPECT_FALSE(soa->HasStandardMemoryLayout());
  EXPECT_EQ(look(soa, true), expected);
  for (const int type : {VTK_FLOAT, VTK_CHAR, VTK_SIGNED_CHAR, VTK_SHORT, VTK_INT, VTK_LONG,
         VTK_LONG_LONG, VTK_ID_TYPE})
  {
    auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
    array->DeepCopy(source);
    EXPECT_EQ(look(array, false), expected) << "type " << type;
  }
}

TEST(ParticleMapperInput, PrintSelfTellsItsState)
{
  vtkNew<vtkMoteParticleMapper> mapper;
  std::ostringstream before;
  mapper->Print(before);
  EXPECT_NE(before.str().find("RadiusMode: Automatic"), std::string::npos);
  mapper->SetInputData(makeParticles({{0, 0, 0, 1}, {1, 0, 0, notANumber}}));
  mapper->SetRadiusModeToType();
  mapper->SetTypeRadius(4, 2.5);
  mapper->SetRadiusArrayName("size");
  mapper->SetRadiusModeToAutomatic();
  Complaints complaints(mapper);
  mapper->Update();
  std::ostringstream after;
  mapper->Print(after);
  for (const char* part : {"TypeRadius of 4: 2.5", "RadiusArrayName: size", "StructureName: auto",
         "NumberOfParticles: 1", "NumberOfUnfitParticles: 1"})
    EXPECT_NE(after.str().find(part), std::string::npos) << part;
}
