// Colours in the kernels' form, of mappers of any kind and of volume properties.
#include "ArrayColors.h"

#include "kernels/scene/Scene.h"

#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkVolumeProperty.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

/// A mapper of VTK's own over three points with a vector each.
struct ArrayColors : ::testing::Test
{
  vtkNew<vtkPolyData> mesh;
  vtkNew<vtkDoubleArray> vectors;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkLookupTable> table;
  mote::ArrayColors colors;
  decltype(mote::SurfaceObject::coloring) found;

  ArrayColors()
  {
    vtkNew<vtkPoints> points;
    vectors->SetName("velocity");
    vectors->SetNumberOfComponents(3);
    for (int i = 0; i < 3; ++i)
    {
      points->InsertNextPoint(i, 0, 0);
      vectors->InsertNextTuple3(i, 2 * i, 3 * i);
    }
    mesh->SetPoints(points);
    mesh->GetPointData()->AddArray(vectors);
    mapper->SetInputData(mesh);
    mapper->SetLookupTable(table);
    mapper->SetScalarModeToUsePointFieldData();
    mapper->SelectColorArray("velocity");
    mapper->SetScalarRange(0, 6);
    table->SetVectorModeToComponent();
    table->SetVectorComponent(1);
  }
};

} // namespace

TEST_F(ArrayColors, OfAnyMapperAreTheArraysOwnNumbers)
{
  EXPECT_EQ(colors.describe(mapper, mesh, found), "");
  EXPECT_EQ(found.values.data(), vectors->GetVoidPointer(0)) << "nothing is copied";
  EXPECT_EQ(found.component, 1);
  EXPECT_EQ(found.map.lower, 0.0);
  EXPECT_EQ(found.map.upper, 6.0);
  EXPECT_EQ(mote::ArrayColors::valueOf(mapper, vectors, 2), 4.0);
  table->SetVectorModeToMagnitude();
  EXPECT_EQ(colors.describe(mapper, mesh, found), "");
  EXPECT_EQ(found.component, mote::ArrayView::magnitude);
  EXPECT_NEAR(mote::ArrayColors::valueOf(mapper, vectors, 1), std::sqrt(14.0), 1e-12);
}

TEST_F(ArrayColors, ThatOnlyVTKCanMapAreMappedOnce)
{
  table->SetVectorModeToRGBColors();
  EXPECT_EQ(colors.describe(mapper, mesh, found), "");
  ASSERT_EQ(found.direct.count(), 3u);
  const void* mapped = found.direct.data();
  EXPECT_EQ(colors.describe(mapper, mesh, found), "");
  EXPECT_EQ(found.direct.data(), mapped);
}

TEST_F(ArrayColors, OfAnArrayThatIsMissingAreASentence)
{
  mapper->SelectColorArray("nothing");
  EXPECT_EQ(colors.describe(mapper, mesh, found),
    "There is no point array \"nothing\" to colour by; there are: velocity.");
  EXPECT_TRUE(found.values.empty());
  EXPECT_EQ(mote::ArrayColors::arrayOf(mapper, mesh), nullptr);
}

TEST_F(ArrayColors, OfAVolumeFollowItsProperty)
{
  vtkNew<vtkVolumeProperty> property;
  vtkNew<vtkColorTransferFunction> function;
  function->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
  property->SetColor(function);
  const auto red = colors.describe(property).knots.front().color;
  EXPECT_EQ(red.x, 1.0f);
  function->AddRGBPoint(0.0, 0.0, 1.0, 0.0);
  const auto green = colors.describe(property).knots.front().color;
  EXPECT_EQ(green.x, 0.0f);
  EXPECT_EQ(green.y, 1.0f);
}
