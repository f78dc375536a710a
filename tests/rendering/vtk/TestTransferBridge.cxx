// The functions of a vtkVolumeProperty against what the kernels make of them.
#include "TransferBridge.h"

#include "vtkColorTransferFunction.h"
#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

/// The knots' own lines, as TransferFunction says they run.
mote::Vec4d at(const mote::TransferFunction& f, double value)
{
  const auto& knots = f.knots;
  if (value < knots.front().value)
    return mote::Vec4d(knots.front().color);
  for (std::size_t i = knots.size(); i-- > 0;)
    if (knots[i].value <= value)
    {
      if (i + 1 == knots.size())
        return mote::Vec4d(knots[i].color);
      const double share = (value - knots[i].value) / (knots[i + 1].value - knots[i].value);
      return glm::mix(mote::Vec4d(knots[i].color), mote::Vec4d(knots[i + 1].color), share);
    }
  return {};
}

struct Transfer : ::testing::Test
{
  vtkNew<vtkVolumeProperty> property;
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkPiecewiseFunction> opacity;

  Transfer()
  {
    property->SetColor(color);
    property->SetScalarOpacity(opacity);
  }

  /// The greatest differences of colour and of opacity over many values from `low` to `high`.
  std::pair<double, double> errors(double low, double high)
  {
    const mote::TransferFunction f = mote::transferOf(property);
    EXPECT_TRUE(std::is_sorted(f.knots.begin(), f.knots.end(),
      [](const auto& a, const auto& b) { return a.value < b.value; }));
    std::pair<double, double> worst(0, 0);
    for (int i = 0; i <= 10007; ++i)
    {
      const double value = low + (high - low) * i / 10007;
      double rgb[3];
      color->GetColor(value, rgb);
      const mote::Vec4d mine = at(f, value);
      for (int k = 0; k < 3; ++k)
        worst.first = std::max(worst.first, std::abs(mine[k] - rgb[k]));
      worst.second = std::max(worst.second, std::abs(mine.w - opacity->GetValue(value)));
    }
    return worst;
  }
};

} // namespace

TEST_F(Transfer, NodesOfBothAreKnots)
{
  color->AddRGBPoint(0, 1, 0, 0);
  color->AddRGBPoint(2, 0, 1, 0);
  color->AddRGBPoint(5, 0, 0, 1);
  opacity->AddPoint(1, 0);
  opacity->AddPoint(2, 0.5);
  opacity->AddPoint(7, 1);
  property->SetScalarOpacityUnitDistance(0.125);
  const mote::TransferFunction f = mote::transferOf(property);
  EXPECT_EQ(f.unitDistance, 0.125);
  std::vector<double> values;
  for (const auto& knot : f.knots)
    values.push_back(knot.value);
  EXPECT_EQ(values, (std::vector<double>{0, 1, 2, 5, 7}));
  EXPECT_LT(glm::length(f.knots[1].color - mote::Vec4f(0.5, 0.5, 0, 0)), 1e-6);
  EXPECT_LT(glm::length(f.knots[2].color - mote::Vec4f(0, 1, 0, 0.5)), 1e-6);
  EXPECT_LT(errors(-1, 9).first, 1e-6);
  EXPECT_LT(errors(-1, 9).second, 1e-6);
}

TEST_F(Transfer, CurvesAreFollowed)
{
  opacity->AddPoint(0, 0, 0.3, 0.7);
  opacity->AddPoint(3, 0.9, 0.5, 0.2);
  opacity->AddPoint(10, 0.1);
  const auto spaces = {VTK_CTF_RGB, VTK_CTF_HSV, VTK_CTF_LAB, VTK_CTF_DIVERGING};
  for (const int space : spaces)
  {
    color->RemoveAllPoints();
    color->SetColorSpace(space);
    color->AddRGBPoint(0, 0.23, 0.3, 0.75, 0.4, 0.3);
    color->AddRGBPoint(4, 0.86, 0.86, 0.6);
    color->AddRGBPoint(10, 0.7, 0.02, 0.15);
    const auto [inColor, inOpacity] = errors(-1, 11);
    EXPECT_LT(inColor, 1e-3) << space;
    EXPECT_LT(inOpacity, 1e-4) << space;
    EXPECT_LT(mote::transferOf(property).knots.size(), 2000U) << space;
  }
}

