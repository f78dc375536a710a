// vtkMoteMeshMapper: which triangles it makes of data sets, when it builds, what it picks, and that
// its triangles take part in the scene. It needs no display.
#include "MeshTestSupport.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCellTypeSource.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkMoteAreaLight.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <limits>
#include <sstream>

using namespace mote::testing;

TEST_F(MeshStage, TakesPolygonsAndStripsAndNamesTheirCells)
{
  const auto data = polygonAndStrip();
  mapper->SetInputData(data);
  const Complaints complaints(mapper);
  mapper->Update();
  EXPECT_EQ(mapper->GetNumberOfTriangles(), 4);
  EXPECT_EQ(mapper->GetNumberOfCellsLeftOut(), 1);
  EXPECT_EQ(mapper->GetReport(), "Left out: 1 line or vertex, which has no area.");
  EXPECT_EQ(complaints.warnings, 1);
  EXPECT_EQ(complaints.errors, 0);
  const Picture picture = this->trace();
  EXPECT_EQ(complaints.warnings, 1); // once
  EXPECT_NEAR(picture.covered(), 1.5 / 9.0 * size * size, 0.02 * size * size);
  EXPECT_EQ(cellAt(-0.25, 0.25), 1);
  EXPECT_EQ(cellAt(0.25, -0.25), 1);
  EXPECT_EQ(cellAt(0.55, -0.4), 2);
  EXPECT_EQ(cellAt(0.95, 0.4), 2);
  EXPECT_EQ(cellAt(1.2, 0.0), -1);
  double bounds[6];
  mapper->GetBounds(bounds);
  const double wanted[6] = {-0.5, 1.0, -0.5, 0.5, 0.0, 0.0};
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(bounds[i], wanted[i], 1e-6);
}

TEST_F(MeshStage, LeavesOutGhostCells)
{
  const auto data = polygonAndStrip();
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(3);
  mapper->SetInputData(data);
  const auto mark = [&](unsigned char polygon, unsigned char strip)
  {
    const unsigned char marks[3] = {0, polygon, strip};
    std::copy_n(marks, 3, ghosts->GetPointer(0));
    ghosts->Modified();
    data->GetCellData()->AddArray(ghosts);
    data->Modified();
    this->trace();
  };
  for (const int mark1 : {vtkDataSetAttributes::DUPLICATECELL, vtkDataSetAttributes::HIDDENCELL})
  {
    mark(static_cast<unsigned char>(mark1), 0);
    EXPECT_EQ(mapper->GetNumberOfTriangles(), 2);
    EXPECT_EQ(cellAt(0.25, -0.25), -1);
    EXPECT_EQ(cellAt(0.55, -0.4), 2);
    mark(0, static_cast<unsigned char>(mark1));
    EXPECT_EQ(mapper->GetNumberOfTriangles(), 2);
    EXPECT_EQ(cellAt(0.25, -0.25), 1);
    EXPECT_EQ(cellAt(0.55, -0.4), -1);
  }
  mark(0, 0);
  EXPECT_EQ(mapper->GetNumberOfTriangles(), 4);
}

TEST_F(MeshStage, TrianglesAreDrawnFromBothSides)
{
  mapper->SetInputData(polygonAndStrip());
  const Complaints complaints(mapper);
  const int front = this->trace().covered();
  renderer->GetActiveCamera()->SetPosition(0, 0, -5);
  EXPECT_EQ(this->trace().covered(), front);
  const Picture back = this->trace();
  EXPECT_NEAR(back.color(pixel(0.0, 0.0))[0], 1.0, 1e-3); // lit by the headlight
}

