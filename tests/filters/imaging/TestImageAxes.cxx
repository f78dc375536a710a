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
