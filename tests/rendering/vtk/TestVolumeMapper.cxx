// vtkMoteVolumeMapper without a display: pictures against closed formulas.
#include "VolumeTestSupport.h"

#include "vtkCamera.h"
#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkFloatArray.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkImageData.h"
#include "vtkMoteAreaLight.h"
#include "vtkMoteParticlePicker.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkProperty.h"

#include <cmath>
#include <sstream>

using namespace mote::testing;

namespace
{

constexpr double byte = 1.0 / 255.0;

double one(const Point&)
{
  return 1.0;
}

double depthOf(const Point& p)
{
  return p[2];
}

/// Whether rays beside the one at (x, y) are nearly as long inside of the box: away from its edges.
bool isInner(const TrueView& view, double x, double y)
{
  const double middle = chord(view, x, y);
  for (const double dx : {-0.5, 0.5})
    for (const double dy : {-0.5, 0.5})
      if ((chord(view, x + dx, y + dy) > 0.0) != (middle > 0.0))
        return false;
  return true;
}

struct Case
{
  const char* integrator;
  bool parallel;
};

class Integrators : public ::testing::TestWithParam<Case>
{
};

INSTANTIATE_TEST_SUITE_P(All, Integrators,
  ::testing::Values(Case{"inverse-distance", true}, Case{"trilinear", true},
    Case{"cell-by-cell", true}, Case{"inverse-distance", false}, Case{"trilinear", false},
    Case{"cell-by-cell", false}),
  [](const auto& info)
  {
    std::string name = info.param.integrator;
    std::erase(name, '-');
    return name + (info.param.parallel ? "Parallel" : "Perspective");
  });

} // namespace

TEST_P(Integrators, EvenCloudCoversByTheLengthInside)
{
  VolumeStage stage(makeBox(4, one), GetParam().parallel);
  stage.camera()->Azimuth(GetParam().parallel ? 0 : 25);
  stage.mapper->SetIntegratorName(GetParam().integrator);
  stage.paint({1, 0.5, 0.25}, 0.6);
  const Picture picture = stage.trace(40, 30);
  const TrueView view = stage.view(40, 30);
  int inside = 0, outside = 0;
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x)
    {
      if (!isInner(view, x + 0.5, y + 0.5))
        continue;
      const double alpha = covered(0.6, chord(view, x + 0.5, y + 0.5));
      const float* c = picture.color(picture.at(x, y));
      EXPECT_NEAR(c[3], alpha, byte) << x << " " << y;
      EXPECT_NEAR(c[0], alpha, byte);
      EXPECT_NEAR(c[1], 0.5 * alpha, byte);
      EXPECT_NEAR(c[2], 0.25 * alpha, byte);
      EXPECT_TRUE(std::isinf(picture.depth(picture.at(x, y)))) << "a cloud has no depth";
      ++(alpha > 0.0 ? inside : outside);
    }
  EXPECT_GT(inside, 300);
  EXPECT_GT(outside, 100);
}

TEST(VolumeMapper, StandsWhereItsPropIs)
{
  VolumeStage stage(makeBox(2, one), true);
  stage.volume->SetScale(0.5, 0.5, 0.25);
  stage.volume->SetPosition(0.5, 0, 0);
  const Picture picture = stage.trace(60, 60);
  EXPECT_NEAR(picture.color(picture.at(40, 30))[3], covered(0.5, 0.5), byte);
  EXPECT_EQ(picture.color(picture.at(28, 30))[3], 0);
  EXPECT_EQ(picture.color(picture.at(40, 15))[3], 0);
  stage.property()->SetScalarOpacityUnitDistance(0.25);
  EXPECT_NEAR(stage.trace(60, 60).color(40 + 60 * 30)[3], 0.75, byte) << "world units";
}

