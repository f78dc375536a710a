// What vtkMoteImageAxes draws, and where.

#include "ImagingTestTools.h"
#include "vtkMoteImageAxes.h"

#include <vtkDoubleArray.h>

#include <cmath>
#include <cstdlib>

namespace
{

class ImageAxes : public ImagingTest
{
protected:
  static constexpr int Width = 640, Height = 480;

  void SetUp() override
  {
    unsetenv("DISPLAY");
    ImagingTest::SetUp();
    this->Axes->SetFrame(100, 599, 90, 459);
    this->Axes->SetInputData(makeImage(Width, Height, 4));
  }

  vtkImageData* draw()
  {
    this->Axes->Update();
    return this->Axes->GetOutput();
  }

  /// Pixels of a rectangle, both ends included, that are no paper.
  static int drawnIn(vtkImageData* image, int x0, int x1, int y0, int y1)
  {
    int count = 0;
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x)
        count += image->GetScalarComponentAsDouble(x, y, 0, 0) < 0.99;
    return count;
  }

  vtkNew<vtkMoteImageAxes> Axes;
};

TEST_F(ImageAxes, TicksAreRoundAndWithinTheRanges)
{
  this->Axes->SetXRange(-0.013, 0.094);
  this->Axes->SetYRange(2e5, 2.7e6);
  this->draw();
  ASSERT_GE(this->Axes->GetNumberOfXTicks(), 3);
  ASSERT_GE(this->Axes->GetNumberOfYTicks(), 3);
  for (int i = 0; i < this->Axes->GetNumberOfXTicks(); ++i)
  {
    EXPECT_GE(this->Axes->GetXTickValue(i), -0.013);
    EXPECT_LE(this->Axes->GetXTickValue(i), 0.094);
    EXPECT_NEAR(std::remainder(this->Axes->GetXTickValue(i), 0.01), 0.0, 1e-9);
  }
  // Long numbers leave their power to the title.
  EXPECT_LE(this->Axes->GetYTickLabel(0).size(), 4u);
  EXPECT_TRUE(std::isnan(this->Axes->GetXTickValue(-1)));
  EXPECT_EQ(this->Axes->GetYTickLabel(1000), "");
}

TEST_F(ImageAxes, DrawsAroundTheFrameAndNotInIt)
{
  vtkImageData* image = this->draw();
  EXPECT_EQ(drawnIn(image, 100, 599, 90, 459), 0);
  EXPECT_EQ(drawnIn(image, 99, 99, 90, 459), 370); // the frame
  EXPECT_EQ(drawnIn(image, 100, 599, 89, 89), 500);
  EXPECT_EQ(drawnIn(image, 600, 600, 90, 459), 370);
  EXPECT_EQ(drawnIn(image, 100, 599, 460, 460), 500);
  const int left = drawnIn(image, 0, 97, 60, Height - 1),
            below = drawnIn(image, 0, Width - 1, 0, 87);
  EXPECT_GT(left, 100); // numbers
  EXPECT_GT(below, 100);
  this->Axes->SetXTitle("radius (m)");
  this->Axes->SetYTitle("pressure (Pa)");
  image = this->draw();
  EXPECT_GT(drawnIn(image, 0, Width - 1, 0, 87), below + 50);
  EXPECT_GT(drawnIn(image, 0, 97, 60, Height - 1), left + 50);
}

TEST_F(ImageAxes, TheTitleOfTheUprightAxisIsTurned)
{
  vtkImageData* image = this->draw();
  const int before = drawnIn(image, 0, 60, 90, 459);
  this->Axes->SetYTitle("a long title of many letters");
  image = this->draw();
  int highest = 0, lowest = Height, leftmost = Width, rightmost = 0;
  for (int y = 0; y < Height; ++y)
    for (int x = 0; x < 60; ++x)
      if (image->GetScalarComponentAsDouble(x, y, 0, 0) < 0.5)
      {
        highest = std::max(highest, y);
        lowest = std::min(lowest, y);
        leftmost = std::min(leftmost, x);
        rightmost = std::max(rightmost, x);
      }
  EXPECT_GT(drawnIn(image, 0, 60, 90, 459), before);
  EXPECT_GT(highest - lowest, 100);
  EXPECT_LT(rightmost - leftmost, 60);
}

TEST_F(ImageAxes, CurvesRunThroughTheirPointsAndStopAtGaps)
{
  vtkNew<vtkDoubleArray> x, y;
  for (int i = 0; i <= 100; ++i)
  {
    x->InsertNextValue(0.01 * i);
    y->InsertNextValue(i > 40 && i < 60 ? std::nan("") : 0.01 * i);
  }
  this->Axes->AddCurve(x, y, 1.0, 0.0, 0.0);
  vtkImageData* image = this->draw();
  const auto isRed = [&](double a, double b)
  {
    const int px = 100 + static_cast<int>(a * 500), py = 90 + static_cast<int>(b * 370);
    return image->GetScalarComponentAsDouble(px, py, 0, 0) > 0.9 &&
           image->GetScalarComponentAsDouble(px, py, 0, 1) < 0.1;
  };
  for (const double at : {0.05, 0.2, 0.35, 0.65, 0.8, 0.95})
    EXPECT_TRUE(isRed(at, at)) << at;
  EXPECT_EQ(drawnIn(image, 100 + 210, 100 + 290, 90, 459), 0); // the gap
  EXPECT_FALSE(isRed(0.2, 0.8));
  this->Axes->RemoveAllCurves();
  EXPECT_EQ(drawnIn(this->draw(), 100, 599, 90, 459), 0);
}