TEST_F(MeshStage, LeavesOutWhatHasNoArea)
{
  auto data = sixPoints();
  data->SetPolys(cellArray({{0, 1, 2}, {}, {0}, {0, 1}, {0, 2, 3}, {1, 4, 5, 2}}));
  double* moved = static_cast<vtkDoubleArray*>(data->GetPoints()->GetData())->GetPointer(0);
  moved[3 * 3] = std::numeric_limits<double>::quiet_NaN(); // point 3, of one triangle
  mapper->SetInputData(data);
  const Complaints complaints(mapper);
  this->trace();
  EXPECT_EQ(mapper->GetNumberOfTriangles(), 3);
  EXPECT_EQ(mapper->GetNumberOfUnfitTriangles(), 1);
  EXPECT_EQ(mapper->GetNumberOfCellsLeftOut(), 3);
  EXPECT_NE(complaints.text.find("3 polygons without a triangle; 1 triangle with a corner that"),
    std::string::npos)
    << complaints.text;
  EXPECT_EQ(cellAt(0.25, -0.25), 0);
  EXPECT_EQ(cellAt(0.9, 0.0), 5);
}

TEST_F(MeshStage, WrongIndicesAreAnErrorOnceAndDrawNothing)
{
  for (const bool polygon : {false, true})
  {
    auto data = sixPoints();
    data->SetPolys(cellArray({{0, 1, 2},
      polygon ? std::vector<vtkIdType>{0, 1, 2, 78} : std::vector<vtkIdType>{0, 1, 77}}));
    mapper->SetInputData(data);
    const Complaints complaints(mapper);
    EXPECT_EQ(this->trace().covered(), 0);
    this->trace();
    EXPECT_EQ(complaints.errors, 1);
    EXPECT_NE(complaints.text.find(polygon ? "78" : "77"), std::string::npos) << complaints.text;
    EXPECT_NE(complaints.text.find("6 points"), std::string::npos) << complaints.text;
  }
  mapper->SetInputData(polygonAndStrip());
  const Complaints warning(mapper);
  EXPECT_GT(this->trace().covered(), 0);
}

TEST_F(MeshStage, NothingToDrawIsNoError)
{
  const Complaints complaints(mapper);
  mapper->SetInputData(vtkSmartPointer<vtkPolyData>::New());
  EXPECT_EQ(this->trace().covered(), 0);
  mapper->SetInputData(vtkSmartPointer<vtkUnstructuredGrid>::New());
  EXPECT_EQ(this->trace().covered(), 0);
  mapper->RemoveAllInputs();
  EXPECT_EQ(this->trace().covered(), 0);
  EXPECT_EQ(complaints.errors + complaints.warnings, 0) << complaints.text;
}