TEST_F(Transfer, LogarithmicColors)
{
  color->SetScaleToLog10();
  color->AddRGBPoint(0.01, 0, 0, 1);
  color->AddRGBPoint(1, 1, 1, 0);
  color->AddRGBPoint(1000, 1, 0, 0);
  opacity->AddPoint(0.01, 0.1);
  opacity->AddPoint(1000, 1);
  EXPECT_LT(errors(0.01, 3).first, 1e-3);
  EXPECT_LT(errors(0.01, 1200).first, 1e-3);
}

TEST_F(Transfer, JumpsStayJumps)
{
  color->AddRGBPoint(0, 0.5, 0.5, 0.5);
  opacity->AllowDuplicateScalarsOn();
  opacity->AddPoint(0, 0.1);
  opacity->AddPoint(2, 0.1);
  opacity->AddPoint(2, 0.8);
  opacity->AddPoint(4, 0.8, 0.5, 1.0); // then even on both sides of the middle
  opacity->AddPoint(6, 0.2);
  const mote::TransferFunction f = mote::transferOf(property);
  EXPECT_NEAR(at(f, 2 - 1e-9).w, 0.1, 1e-6);
  EXPECT_NEAR(at(f, 2 + 1e-9).w, 0.8, 1e-6);
  EXPECT_NEAR(at(f, 5 - 1e-5).w, 0.8, 1e-6);
  EXPECT_NEAR(at(f, 5 + 1e-5).w, 0.2, 1e-6);
}

TEST_F(Transfer, WithoutClampingNothingIsOutside)
{
  color->AddRGBPoint(0, 1, 1, 1);
  color->AddRGBPoint(2, 1, 1, 1);
  opacity->AddPoint(0.5, 0.5);
  opacity->AddPoint(1.5, 0.5);
  opacity->ClampingOff();
  color->ClampingOff();
  const mote::TransferFunction f = mote::transferOf(property);
  for (const double value : {-5.0, 0.4999, 1.5001, 9.0})
    EXPECT_EQ(at(f, value).w, 0) << value;
  EXPECT_NEAR(at(f, 0.5001).w, 0.5, 1e-6);
  EXPECT_NEAR(at(f, 1.4999).w, 0.5, 1e-6);
  EXPECT_EQ(at(f, -1).x, 0);
  EXPECT_EQ(at(f, 0.001).x, 1);
  EXPECT_EQ(at(f, 3).x, 0);
}

TEST_F(Transfer, ColorsInSteps)
{
  vtkNew<vtkDiscretizableColorTransferFunction> steps;
  steps->AddRGBPoint(0, 0, 0, 1);
  steps->AddRGBPoint(1, 1, 0, 0);
  steps->DiscretizeOn();
  steps->SetNumberOfValues(5);
  steps->Build();
  property->SetColor(steps);
  opacity->AddPoint(0, 0.5);
  const mote::TransferFunction f = mote::transferOf(property);
  for (int i = 0; i < 100; ++i)
  {
    double rgb[3];
    steps->GetColor((i + 0.5) / 100, rgb);
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(at(f, (i + 0.5) / 100)[k], rgb[k], 1e-3) << i;
  }
}

TEST_F(Transfer, GrayAndEmptyFunctions)
{
  vtkNew<vtkPiecewiseFunction> gray;
  property->SetColor(gray);
  const mote::TransferFunction empty = mote::transferOf(property);
  ASSERT_EQ(empty.knots.size(), 1U);
  EXPECT_EQ(empty.knots[0].color, mote::Vec4f(0.0f));
  gray->AddPoint(0, 0);
  gray->AddPoint(10, 1);
  opacity->AddPoint(0, 0.25);
  const mote::Vec4d middle = at(mote::transferOf(property), 4);
  EXPECT_LT(glm::length(middle - mote::Vec4d(0.4, 0.4, 0.4, 0.25)), 1e-6);
}
