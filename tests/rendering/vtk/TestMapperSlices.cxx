// Slices of a vtkMoteVolumeMapper, and edges of cells on slices and surfaces.

#include "MeshTestSupport.h"
#include "VolumeTestSupport.h"

#include "vtkActor.h"
#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkMoteMeshMapper.h"
#include "vtkMoteSlice.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

using namespace mote::testing;

namespace
{

vtkSmartPointer<vtkMoteSlice> planeAt(double z)
{
  auto slice = vtkSmartPointer<vtkMoteSlice>::New();
  slice->SetCenter(0.0, 0.0, z);
  return slice;
}

int covered(const Picture& picture)
{
  int count = 0;
  for (int i = 0; i < picture.count(); ++i)
    count += picture.color(i)[3] > 0.5;
  return count;
}

} // namespace

TEST(MapperSlices, InWallsAreSeen)
{
  const auto grid = makeBox(4, [](const Point& p) { return p[0]; });
  VolumeStage stage(grid);
  stage.mapper->ShowCloudOff();
  stage.camera()->Azimuth(30.0);
  stage.camera()->Elevation(20.0);
  for (const double z : {1.0, 0.0})
    stage.mapper->AddSlice(planeAt(z));
  const Picture alone = stage.trace(100, 100);
  vtkNew<vtkMoteMeshMapper> walls;
  walls->SetInputData(grid);
  vtkNew<vtkActor> actor;
  actor->SetMapper(walls);
  stage.renderer->AddActor(actor);
  const Picture both = stage.trace(100, 100);
  int seen = 0;
  for (int i = 0; i < both.count(); ++i)
    seen += both.color(i)[3] > 0.5 && std::equal(both.color(i), both.color(i) + 4, alone.color(i));
  // All of the wall in front, and none of the slice within.
  stage.mapper->RemoveAllSlices();
  stage.mapper->AddSlice(planeAt(1.0));
  stage.renderer->RemoveActor(actor);
  EXPECT_EQ(seen, covered(stage.trace(100, 100)));
  EXPECT_GT(seen, 1000);
}

TEST(MapperSlices, AreDrawnInTheColoursOfValuesWhateverTheLight)
{
  const auto grid = makeBox(5, [](const Point& p) { return p[0]; });
  VolumeStage stage(grid, true);
  stage.mapper->ShowCloudOff();
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(-1.0, 0.0, 0.0, 1.0);
  colors->AddRGBPoint(1.0, 1.0, 0.0, 0.0);
  stage.property()->SetColor(colors);
  const Complaints complaints(stage.mapper);
  const auto slice = planeAt(0.3);
  auto before = stage.mapper->GetPictureMTime();
  stage.mapper->AddSlice(slice);
  EXPECT_GT(stage.mapper->GetPictureMTime(), before);
  const Picture picture = stage.trace(60, 60);
  EXPECT_EQ(covered(picture), 40 * 40); // of [-1.5, 1.5]^2
  for (int y = 12; y < 48; ++y)
    for (int x = 12; x < 48; ++x)
    {
      const double red = 0.5 + 0.5 * ((x + 0.5) / 20.0 - 1.5);
      EXPECT_NEAR(picture.color(y * 60 + x)[0], red, 1e-4);
      EXPECT_NEAR(picture.color(y * 60 + x)[2], 1.0 - red, 1e-4);
    }
  // Values outside of ranges are not there.
  stage.mapper->AddSliceRange(-5.0, -0.5);
  stage.mapper->AddSliceRange(0.5, 0.75);
  EXPECT_NEAR(covered(stage.trace(60, 60)), 15 * 40, 40);
  stage.mapper->RemoveAllSliceRanges();
  // Another place is another picture, and nothing is built for it.
  const int builds = stage.mapper->GetNumberOfBuilds();
  before = stage.mapper->GetPictureMTime();
  slice->SetAxis(0.0, 1.0, 1.0);
  EXPECT_GT(stage.mapper->GetPictureMTime(), before);
  EXPECT_LT(covered(stage.trace(60, 60)), 40 * 40);
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), builds);
  double bounds[6];
  stage.mapper->GetSliceBounds(bounds);
  EXPECT_NEAR(bounds[0], -1.0, 1e-6);
  EXPECT_NEAR(bounds[2], -0.7, 1e-6);
  EXPECT_NEAR(bounds[3], 1.0, 1e-6);
  EXPECT_EQ(stage.mapper->GetNumberOfSlices(), 1);
  EXPECT_EQ(stage.mapper->GetSlice(0), slice);
  EXPECT_EQ(stage.mapper->GetSlice(1), nullptr);
  stage.mapper->RemoveAllSlices();
  EXPECT_EQ(covered(stage.trace(60, 60)), 0);
  stage.mapper->GetSliceBounds(bounds);
  EXPECT_GT(bounds[0], bounds[1]);
  EXPECT_EQ(complaints.warnings + complaints.errors, 0) << complaints.text;
}