TEST(VolumeMapper, ParticlesStandInsideIt)
{
  VolumeStage stage(makeBox(4, one), true);
  stage.paint({1, 0, 0}, 0.6);
  const std::vector<Ball> balls{{0, 0, 0, 0.5}, {0.9, 0.9, 1.3, 0.2}, {-0.9, 0.9, -1.3, 0.2}};
  vtkNew<vtkMoteParticleMapper> mapper;
  mapper->SetInputData(makeParticles(balls));
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0, 0, 1);
  actor->GetProperty()->SetAmbient(1);
  actor->GetProperty()->SetDiffuse(0);
  stage.renderer->AddActor(actor);
  const Picture picture = stage.trace(60, 60);
  const TrueView view = stage.view(60, 60);
  int seen[3] = {};
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 60; ++x)
    {
      const auto hit = view.hit(x + 0.5, y + 0.5, balls);
      if (!hit || !view.isClear(x + 0.5, y + 0.5, balls) || !isInner(view, x + 0.5, y + 0.5))
        continue;
      const int pixel = picture.at(x, y);
      const double red = covered(0.6, chord(view, x + 0.5, y + 0.5, {0, 0, 0}, hit->depth));
      EXPECT_NEAR(picture.color(pixel)[0], red, byte);
      EXPECT_NEAR(picture.color(pixel)[2], 1.0 - red, byte);
      EXPECT_NEAR(picture.color(pixel)[3], 1.0, 1e-6);
      EXPECT_NEAR(picture.depth(pixel), hit->depth, 1e-5);
      EXPECT_EQ(picture.object(pixel), 1) << "props are numbered in the renderer's order";
      EXPECT_EQ(picture.particle(pixel), hit->ball);
      ++seen[hit->ball];
    }
  for (const int number : seen)
    EXPECT_GT(number, 10);
}

TEST(VolumeMapper, TwoVolumesLieInOrder)
{
  VolumeStage stage(makeBox(2, one), true);
  stage.paint({1, 0, 0}, 0.5);
  stage.volume->SetScale(1, 1, 0.25);
  stage.volume->SetPosition(0, 0, 0.5);
  VolumeProp behind(makeBox(2, one));
  behind.paint({0, 1, 0}, 0.75);
  behind.volume->SetScale(1, 1, 0.25);
  behind.volume->SetPosition(0, 0, -0.5);
  const double first = covered(0.5, 0.5), second = covered(0.75, 0.5);
  const auto check = [&]
  {
    const Picture picture = stage.trace();
    const float* c = picture.color(picture.at(16, 16));
    EXPECT_NEAR(c[0], first, byte);
    EXPECT_NEAR(c[1], (1 - first) * second, byte);
    EXPECT_NEAR(c[3], 1 - (1 - first) * (1 - second), byte);
  };
  stage.renderer->AddVolume(behind.volume);
  check();
  stage.renderer->RemoveVolume(stage.volume);
  stage.renderer->AddVolume(stage.volume); // now the last one
  check();
}

TEST(VolumeMapper, IsoSurfacesAreOpaqueAndHaveDepth)
{
  for (const char* integrator : {"trilinear", "cell-by-cell"})
  {
    VolumeStage stage(makeBox(5, depthOf));
    stage.mapper->SetIntegratorName(integrator);
    stage.mapper->ShowCloudOff();
    EXPECT_EQ(stage.trace().color(16 + 32 * 16)[3], 0) << "nothing is to be shown";
    stage.mapper->ShowIsoSurfacesOn();
    stage.paint({0, 1, 0}, 0.5);
    stage.property()->SetAmbient(1);
    stage.property()->SetDiffuse(0);
    stage.property()->SetSpecular(0);
    stage.property()->GetIsoSurfaceValues()->SetValue(0, 0.3);
    stage.property()->GetIsoSurfaceValues()->SetValue(1, -0.3);
    Picture picture = stage.trace();
    const int middle = picture.at(16, 16);
    EXPECT_NEAR(picture.depth(middle), 9.7, 1e-5) << integrator;
    EXPECT_NEAR(picture.color(middle)[1], 1.0, 1e-3);
    EXPECT_NEAR(picture.color(middle)[3], 1.0, 1e-6);
    EXPECT_EQ(picture.object(middle), 0);
    stage.mapper->ShowCloudOn();
    stage.paint({1, 1, 1}, 0.5);
    picture = stage.trace();
    EXPECT_NEAR(picture.depth(middle), 9.7, 1e-5) << "the cloud before it has none";
    stage.property()->GetIsoSurfaceValues()->SetNumberOfContours(0);
    stage.mapper->ShowCloudOff();
    EXPECT_EQ(stage.trace().color(middle)[3], 0) << "nothing is to be shown";
  }
}

