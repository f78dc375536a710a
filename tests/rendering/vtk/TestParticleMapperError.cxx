// vtkMoteParticleMapper where some pixels of error are allowed. It needs no display.
#include "VTKTestSupport.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkPointData.h"
#include "vtkProperty.h"

#include <cmath>

using namespace mote::testing;

namespace
{

/// A cube of particles that touch, 64 a side, coloured 0 and 1 by turns, each far smaller than a
/// pixel.
struct Crowd : ::testing::Test
{
  static constexpr int side = 64;
  vtkSmartPointer<vtkPolyData> data;
  vtkDataArray* stripes = nullptr;
  Stage stage;

  Crowd()
  {
    std::vector<Ball> balls;
    std::vector<double> values;
    for (int i = 0; i < side * side * side; ++i)
    {
      const auto at = [](int k) { return (k + 0.5) / side - 0.5; };
      balls.push_back({at(i % side), at(i / side % side), at(i / side / side), 0.5 / side});
      values.push_back(i % 2);
    }
    data = makeParticles(balls);
    stripes = addValues(data, "stripes", values);
    stage.mapper->SetInputData(data);
    vtkNew<vtkLookupTable> grey;
    grey->SetSaturationRange(0, 0);
    grey->SetValueRange(0, 1);
    grey->SetRampToLinear();
    grey->SetRange(0, 1);
    stage.mapper->SetLookupTable(grey);
    stage.mapper->UseLookupTableScalarRangeOn();
    stage.actor->GetProperty()->SetAmbient(1);
    stage.actor->GetProperty()->SetDiffuse(0);
    vtkCamera* camera = stage.renderer->GetActiveCamera();
    camera->SetPosition(7.0, 7.0, 7.0); // boxes on one of the three faces that are seen are exact
    camera->SetFocalPoint(0, 0, 0);
    camera->SetClippingRange(1, 20);
  }

  /// How far colours are from the middle one, in the mean.
  static double spread(const Picture& picture)
  {
    double sum = 0.0;
    for (int p = 0; p < picture.count(); ++p)
      if (picture.color(p)[3] > 0.0f)
        sum += std::abs(picture.color(p)[0] - 0.5);
    return sum / picture.covered();
  }
};

void expectSame(const Picture& a, const Picture& b)
{
  for (int p = 0; p < a.count(); ++p)
    for (int c = 0; c < 4; ++c)
      ASSERT_EQ(a.color(p)[c], b.color(p)[c]) << "pixel " << p;
}

} // namespace

TEST_F(Crowd, PixelsOfErrorMakeBoxesOfTheMeanColour)
{
  const Picture exact = stage.trace();
  EXPECT_GT(spread(exact), 0.45);
  stage.mapper->SetPixelsOfError(2.0);
  const Picture rough = stage.trace();
  EXPECT_LT(spread(rough), 0.6 * spread(exact));
  EXPECT_NEAR(rough.covered(), exact.covered(), 0.1 * exact.covered());
  for (vtkIdType i = 0; i < stripes->GetNumberOfTuples(); ++i)
    stripes->SetTuple1(i, 0.25);
  stripes->Modified();
  EXPECT_NEAR(spread(stage.trace()), 0.25, 0.01) << "means follow the array";
  stage.mapper->SetPixelsOfError(-1.0);
  EXPECT_EQ(stage.mapper->GetPixelsOfError(), 0.0);
}

TEST_F(Crowd, WhatShowsThroughIsExact)
{
  stage.mapper->SetStructureName("pkd-tree");
  stage.actor->GetProperty()->SetOpacity(0.5);
  const Picture exact = stage.trace();
  stage.mapper->SetPixelsOfError(2.0);
  expectSame(stage.trace(), exact);
}

TEST_F(Crowd, OtherStructuresAreExact)
{
  stage.mapper->SetStructureName("coherent-grid");
  const Picture exact = stage.trace();
  stage.mapper->SetPixelsOfError(2.0);
  expectSame(stage.trace(), exact);
}

TEST_F(Crowd, HiddenParticlesStayHidden)
{
  stage.mapper->SetPixelsOfError(2.0);
  stage.mapper->AddRange("stripes", 0.5, 1.0);
  const Picture half = stage.trace();
  EXPECT_GT(half.covered(), 50);
  for (int p = 0; p < half.count(); ++p)
    if (half.color(p)[3] > 0.0f)
    {
      ASSERT_GT(half.color(p)[0], 0.99) << "a hidden particle's colour is mixed in";
    }
}