TEST(MapperSlices, ArePickedWithCellAndValue)
{
  const auto grid = makeBox(4, [](const Point& p) { return 10.0 * p[0] + p[1]; });
  VolumeStage stage(grid, true);
  stage.mapper->ShowCloudOff();
  stage.mapper->AddSlice(planeAt(-0.25));
  vtkNew<vtkGenericOpenGLRenderWindow> window; // never opened: it lends the renderer its size
  window->SetSize(60, 60);
  window->AddRenderer(stage.renderer);
  stage.renderer->ResetCameraClippingRange();
  vtkNew<vtkMoteParticlePicker> picker;
  ASSERT_EQ(picker->Pick(22, 41, 0, stage.renderer), 1);
  const double* at = picker->GetPickPosition();
  EXPECT_NEAR(at[2], -0.25, 1e-6);
  EXPECT_NEAR(picker->GetValue(), 10.0 * at[0] + at[1], 1e-5);
  double bounds[6];
  grid->GetCellBounds(picker->GetCellId(), bounds);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_LE(bounds[2 * axis], at[axis] + 1e-6);
    EXPECT_GE(bounds[2 * axis + 1], at[axis] - 1e-6);
  }
  EXPECT_EQ(picker->Pick(1, 1, 0, stage.renderer), 0) << "beside it";
}

TEST(MapperSlices, CopiesAroundAnAxisAreTheWholeWheel)
{
  // A quarter of a block, and the block: a field that is the same in all quarters.
  const auto field = [](const Point& p) { return p[2]; };
  const auto whole = makeBox(4, field), quarter = makeBox(2, field);
  for (vtkIdType i = 0; i < quarter->GetNumberOfPoints(); ++i)
  {
    double p[3];
    quarter->GetPoint(i, p);
    quarter->GetPoints()->SetPoint(i, 0.5 * p[0] + 0.5, 0.5 * p[1] + 0.5, p[2]);
  }
  VolumeStage one(whole, true), four(quarter, true);
  four.mapper->SetRepetitions(4);
  for (VolumeStage* stage : {&one, &four})
  {
    stage->paint({0.2, 0.6, 0.9}, 0.4);
    stage->camera()->SetPosition(1.0, 2.0, 5.0);
    vtkNew<vtkMoteSlice> slice;
    slice->SetCenter(0.1, 0.2, -0.1);
    slice->SetAxis(0.3, -0.2, 1.0);
    stage->mapper->AddSlice(slice);
  }
  double ofOne[6], ofFour[6];
  one.mapper->GetBounds(ofOne);
  four.mapper->GetBounds(ofFour);
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(ofOne[i], ofFour[i], 1e-12);
  const auto compare = [&](const char* what)
  {
    const Picture a = one.trace(60, 60), b = four.trace(60, 60);
    int others = 0, seen = 0;
    for (int i = 0; i < a.count(); ++i)
    {
      seen += a.color(i)[3] > 0.0;
      for (int c = 0; c < 4; ++c)
        if (std::abs(a.color(i)[c] - b.color(i)[c]) > 3e-3)
        {
          ++others;
          break;
        }
    }
    EXPECT_GT(seen, 900) << what;
    EXPECT_LE(others, 3) << what; // where copies touch
  };
  compare("cloud and slice");
  for (VolumeStage* stage : {&one, &four})
    stage->mapper->ShowCloudOff();
  compare("slice");
  EXPECT_EQ(four.mapper->GetNumberOfBuilds(), one.mapper->GetNumberOfBuilds());
}