TEST_F(ImageAxes, CurvesStayInTheFrame)
{
  vtkNew<vtkDoubleArray> x, y;
  for (const double value : {-3.0, 3.0}) // through the middle, and far out
  {
    x->InsertNextValue(0.5 + value);
    y->InsertNextValue(1e6 * value);
  }
  vtkImageData* image = this->draw();
  const int around = drawnIn(image, 0, Width - 1, 0, Height - 1);
  this->Axes->AddCurve(x, y, 0.0, 0.0, 1.0);
  image = this->draw();
  const int inside = drawnIn(image, 100, 599, 90, 459);
  EXPECT_GT(inside, 300);
  EXPECT_EQ(drawnIn(image, 0, Width - 1, 0, Height - 1), around + inside);
}

TEST_F(ImageAxes, NamesStandBesideTheirCurves)
{
  vtkNew<vtkDoubleArray> x, y;
  for (const double value : {0.2, 0.8})
  {
    x->InsertNextValue(value);
    y->InsertNextValue(value);
  }
  this->Axes->SetFrame(100, 449, 90, 459);
  this->Axes->SetNamesFrame(460, 639, 90, 459);
  EXPECT_EQ(drawnIn(this->draw(), 460, 639, 90, 459), 0);
  this->Axes->AddNamedCurve("first", x, y, 1.0, 0.0, 0.0, false);
  const int one = drawnIn(this->draw(), 460, 639, 90, 459);
  EXPECT_GT(one, 50);
  this->Axes->AddNamedCurve("second", x, y, 0.0, 0.0, 1.0, true);
  EXPECT_GT(drawnIn(this->draw(), 460, 639, 90, 459), one + 50);
  const std::string& svg = this->Axes->GetSvgElements();
  EXPECT_NE(svg.find(">first</text>"), std::string::npos);
  EXPECT_NE(svg.find("<title>second</title>"), std::string::npos);
  // More than there is room for are counted.
  for (int i = 0; i < 98; ++i)
    this->Axes->AddNamedCurve("more", x, y, 0.0, 0.0, 1.0, false);
  this->draw();
  EXPECT_NE(this->Axes->GetSvgElements().find(" more</text>"), std::string::npos);
  EXPECT_EQ(this->Axes->GetSvgElements().find(">and 98 more"), std::string::npos);
}

TEST_F(ImageAxes, SvgHasTheSameElements)
{
  vtkNew<vtkDoubleArray> x, y;
  for (const double value : {0.0, 0.25, std::nan(""), 0.75, 1.0})
  {
    x->InsertNextValue(std::isnan(value) ? 0.5 : value);
    y->InsertNextValue(value);
  }
  this->Axes->AddNamedCurve("a < b & c", x, y, 1.0, 0.0, 0.0, false);
  this->Axes->SetXTitle("time (s)");
  this->draw();
  const std::string svg = this->Axes->GetSvgElements();
  // From the lower left corner of the frame, with a gap.
  EXPECT_NE(svg.find("points=\"100,390 225,297.5\""), std::string::npos) << svg;
  EXPECT_NE(svg.find("points=\"475,112.5 600,20\""), std::string::npos) << svg;
  EXPECT_NE(svg.find("stroke=\"#ff0000\""), std::string::npos);
  EXPECT_NE(svg.find("<title>a &lt; b &amp; c</title>"), std::string::npos);
  EXPECT_NE(svg.find(">time (s)</text>"), std::string::npos);
  EXPECT_EQ(svg.find("<circle"), std::string::npos);
  this->Axes->DotsOn();
  this->draw();
  EXPECT_NE(
    this->Axes->GetSvgElements().find("<circle cx=\"225\" cy=\"297.5\""), std::string::npos);
  this->Axes->XLabelsOff();
  this->draw();
  EXPECT_EQ(this->Axes->GetSvgElements().find(">time (s)</text>"), std::string::npos);
}

TEST_F(ImageAxes, DashesAndGridsAreSeen)
{
  vtkNew<vtkDoubleArray> x, y;
  for (const double value : {0.0, 1.0})
  {
    x->InsertNextValue(value);
    y->InsertNextValue(0.43); // between lines of the grid
  }
  this->Axes->AddNamedCurve("", x, y, 0.0, 0.0, 1.0, false);
  const int whole = drawnIn(this->draw(), 100, 599, 90, 459);
  this->Axes->RemoveAllCurves();
  this->Axes->AddNamedCurve("", x, y, 0.0, 0.0, 1.0, true);
  const int dashed = drawnIn(this->draw(), 100, 599, 90, 459);
  EXPECT_GT(dashed, 0.4 * whole);
  EXPECT_LT(dashed, 0.75 * whole);
  this->Axes->GridOn();
  EXPECT_GT(drawnIn(this->draw(), 100, 599, 90, 459), dashed + 3 * 400);
}

TEST_F(ImageAxes, ReportsWhatCannotBeDrawn)
{
  this->Axes->SetXRange(1.0, 1.0);
  this->draw();
  EXPECT_NE(this->Messages->Text.find("from less to more"), std::string::npos);
  this->Axes->SetXRange(0.0, 1.0);
  this->Axes->SetFrame(10, 5, 0, 10);
  this->Messages->Text.clear();
  this->draw();
  EXPECT_NE(this->Messages->Text.find("rectangle"), std::string::npos);
}

} // namespace
