// What mappers do of VTK's clipping planes, and of vtkMoteClipCylinder.

#include "MeshTestSupport.h"
#include "VolumeTestSupport.h"

#include "vtkContourValues.h"
#include "vtkMoteClipCylinder.h"
#include "vtkMoteParticleMapper.h"
#include "vtkPlane.h"

#include <cmath>

using namespace mote::testing;

namespace
{

vtkSmartPointer<vtkPlane> planeAt(double x, double normal)
{
  auto plane = vtkSmartPointer<vtkPlane>::New();
  plane->SetOrigin(x, 0.0, 0.0);
  plane->SetNormal(normal, 0.0, 0.0);
  return plane;
}

/// Of all pixels together.
double opacityOf(const Picture& picture)
{
  double sum = 0.0;
  for (int i = 0; i < picture.count(); ++i)
    sum += picture.color(i)[3];
  return sum;
}

} // namespace

TEST_F(MeshStage, ClippingPlanesCutAndBuildNothing)
{
  mapper->SetInputData(polygonAndStrip());
  const int whole = trace().covered();
  const Complaints complaints(mapper);
  const auto plane = planeAt(0.0, 1.0);
  auto before = mapper->GetPictureMTime();
  mapper->AddClippingPlane(plane);
  EXPECT_GT(mapper->GetPictureMTime(), before);
  EXPECT_EQ(cellAt(-0.25, 0.25), -1);
  EXPECT_EQ(cellAt(0.25, 0.25), 1);
  EXPECT_EQ(cellAt(0.75, 0.0), 2);
  EXPECT_NEAR(trace().covered(), whole * 2 / 3, whole / 30);
  // A plane may be moved in place.
  before = mapper->GetPictureMTime();
  plane->SetOrigin(0.4, 0.0, 0.0);
  EXPECT_GT(mapper->GetPictureMTime(), before);
  EXPECT_EQ(cellAt(0.25, 0.25), -1);
  mapper->AddClippingPlane(planeAt(0.6, -1.0));
  EXPECT_EQ(cellAt(0.75, 0.0), -1);
  EXPECT_EQ(cellAt(0.45, 0.0), 1);
  mapper->RemoveAllClippingPlanes();
  EXPECT_EQ(trace().covered(), whole);
  plane->SetNormal(0.0, 0.0, 0.0); // which leaves all
  mapper->AddClippingPlane(plane);
  EXPECT_EQ(trace().covered(), whole);
  EXPECT_EQ(mapper->GetNumberOfBuilds(), 1);
  EXPECT_EQ(complaints.warnings + complaints.errors, 0) << complaints.text;
}

TEST_F(MeshStage, CylindersCutInWorldCoordinates)
{
  mapper->SetInputData(polygonAndStrip());
  vtkNew<vtkMoteClipCylinder> piece;
  EXPECT_EQ(mapper->GetClipCylinder(), nullptr);
  const int whole = trace().covered();
  mapper->SetClipCylinder(piece);
  EXPECT_EQ(trace().covered(), whole) << "all of it, as unless told otherwise";
  piece->SetRadiusRange(0.2, 0.4);
  EXPECT_EQ(cellAt(0.0, 0.0), -1);
  EXPECT_EQ(cellAt(0.3, 0.0), 1);
  EXPECT_EQ(cellAt(0.75, 0.0), -1);
  piece->SetAngleRange(90.0, 360.0);
  EXPECT_EQ(cellAt(0.2, 0.2), -1);
  EXPECT_EQ(cellAt(-0.2, 0.2), 1);
  EXPECT_EQ(cellAt(0.2, -0.2), 1);
  piece->SetZeroAngle(0.0, 1.0, 0.0); // a quarter turn on
  EXPECT_EQ(cellAt(0.2, 0.2), 1);
  EXPECT_EQ(cellAt(-0.2, 0.2), -1);
  piece->SetAngleRange(270.0, 90.0); // on to 90, past 360
  EXPECT_EQ(cellAt(-0.2, 0.2), 1);
  EXPECT_EQ(cellAt(0.2, 0.2), 1);
  EXPECT_EQ(cellAt(0.2, -0.2), -1);
  piece->SetHeightRange(0.5, 1.0);
  EXPECT_EQ(trace().covered(), 0);
  // The cut stays where it is, whatever the actor does.
  piece->SetHeightRange(-1.0, 1.0);
  actor->SetPosition(0.5, 0.0, 0.0);
  EXPECT_EQ(cellAt(0.3, 0.0), 1);
  EXPECT_EQ(cellAt(-0.3, 0.0), -1);
  mapper->SetClipCylinder(nullptr);
  EXPECT_EQ(mapper->GetClipCylinder(), nullptr);
  EXPECT_EQ(mapper->GetNumberOfBuilds(), 1);
}

TEST(ClipCylinder, AnglesBeginAcrossTheAxis)
{
  vtkNew<vtkMoteClipCylinder> piece;
  double zero[3];
  piece->GetZeroAngle(zero);
  EXPECT_EQ(zero[0], 1.0);
  piece->SetAxis(3.0, 0.0, 0.0);
  piece->GetZeroAngle(zero);
  EXPECT_EQ(zero[1], 1.0);
  piece->SetZeroAngle(1.0, 0.0, 0.0); // along the axis
  piece->GetZeroAngle(zero);
  EXPECT_EQ(zero[1], 1.0);
  std::ostringstream text;
  piece->Print(text);
  EXPECT_NE(text.str().find("AngleRange: 0 360"), std::string::npos) << text.str();
}