TEST(MapperSlices, ComponentsOfVectorsTurnWithWhatIsDrawn)
{
  // A vector that is the place itself: wherever it has turned to, its part along x is x.
  const auto quarter = makeBox(2, [](const Point& p) { return p[2]; });
  vtkNew<vtkDoubleArray> places;
  places->SetName("place");
  places->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < quarter->GetNumberOfPoints(); ++i)
  {
    double p[3];
    quarter->GetPoint(i, p);
    p[0] = 0.5 * p[0] + 0.5, p[1] = 0.5 * p[1] + 0.5;
    quarter->GetPoints()->SetPoint(i, p);
    places->InsertNextTuple(p);
  }
  quarter->GetPointData()->AddArray(places);
  VolumeStage stage(quarter, true);
  stage.mapper->SetScalarModeToUsePointFieldData();
  stage.mapper->SelectScalarArray("place");
  stage.mapper->SetRepetitions(4);
  stage.mapper->ShowCloudOff();
  stage.mapper->AddSlice(planeAt(0.3));
  vtkNew<vtkMoteMeshMapper> walls;
  walls->SetInputData(quarter);
  walls->SetScalarModeToUsePointFieldData();
  walls->SelectColorArray("place");
  walls->SetRepetitions(4);
  vtkNew<vtkActor> boundary;
  boundary->SetMapper(walls);
  vtkNew<vtkGenericOpenGLRenderWindow> window; // never opened: it lends the renderer its size
  window->SetSize(60, 60);
  window->AddRenderer(stage.renderer);
  const auto largestError = [&](int component)
  {
    stage.renderer->ResetCameraClippingRange();
    vtkNew<vtkMoteParticlePicker> picker;
    picker->PickCloudsOn();
    double error = 0.0;
    for (const auto& [x, y] : {std::pair(40, 45), {20, 42}, {17, 21}, {42, 18}})
    {
      EXPECT_EQ(picker->Pick(x, y, 0, stage.renderer), 1);
      error = std::max(error, std::abs(picker->GetValue() - picker->GetPickPosition()[component]));
    }
    return error;
  };
  EXPECT_GT(largestError(0), 0.1) << "components of the data";
  stage.mapper->TurnVectorsOn();
  EXPECT_LT(largestError(0), 1e-5);
  for (vtkProp3D* prop : {static_cast<vtkProp3D*>(stage.volume), static_cast<vtkProp3D*>(boundary)})
    prop->RotateZ(10.0);
  EXPECT_LT(largestError(0), 1e-5);
  stage.mapper->SetVectorComponent(1);
  EXPECT_LT(largestError(1), 1e-5);
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), 1);
  EXPECT_EQ(stage.mapper->GetNumberOfFieldUpdates(), 2) << "those of the copies are their own";
  stage.mapper->SetVectorComponent(0);
  stage.mapper->RemoveAllSlices();
  stage.mapper->ShowCloudOn();
  stage.paint({0.2, 0.6, 0.9}, 0.9);
  EXPECT_LT(largestError(0), 1e-5) << "the cloud";
  stage.renderer->RemoveVolume(stage.volume);
  stage.renderer->AddActor(boundary);
  EXPECT_GT(largestError(0), 0.1);
  walls->TurnVectorsOn();
  EXPECT_LT(largestError(0), 1e-5) << "triangles";
}

TEST_F(MeshStage, CopiesAroundAnAxis)
{
  auto data = sixPoints();
  data->SetPolys(cellArray({{1, 4, 5, 2}})); // to the right of the middle
  mapper->SetInputData(data);
  const int one = trace().covered();
  mapper->SetRepetitions(4);
  EXPECT_NEAR(trace().covered(), 4 * one, 8);
  EXPECT_EQ(cellAt(0.75, 0.0), 0);
  EXPECT_EQ(cellAt(0.0, -0.75), 0);
  EXPECT_EQ(cellAt(0.0, 0.0), -1);
  mapper->SetRepetitionCenter(0.75, 0.0, 0.0);
  EXPECT_LT(trace().covered(), 4 * one);
  mapper->SetRepetitionAxis(0.0, 0.0, 0.0); // none: one alone
  EXPECT_EQ(trace().covered(), one);
  EXPECT_EQ(mapper->GetNumberOfBuilds(), 1);
}

namespace
{

/// Hexahedra from radius 0.25 to 1 and an eighth high, over the first `share` of a turn about z;
/// `moved` turns the inner points on its last side aside.
vtkSmartPointer<vtkUnstructuredGrid> ringSector(double share, double moved = 0.0)
{
  const int around = static_cast<int>(std::lround(16 * share));
  const bool isClosed = share == 1.0;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int k = 0; k <= around; ++k)
    for (const double radius : {0.25, 0.5, 1.0})
      for (const double z : {0.0, 0.125})
      {
        const bool aside = k == around && radius == 0.5;
        const double angle = 2.0 * M_PI * (k + (aside ? moved : 0.0)) / 16;
        points->InsertNextPoint(radius * std::cos(angle), radius * std::sin(angle), z);
      }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  for (int k = 0; k < around; ++k)
    for (int ring = 0; ring < 2; ++ring)
    {
      const vtkIdType a = 6 * k + 2 * ring, b = isClosed && k + 1 == around ? 2 * ring : a + 6;
      const vtkIdType cell[8] = {a, a + 2, b + 2, b, a + 1, a + 3, b + 3, b + 1};
      grid->InsertNextCell(VTK_HEXAHEDRON, 8, cell);
    }
  return grid;
}

} // namespace