TEST_F(MeshStage, BuildsForPointsAndCellsAlone)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(16);
  sphere->Update();
  vtkNew<vtkPolyData> data;
  data->DeepCopy(sphere->GetOutput());
  addValues(data, "v", std::vector<double>(data->GetNumberOfPoints(), 0.5));
  mapper->SetInputData(data);
  this->trace();
  EXPECT_EQ(mapper->GetNumberOfBuilds(), 1);
  // Looks.
  vtkNew<vtkLookupTable> table;
  mapper->SetLookupTable(table);
  mapper->SetScalarRange(0, 3);
  mapper->ScalarVisibilityOff();
  actor->GetProperty()->SetOpacity(0.5);
  actor->GetProperty()->SetInterpolationToFlat();
  renderer->GetActiveCamera()->Azimuth(20);
  addValues(data, "w", std::vector<double>(data->GetNumberOfPoints(), 0.25));
  data->Modified();
  this->trace();
  EXPECT_EQ(mapper->GetNumberOfBuilds() + mapper->GetNumberOfRefits(), 1);
  // The same points and cells in other arrays, as the next step of a series has them.
  vtkNew<vtkPolyData> copy;
  copy->DeepCopy(data);
  mapper->SetInputData(copy);
  this->trace();
  EXPECT_EQ(mapper->GetNumberOfBuilds() + mapper->GetNumberOfRefits(), 1);
  // Points that have moved, in place and as another array.
  vtkDataArray* places = copy->GetPoints()->GetData();
  for (vtkIdType i = 0; i < places->GetNumberOfTuples(); ++i)
    places->SetComponent(i, 0, 2.0 * places->GetComponent(i, 0));
  copy->GetPoints()->Modified();
  this->trace();
  EXPECT_EQ(mapper->GetNumberOfBuilds(), 1);
  EXPECT_EQ(mapper->GetNumberOfRefits(), 1);
  EXPECT_NEAR(mapper->GetBounds()[1], 2.0 * sphere->GetOutput()->GetBounds()[1], 1e-5);
  // Refitted and built trees show the same.
  const Picture refitted = this->trace();
  vtkNew<vtkMoteMeshMapper> fresh;
  fresh->SetInputData(copy);
  fresh->ScalarVisibilityOff();
  actor->SetMapper(fresh);
  const Picture built = this->trace();
  int differing = 0;
  for (int p = 0; p < built.count(); ++p)
    differing += std::abs(built.color(p)[0] - refitted.color(p)[0]) > 1e-3;
  EXPECT_LE(differing, 2);
  actor->SetMapper(mapper);
  // Points that have changed places, so that the structure is of no use.
  const vtkIdType last = places->GetNumberOfTuples() - 1;
  for (vtkIdType i = 0; i <= last; ++i)
  {
    double p[3];
    places->GetTuple(7 * i % (last + 1), p);
    places->SetTuple(i, p);
  }
  copy->GetPoints()->Modified();
  this->trace();
  EXPECT_EQ(mapper->GetNumberOfBuilds(), 2);
  EXPECT_EQ(mapper->GetNumberOfRefits(), 1);
  // Other cells.
  copy->GetPolys()->ReplaceCellAtId(0, 3, std::vector<vtkIdType>{3, 4, 5}.data());
  copy->GetPolys()->Modified();
  this->trace();
  EXPECT_EQ(mapper->GetNumberOfBuilds(), 3);
}

TEST_F(MeshStage, TakesWhatAnotherMapperHasBuilt)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  vtkNew<vtkMoteMeshMapper> other;
  other->SetInputData(sphere->GetOutput());
  EXPECT_EQ(other->GetBuilt(), nullptr);
  other->Update();
  vtkNew<vtkPolyData> shared;
  shared->ShallowCopy(sphere->GetOutput());
  mapper->SetInputData(shared);
  mapper->OfferBuilt(other->GetBuilt());
  EXPECT_GT(this->trace().covered(), 100);
  EXPECT_EQ(mapper->GetNumberOfBuilds(), 0);
  // What two mappers show is not moved under the other's hands.
  vtkNew<vtkPolyData> moved;
  moved->DeepCopy(shared);
  moved->GetPoints()->SetPoint(0, 0, 0, 1.0);
  mapper->SetInputData(moved);
  mapper->Update();
  EXPECT_EQ(mapper->GetNumberOfBuilds(), 0);
  EXPECT_EQ(mapper->GetNumberOfRefits(), 1);
  const auto top = [](vtkMoteMeshMapper* of) { return of->GetBounds()[5]; };
  EXPECT_NEAR(top(mapper), 1.0, 1e-6);
  EXPECT_NEAR(top(other), 0.5, 1e-6);
  // Nor does who begins with what is offered, and has other points.
  vtkNew<vtkMoteMeshMapper> third;
  third->SetInputData(moved);
  third->OfferBuilt(other->GetBuilt());
  third->Update();
  EXPECT_EQ(third->GetNumberOfBuilds(), 0);
  EXPECT_EQ(third->GetNumberOfRefits(), 1);
  EXPECT_NEAR(top(third), 1.0, 1e-6);
  EXPECT_NEAR(top(other), 0.5, 1e-6);
  // Other triangles are built.
  vtkNew<vtkPolyData> fewer;
  fewer->SetPoints(moved->GetPoints());
  fewer->SetPolys(cellArray({{0, 2, 3}, {0, 3, 4}}));
  third->SetInputData(fewer);
  third->OfferBuilt(other->GetBuilt());
  third->Update();
  EXPECT_EQ(third->GetNumberOfBuilds(), 1);
  EXPECT_EQ(third->GetNumberOfTriangles(), 2);
}