TEST(MapperClip, VolumesEndAtPlanesAndIsosurfacesAreOpen)
{
  const auto grid = makeBox(6, [](const Point& p) { return p[2]; });
  VolumeStage stage(grid);
  stage.paint({1.0, 0.5, 0.2}, 0.6);
  const Complaints complaints(stage.mapper);
  const Picture whole = stage.trace();
  const double all = opacityOf(whole);
  const auto plane = planeAt(0.0, 1.0);
  stage.mapper->AddClippingPlane(plane);
  EXPECT_NEAR(opacityOf(stage.trace()) / all, 0.5, 0.02);
  plane->SetOrigin(9.0, 0.0, 0.0);
  EXPECT_EQ(opacityOf(stage.trace()), 0.0);
  plane->SetOrigin(-9.0, 0.0, 0.0);
  EXPECT_LT(mostBetween(stage.trace(), whole), 1e-6);
  stage.mapper->ShowCloudOff();
  stage.mapper->ShowIsoSurfacesOn();
  stage.property()->GetIsoSurfaceValues()->SetValue(0, 0.1);
  const int surface = stage.trace().covered();
  plane->SetOrigin(0.0, 0.0, 0.0);
  EXPECT_LT(stage.trace().covered(), 0.9 * surface);
  EXPECT_GT(stage.trace().covered(), 0.3 * surface);
  EXPECT_EQ(complaints.warnings + complaints.errors, 0) << complaints.text;
}

TEST_F(MeshStage, FlatWallsInTheFacesOfACutAreWhole)
{
  const auto grid = makeBox(3, [](const Point& p) { return p[2]; });
  mapper->SetInputData(grid);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->Azimuth(35.0);
  camera->Elevation(25.0);
  camera->SetParallelScale(2.5);
  camera->SetClippingRange(0.1, 20);
  const Picture whole = trace();
  ASSERT_GT(whole.covered(), 500);
  vtkNew<vtkMoteClipCylinder> piece;
  const auto expectWhole = [&](const std::string& cut)
  {
    EXPECT_EQ(mostBetween(trace(), whole), 0.0) << cut;
    mapper->RemoveAllClippingPlanes();
    mapper->SetClipCylinder(nullptr);
  };
  for (int face = 0; face < 6; ++face)
  {
    double out[3] = {0.0, 0.0, 0.0};
    out[face / 2] = face % 2 == 0 ? -1.0 : 1.0;
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(out);
    plane->SetNormal(-3.0 * out[0], -3.0 * out[1], -3.0 * out[2]);
    mapper->AddClippingPlane(plane);
    expectWhole("plane " + std::to_string(face));
  }
  mapper->SetClipCylinder(piece);
  piece->SetHeightRange(-1.0, 1.0);
  expectWhole("heights");
  // Walls at two angles, about an edge of the box.
  piece->SetHeightRange(-VTK_DOUBLE_MAX, VTK_DOUBLE_MAX);
  piece->SetCenter(-1.0, -1.0, 0.0);
  piece->SetAngleRange(0.0, 90.0);
  mapper->SetClipCylinder(piece);
  expectWhole("angles");
  piece->SetCenter(1.0, -1.0, 0.0);
  piece->SetAngleRange(90.0, 180.0);
  mapper->SetClipCylinder(piece);
  expectWhole("angles on the left");
}

TEST_F(MeshStage, FlatWallsAreWholeWhereTheirCoordinatesAreRounded)
{
  const auto grid = makeBox(3, [](const Point& p) { return p[2]; });
  vtkNew<vtkPoints> floats;
  floats->SetDataTypeToFloat();
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double p[3];
    grid->GetPoint(i, p);
    floats->InsertNextPoint(0.7 + p[0] + 1.0, p[1], p[2]); // 0.7 as a float is less
  }
  grid->SetPoints(floats);
  mapper->SetInputData(grid);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->Azimuth(-50.0); // towards the wall at 0.7
  camera->SetClippingRange(0.1, 20);
  const Picture whole = trace();
  ASSERT_GT(whole.covered(), 300);
  mapper->AddClippingPlane(planeAt(0.7, 1.0));
  EXPECT_EQ(mostBetween(trace(), whole), 0.0);
}

TEST_F(MeshStage, ParticlesAreCutThroughAndClosed)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  vtkNew<vtkMoteParticleMapper> spheres;
  const Complaints complaints(spheres);
  spheres->SetInputData(data);
  spheres->SetRadiusModeToConstant();
  spheres->SetRadius(1.0);
  actor->SetMapper(spheres);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 0.5);
  plane->SetNormal(0.0, 0.0, -1.0);
  spheres->AddClippingPlane(plane);
  const int p = pixel(0.2, 0.1);
  ASSERT_EQ(picker->Pick(p % size, p / size, 0, renderer), 1);
  EXPECT_EQ(picker->GetParticleId(), 0);
  EXPECT_NEAR(picker->GetPickPosition()[2], 0.5, 1e-9);
  EXPECT_NEAR(picker->GetPickNormal()[2], 1.0, 1e-9);
  // Levels of detail give way: their boxes cannot be closed.
  spheres->SetPixelsOfError(4.0);
  ASSERT_EQ(picker->Pick(p % size, p / size, 0, renderer), 1);
  EXPECT_NEAR(picker->GetPickPosition()[2], 0.5, 1e-9);
  vtkNew<vtkMoteClipCylinder> piece;
  piece->SetRadiusRange(0.5, 2.0);
  spheres->SetClipCylinder(piece);
  EXPECT_EQ(spheres->GetClipCylinder(), piece);
  EXPECT_EQ(picker->Pick(p % size, p / size, 0, renderer), 0) << "through the hole";
  EXPECT_EQ(complaints.warnings + complaints.errors, 0) << complaints.text;
}