TEST_F(MeshStage, SidesWhereCopiesOfASectorTouchAreNotDrawn)
{
  const auto trianglesOf = [&](vtkUnstructuredGrid* grid, int copies)
  {
    mapper->SetInputData(grid);
    mapper->SetRepetitions(copies);
    mapper->Update();
    return mapper->GetNumberOfTriangles();
  };
  const vtkIdType wheel = trianglesOf(ringSector(1.0), 1);
  EXPECT_EQ(wheel, 16 * 2 * (2 * 2 + 2));
  for (const int copies : {2, 4, 8})
    EXPECT_EQ(trianglesOf(ringSector(1.0 / copies), copies), wheel / copies) << copies;
  const vtkIdType alone = trianglesOf(ringSector(0.25), 1);
  EXPECT_EQ(alone, wheel / 4 + 2 * 2 * 2);
  // With a gap between copies, or with other points on either side, all is seen.
  EXPECT_EQ(trianglesOf(ringSector(0.25), 3), alone);
  EXPECT_EQ(trianglesOf(ringSector(0.25, 0.1), 4), alone);
  // What covers itself looks the same way, and is no side.
  EXPECT_EQ(trianglesOf(ringSector(1.0), 4), wheel);
  // The axis counts, too.
  trianglesOf(ringSector(0.25), 4);
  mapper->SetRepetitionCenter(1.0, 0.0, 0.0);
  mapper->Update();
  EXPECT_EQ(mapper->GetNumberOfTriangles(), alone);
}

TEST(MapperSlices, WithoutDirectionAreRefusedInASentence)
{
  VolumeStage stage(makeBox(2, [](const Point& p) { return p[0]; }), true);
  Complaints complaints(stage.mapper);
  const auto slice = planeAt(0.0);
  slice->SetAxis(0.0, 0.0, 0.0);
  stage.mapper->AddSlice(slice);
  stage.trace();
  EXPECT_EQ(complaints.errors, 1);
  EXPECT_NE(complaints.text.find("axis"), std::string::npos) << complaints.text;
}

TEST_F(MeshStage, EdgesAreThoseOfPolygonsAndNotOfTheirTriangles)
{
  mapper->SetInputData(polygonAndStrip());
  this->unlit();
  actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  const auto isDark = [](const Picture& picture, double x, double y)
  { return picture.color(pixel(x, y))[0] < 0.6; };
  Picture plain = trace();
  for (const double y : {-0.48, 0.0, 0.48})
    EXPECT_FALSE(isDark(plain, -0.48, y));
  actor->GetProperty()->EdgeVisibilityOn();
  actor->GetProperty()->SetLineWidth(3.0);
  const Picture lined = trace();
  for (const double along : {-0.3, 0.1, 0.3})
  {
    EXPECT_TRUE(isDark(lined, -0.48, along));
    EXPECT_TRUE(isDark(lined, 0.48, along));
    EXPECT_TRUE(isDark(lined, along, -0.48));
    EXPECT_TRUE(isDark(lined, along, 0.48));
    // The square's diagonals, one of which its triangles have.
    EXPECT_FALSE(isDark(lined, along, along));
    EXPECT_FALSE(isDark(lined, along, -along));
  }
  EXPECT_EQ(lined.covered(), plain.covered());
}

TEST_F(MeshStage, EdgesOfAGridsFacesAreThoseOfItsCells)
{
  mapper->SetInputData(makeBox(2, [](const Point& p) { return p[0]; }));
  mapper->ScalarVisibilityOff();
  this->unlit();
  actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  actor->GetProperty()->EdgeVisibilityOn();
  actor->GetProperty()->SetLineWidth(2.0);
  const Picture lined = trace();
  for (const double along : {-0.7, -0.3, 0.3, 0.7})
  {
    EXPECT_LT(lined.color(pixel(0.0, along))[0], 0.6);
    EXPECT_LT(lined.color(pixel(along, 0.0))[0], 0.6);
    EXPECT_GT(lined.color(pixel(along, along))[0], 0.9);
    EXPECT_GT(lined.color(pixel(along, -along))[0], 0.9);
  }
}