TEST_F(MeshStage, CanBeStopped)
{
  vtkNew<vtkSphereSource> sphere;
  mapper->SetInputConnection(sphere->GetOutputPort());
  bool stop = true;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&stop);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      if (*static_cast<bool*>(data))
        static_cast<vtkMoteMeshMapper*>(caller)->SetAbortExecute(1);
    });
  mapper->AddObserver(vtkCommand::ProgressEvent, command);
  EXPECT_EQ(this->trace().covered(), 0);
  EXPECT_EQ(mapper->GetNumberOfTriangles(), 0);
  stop = false;
  EXPECT_GT(this->trace().covered(), 100);
}

TEST_F(MeshStage, ColoursOfPointsAreMixedAndOfCellsAreNot)
{
  this->unlit();
  auto data = sixPoints();
  data->SetPolys(cellArray({{0, 1, 2, 3}, {1, 4, 5, 2}}));
  addValues(data, "x", {-0.5, 0.5, 0.5, -0.5, 1.0, 1.0});
  vtkNew<vtkDoubleArray> cells;
  cells->SetName("c");
  cells->InsertNextValue(0.25);
  cells->InsertNextValue(0.75);
  data->GetCellData()->AddArray(cells);
  mapper->SetInputData(data);
  vtkNew<vtkLookupTable> grey;
  grey->SetNumberOfTableValues(1000);
  grey->SetSaturationRange(0, 0);
  grey->SetValueRange(0, 1);
  grey->SetRampToLinear();
  grey->SetRange(-0.5, 1.0);
  grey->Build();
  mapper->SetLookupTable(grey);
  mapper->UseLookupTableScalarRangeOn();
  Picture picture = this->trace();
  int compared = 0;
  for (int p = 0; p < picture.count(); ++p)
    if (picture.color(p)[3] > 0.5f)
    {
      const double x = 3.0 * (p % size + 0.5) / size - 1.5;
      EXPECT_NEAR(picture.color(p)[0], (x + 0.5) / 1.5, 2e-3);
      ++compared;
    }
  EXPECT_GT(compared, 400);
  EXPECT_FALSE(mapper->IsColoredByCells());
  const auto between = this->cellAt(0.25, 0.25);
  EXPECT_EQ(between, 0);
  EXPECT_NEAR(picker->GetValue(), picker->GetPickPosition()[0], 1e-6);

  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectColorArray("c");
  grey->SetRange(0, 1);
  picture = this->trace();
  EXPECT_TRUE(mapper->IsColoredByCells());
  EXPECT_NEAR(picture.color(pixel(0.0, 0.3))[0], 0.25, 2e-3);
  EXPECT_NEAR(picture.color(pixel(0.7, 0.3))[0], 0.75, 2e-3);
  this->cellAt(0.7, 0.3);
  EXPECT_EQ(picker->GetValue(), 0.75);
  double range[2];
  mapper->GetColorArrayRange(range);
  EXPECT_EQ(range[0], 0.25);
  EXPECT_EQ(range[1], 0.75);

  const Complaints complaints(mapper);
  mapper->SelectColorArray("missing");
  this->trace();
  this->trace();
  EXPECT_EQ(complaints.errors, 1);
  EXPECT_NE(complaints.text.find("There is no cell array \"missing\" to colour by; there are: c."),
    std::string::npos)
    << complaints.text;
}