TEST(VolumeMapper, IsoSurfacesArePickedAndCastShadows)
{
  VolumeStage stage(makeBox(5, depthOf), true);
  stage.mapper->ShowCloudOff();
  stage.mapper->ShowIsoSurfacesOn();
  stage.paint({1, 1, 1}, 0.5);
  stage.property()->GetIsoSurfaceValues()->SetValue(0, 0.3);
  vtkNew<vtkGenericOpenGLRenderWindow> window; // never opened: it lends its size
  window->SetSize(32, 32);
  window->AddRenderer(stage.renderer);
  stage.renderer->ResetCameraClippingRange();
  vtkNew<vtkMoteParticlePicker> picker;
  ASSERT_EQ(picker->Pick(20, 9, 0, stage.renderer), 1);
  EXPECT_EQ(picker->GetViewProp(), stage.volume.Get());
  EXPECT_EQ(picker->GetParticleId(), -1);
  EXPECT_NEAR(picker->GetValue(), 0.3, 1e-12);
  EXPECT_NEAR(picker->GetPickNormal()[2], 1.0, 1e-6);
  double bounds[6];
  stage.mapper->GetInput()->GetCell(picker->GetCellId())->GetBounds(bounds);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_LE(bounds[2 * axis], picker->GetPickPosition()[axis] + 1e-6);
    EXPECT_GE(bounds[2 * axis + 1], picker->GetPickPosition()[axis] - 1e-6);
  }
  EXPECT_EQ(picker->Pick(1, 1, 0, stage.renderer), 0) << "beside it";
  EXPECT_EQ(picker->GetCellId(), -1);

  // A sphere before the surface, lit from behind it.
  vtkNew<vtkMoteParticleMapper> mapper;
  mapper->SetInputData(makeParticles({{0, 0, 0.65, 0.3}}));
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  stage.renderer->AddActor(actor);
  vtkNew<vtkMoteAreaLight> light;
  light->PositionalOff();
  light->SetPosition(5.2, 0, -3.35);
  light->SetFocalPoint(0, 0, 0.65);
  light->ShadowsOn();
  stage.renderer->AddLight(light);
  const int pixel = 18 + 32 * 16; // of the sphere's right side
  Picture picture = stage.trace();
  EXPECT_EQ(picture.object(pixel), 1);
  EXPECT_EQ(picture.color(pixel)[0], 0.0f) << "in the shadow of the surface";
  stage.mapper->CastsShadowsOff();
  EXPECT_GT(stage.trace().color(pixel)[0], 0.2f);
}

TEST(VolumeMapper, TakesTheArrayThatIsAskedFor)
{
  auto grid = makeBox(3, one);
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("v");
  vectors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    vectors->InsertNextTuple3(3, -4, 12);
  grid->GetPointData()->AddArray(vectors);
  VolumeStage stage(grid, true);
  vtkNew<vtkPiecewiseFunction> opacity; // a value's own opacity
  opacity->AddPoint(-20, 0);
  opacity->AddPoint(20, 0.5);
  stage.property()->SetScalarOpacity(opacity);
  const auto expect = [&](double value, const char* what)
  {
    const Picture picture = stage.trace();
    EXPECT_NEAR(picture.color(picture.at(16, 16))[3], covered((value + 20) / 80, 2.0), byte)
      << what;
    double range[2];
    stage.mapper->GetScalarRange(range);
    EXPECT_NEAR(range[0], value, 1e-6) << what;
    EXPECT_NEAR(range[1], value, 1e-6) << what;
  };
  expect(1, "active scalars");
  stage.mapper->SetScalarModeToUsePointFieldData();
  stage.mapper->SelectScalarArray("v");
  expect(3, "first component");
  stage.mapper->SetVectorComponent(1);
  expect(-4, "second component");
  stage.mapper->SetVectorModeToMagnitude();
  expect(13, "magnitude");
  stage.mapper->SelectScalarArray("f");
  expect(1, "one number has no magnitude to choose");
  grid->GetCellData()->GetArray("c")->Fill(7);
  grid->GetCellData()->GetArray("c")->Modified();
  stage.mapper->SetScalarModeToUseCellFieldData();
  stage.mapper->SelectScalarArray("c");
  expect(7, "cells");
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), 1);
}

