// Isosurfaces of one array in the colours of another.
#include "VolumeTestSupport.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkDoubleArray.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkMoteParticlePicker.h"
#include "vtkPointData.h"

#include <cmath>

using namespace mote::testing;

namespace
{

/// A box whose points have their z as "f", their x as "g", and the vector (3 z, 0, 4 z) as "v".
struct IsoStage : VolumeStage
{
  IsoStage()
    : VolumeStage(makeBox(6, [](const Point& p) { return p[2]; }), true)
  {
    vtkPointSet* grid = mapper->GetInput();
    vtkNew<vtkDoubleArray> g, v;
    g->SetName("g");
    v->SetName("v");
    v->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      const double* p = grid->GetPoint(i);
      g->InsertNextValue(p[0]);
      v->InsertNextTuple3(3.0 * p[2], 0.0, 4.0 * p[2]);
    }
    grid->GetPointData()->AddArray(g);
    grid->GetPointData()->AddArray(v);
    mapper->SetScalarModeToUsePointFieldData();
    mapper->SelectScalarArray("g");
    mapper->ShowCloudOff();
    mapper->ShowIsoSurfacesOn();
    this->paint({1, 1, 1}, 0.5);
    vtkNew<vtkColorTransferFunction> colors; // red from 0 to 1 as g goes from -1 to 1
    colors->AddRGBPoint(-1.0, 0.0, 0.2, 0.0);
    colors->AddRGBPoint(1.0, 1.0, 0.2, 0.0);
    property()->SetColor(colors);
    property()->SetAmbient(1.0);
    property()->SetDiffuse(0.0);
    property()->SetSpecular(0.0);
    property()->GetIsoSurfaceValues()->SetValue(0, 0.3);
  }

  /// Whether a plane at this height is all that is seen, in the colours of g.
  void expectPlane(double height, const char* what)
  {
    const Picture picture = this->trace();
    const double depth = camera()->GetPosition()[2] - height;
    for (const int x : {8, 12, 16, 20})
    {
      const int pixel = picture.at(x, 18);
      EXPECT_NEAR(picture.depth(pixel), depth, 1e-5) << what;
      const double place = 3.0 * (x + 0.5) / 32.0 - 1.5;
      EXPECT_NEAR(picture.color(pixel)[0], 0.5 + 0.5 * place, 2e-3) << what << " at " << x;
      EXPECT_NEAR(picture.color(pixel)[1], 0.2, 1e-3) << what;
    }
  }
};

} // namespace

TEST(IsoArray, IsFollowedInTheColoursOfTheOther)
{
  IsoStage stage;
  stage.mapper->SetIsoArray("f");
  stage.expectPlane(0.3, "points");
  // Other values of the array are followed, and what colours may change: nothing is built.
  stage.property()->GetIsoSurfaceValues()->SetValue(0, -0.45);
  stage.expectPlane(-0.45, "another value");
  const int builds = stage.mapper->GetNumberOfBuilds();
  stage.property()->GetIsoSurfaceValues()->SetValue(0, 1.5);
  stage.mapper->SetIsoArray("v", false, -1);
  stage.property()->GetIsoSurfaceValues()->SetNumberOfContours(1);
  const Picture both = stage.trace(); // |v| is 1.5 at z = 0.3 and at -0.3
  EXPECT_NEAR(both.depth(both.at(16, 18)), stage.camera()->GetPosition()[2] - 0.3, 1e-5);
  stage.mapper->SetIsoArray("v", false, 2);
  stage.property()->GetIsoSurfaceValues()->SetValue(0, -2.0);
  stage.expectPlane(-0.5, "a component");
  stage.mapper->SetIsoArray(nullptr);
  stage.property()->GetIsoSurfaceValues()->SetValue(0, 0.25);
  const Picture own = stage.trace(); // at x = 0.25, seen from its edge
  EXPECT_EQ(own.color(own.at(8, 18))[3], 0.0f);
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), builds);
}

TEST(IsoArray, IsPickedWithTheValueThatColours)
{
  IsoStage stage;
  stage.mapper->SetIsoArray("f");
  vtkNew<vtkGenericOpenGLRenderWindow> window; // never opened: it lends its size
  window->SetSize(32, 32);
  window->AddRenderer(stage.renderer);
  stage.renderer->ResetCameraClippingRange();
  vtkNew<vtkMoteParticlePicker> picker;
  ASSERT_EQ(picker->Pick(20, 9, 0, stage.renderer), 1);
  EXPECT_NEAR(picker->GetPickPosition()[2], 0.3, 1e-9);
  EXPECT_NEAR(picker->GetValue(), picker->GetPickPosition()[0], 1e-9);
}

TEST(IsoArray, ThatTheInputLacksIsToldOnce)
{
  IsoStage stage;
  Complaints complaints(stage.mapper);
  stage.mapper->SetIsoArray("nothing", true);
  stage.trace();
  stage.trace();
  EXPECT_EQ(complaints.errors, 1);
  EXPECT_NE(complaints.text.find("'nothing' of cells"), std::string::npos) << complaints.text;
  stage.mapper->SetIsoArray("f");
  stage.expectPlane(0.3, "after that");
}

TEST(IsoArray, OfCellsIsFollowedByItsMeansAtPoints)
{
  // Those of a linear field are its values there.
  IsoStage stage;
  stage.mapper->SetIsoArray("c", true);
  stage.expectPlane(0.3, "cells, in the colours of points");
  stage.mapper->SetScalarModeToUseCellFieldData();
  stage.mapper->SelectScalarArray("c");
  stage.mapper->SetIsoArray(nullptr);
  const auto expectOwn = [&](double height)
  {
    const Picture picture = stage.trace();
    const int pixel = picture.at(14, 18);
    EXPECT_NEAR(picture.depth(pixel), stage.camera()->GetPosition()[2] - height, 1e-5);
    EXPECT_NEAR(picture.color(pixel)[0], 0.5 + 0.5 * 0.3, 2e-3) << "that of the iso-value";
  };
  expectOwn(0.3);
  // Other values of cells.
  auto* c = vtkDoubleArray::SafeDownCast(stage.mapper->GetInput()->GetCellData()->GetArray("c"));
  for (vtkIdType i = 0; i < c->GetNumberOfValues(); ++i)
    c->SetValue(i, c->GetValue(i) + 0.2);
  c->Modified();
  stage.mapper->GetInput()->Modified();
  expectOwn(0.1);
}