TEST_F(MeshStage, DirectColoursOfPoints)
{
  this->unlit();
  auto data = sixPoints();
  data->SetPolys(cellArray({{0, 1, 2}, {0, 2, 3}}));
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (int i = 0; i < 6; ++i)
  {
    const unsigned char red = i == 1 || i == 2 ? 255 : 0;
    colors->InsertNextTuple3(red, 255 - red, 51);
  }
  data->GetPointData()->SetScalars(colors);
  mapper->SetInputData(data);
  const Picture picture = this->trace();
  const double step = 1.0 / size * 3.0;
  for (const double x : {-0.4, 0.0, 0.4})
  {
    const float* color = picture.color(pixel(x, 0.2));
    EXPECT_NEAR(color[0], x + 0.5, step);
    EXPECT_NEAR(color[0] + color[1], 1.0, 1e-5);
    EXPECT_NEAR(color[2], 0.2, 1e-5);
  }
}

TEST_F(MeshStage, NormalsOfPointsMakeItSmoothUnlessFlatIsAsked)
{
  vtkNew<vtkSphereSource> sphere; // with normals
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(14);
  sphere->SetPhiResolution(9);
  mapper->SetInputConnection(sphere->GetOutputPort());
  const auto error = [&]
  {
    const Picture picture = this->trace();
    double sum = 0.0;
    int count = 0;
    for (int p = 0; p < picture.count(); ++p)
    {
      const double x = 3.0 * (p % size + 0.5) / size - 1.5, y = 3.0 * (p / size + 0.5) / size - 1.5;
      if (x * x + y * y > 0.7)
        continue;
      sum += std::abs(picture.color(p)[0] - std::sqrt(1.0 - x * x - y * y));
      ++count;
    }
    return sum / count;
  };
  const double smooth = error();
  actor->GetProperty()->SetInterpolationToFlat();
  EXPECT_GT(error(), 3.0 * smooth);
  EXPECT_LT(smooth, 0.02);
}

TEST_F(MeshStage, TrianglesAndParticlesShadowEachOther)
{
  // A floor, a ball above it, and light from above: each keeps the light from the other.
  auto data = sixPoints();
  data->SetPolys(cellArray({{0, 1, 2, 3}}));
  mapper->SetInputData(data);
  Stage balls(makeParticles({{0.0, 0.0, 1.0, 0.2}, {-0.4, 0.0, -0.5, 0.2}}));
  renderer->AddActor(balls.actor);
  vtkNew<vtkMoteAreaLight> light;
  light->SetPositional(false);
  light->SetPosition(0.3, 0.0, 1.0);
  light->SetFocalPoint(0, 0, 0);
  light->ShadowsOn();
  renderer->AddLight(light);
  renderer->GetActiveCamera()->SetClippingRange(0.1, 20);
  const auto lightAt = [&](double x, double y) { return this->trace().color(pixel(x, y))[0]; };
  EXPECT_EQ(lightAt(-0.3, 0.0), 0.0f); // where the shadow falls
  EXPECT_GT(lightAt(-0.3, 0.4), 0.9f);
  balls.mapper->CastsShadowsOff();
  EXPECT_GT(lightAt(-0.3, 0.0), 0.9f);
  // From below: the lower ball stands in the shadow of the square.
  renderer->GetActiveCamera()->SetPosition(0, 0, -5);
  renderer->GetActiveCamera()->SetViewUp(0, 1, 0);
  light->SetPosition(1.0, 0.0, 1.0); // so that some of the lit side is seen
  const auto brightest = [&]
  {
    const Picture picture = this->trace();
    float most = 0.0f;
    for (int p = 0; p < picture.count(); ++p)
      if (picture.object(p) == 1)
        most = std::max(most, picture.color(p)[0]);
    return most;
  };
  EXPECT_EQ(brightest(), 0.0f);
  mapper->CastsShadowsOff();
  EXPECT_GT(brightest(), 0.01f);
}

TEST_F(MeshStage, PrintsWhatItHolds)
{
  mapper->SetInputData(polygonAndStrip());
  const Complaints complaints(mapper);
  mapper->Update();
  std::ostringstream text;
  mapper->Print(text);
  EXPECT_NE(text.str().find("NumberOfTriangles: 4"), std::string::npos);
  EXPECT_NE(text.str().find("CastsShadows: On"), std::string::npos);
}