TEST(VolumeMapper, CellsWithoutNumbersAreLeftOutOrShown)
{
  auto grid = makeBox(4, one);
  grid->GetPointData()->GetScalars()->Fill(std::nan(""));
  VolumeStage stage(grid, true);
  EXPECT_EQ(stage.trace().color(16 + 32 * 16)[3], 0);
  double range[2];
  stage.mapper->GetScalarRange(range);
  EXPECT_GT(range[0], range[1]);
  stage.mapper->SetNanOpacity(0.5);
  stage.mapper->SetNanColor(0, 1, 0);
  const Picture picture = stage.trace();
  EXPECT_NEAR(picture.color(picture.at(16, 16))[1], 0.75, byte);
  EXPECT_NEAR(picture.color(picture.at(16, 16))[0], 0, byte);
}

TEST(VolumeMapper, StructuresDoNotChangeThePicture)
{
  VolumeStage stage(makeBox(6, [](const Point& p) { return p[0] * p[1] + p[2]; }));
  stage.camera()->Azimuth(30);
  stage.camera()->Elevation(20);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(-1, 0);
  opacity->AddPoint(1, 0.8);
  stage.property()->SetScalarOpacity(opacity);
  const Picture first = stage.trace();
  EXPECT_GT(first.color(first.at(16, 16))[3], 0.1);
  for (const std::string& name : vtkMoteVolumeMapper::GetStructureNames())
  {
    stage.mapper->SetStructureName(name.c_str());
    const Picture other = stage.trace();
    for (int i = 0; i < first.count(); ++i)
      EXPECT_NEAR(first.color(i)[3], other.color(i)[3], 1e-3) << name;
  }
}

TEST(VolumeMapper, ShadeLightsTheCloud)
{
  VolumeStage stage(makeBox(4, depthOf), true);
  stage.property()->SetAmbient(0);
  stage.property()->SetDiffuse(1);
  stage.property()->SetSpecular(0);
  const int middle = 16 + 32 * 16;
  const float bright = stage.trace().color(middle)[0];
  EXPECT_NEAR(bright, 0.75, byte);
  stage.property()->ShadeOn();
  EXPECT_NEAR(stage.trace().color(middle)[0], bright, 0.02) << "the gradient faces the headlight";
  stage.property()->SetDiffuse(0.5);
  EXPECT_NEAR(stage.trace().color(middle)[0], 0.5 * bright, 0.02);
}

TEST(VolumeMapper, BoundsAndPrint)
{
  VolumeStage stage(makeBox(2, one));
  double* bounds = stage.mapper->GetBounds();
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(bounds[2 * axis], -1);
    EXPECT_EQ(bounds[2 * axis + 1], 1);
  }
  EXPECT_EQ(stage.mapper->GetNumberOfCells(), 8);
  EXPECT_GT(stage.mapper->GetStructureBytes(), 8 * 32);
  std::ostringstream text;
  stage.mapper->Print(text);
  for (const char* part :
    {"StructureName: cartbvh", "IntegratorName: cell-by-cell", "VectorMode: Component",
      "CloudTolerance: 0", "NumberOfCells: 8", "ShowCloud: On", "NanOpacity: 0"})
    EXPECT_NE(text.str().find(part), std::string::npos) << part;
  vtkNew<vtkMoteVolumeMapper> empty;
  EXPECT_GT(empty->GetBounds()[0], empty->GetBounds()[1]);
}
