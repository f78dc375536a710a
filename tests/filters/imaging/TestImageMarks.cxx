// What vtkMoteImageMarks draws, and what hides it.

#include "ImagingTestTools.h"
#include "vtkMoteImageMarks.h"

#include <cstdlib>
#include <limits>

namespace
{

constexpr double red[3] = {1.0, 0.0, 0.0};

class ImageMarks : public ImagingTest
{
protected:
  static constexpr int Size = 100;

  void SetUp() override
  {
    unsetenv("DISPLAY");
    ImagingTest::SetUp();
    this->Image = makeImage(Size, Size, 4);
    vtkNew<vtkFloatArray> depth;
    depth->SetName("depth");
    for (int i = 0; i < Size * Size; ++i) // a wall at 10 fills the right half
      depth->InsertNextValue(i % Size < 50 ? std::numeric_limits<float>::infinity() : 10.0f);
    this->Image->GetPointData()->AddArray(depth);
    this->Marks->SetInputData(this->Image);
  }

  /// Pixels of columns from x0 to x1, both included, that are no paper.
  int drawn(int x0, int x1)
  {
    this->Marks->Update();
    vtkImageData* image = this->Marks->GetOutput();
    int count = 0;
    for (int y = 0; y < Size; ++y)
      for (int x = x0; x <= x1; ++x)
        count += image->GetScalarComponentAsDouble(x, y, 0, 1) < 0.9;
    return count;
  }

  void line(double fromDepth, double toDepth, bool onTop = false)
  {
    const double from[3] = {0.0, 50.0, fromDepth}, to[3] = {100.0, 50.0, toDepth};
    this->Marks->RemoveAll();
    this->Marks->AddLine(from, to, red, 2.0, onTop);
  }

  vtkSmartPointer<vtkImageData> Image;
  vtkNew<vtkMoteImageMarks> Marks;
};

TEST_F(ImageMarks, WithoutMarksTheImagePasses)
{
  this->Marks->Update();
  EXPECT_EQ(this->Marks->GetOutput()->GetPointData()->GetScalars(),
    this->Image->GetPointData()->GetScalars());
}

TEST_F(ImageMarks, LinesAreHiddenByWhatIsNearer)
{
  this->line(20.0, 20.0);
  EXPECT_GE(this->drawn(1, 49), 98);
  EXPECT_EQ(this->drawn(50, 99), 0);
  this->line(20.0, 20.0, true);
  EXPECT_GE(this->drawn(50, 98), 98);
  this->line(5.0, 5.0);
  EXPECT_GE(this->drawn(50, 98), 98);
}

TEST_F(ImageMarks, DistancesAlongALineAreThoseOfTheProjection)
{
  // From 20 to 6: a parallel view passes the wall's 10 at 71 %, one in perspective at 43 %.
  this->line(20.0, 6.0);
  this->Marks->ParallelProjectionOn();
  EXPECT_EQ(this->drawn(52, 69), 0);
  EXPECT_GE(this->drawn(74, 97), 46);
  this->Marks->ParallelProjectionOff();
  EXPECT_GE(this->drawn(50, 97), 94);
}

TEST_F(ImageMarks, BallsAreRoundAndLetThroughWhatTheyAreToldTo)
{
  const double middle[3] = {25.0, 50.0, 5.0};
  this->Marks->AddBall(middle, 10.0, 1.0, red, 0.5);
  const int inside = this->drawn(0, 49);
  EXPECT_NEAR(inside, 3.14159 * 100.0, 25.0);
  // Half of the paper is seen through the middle.
  EXPECT_NEAR(this->Marks->GetOutput()->GetScalarComponentAsDouble(25, 50, 0, 1), 0.5, 0.02);
  this->Marks->RemoveAll();
  const double behind[3] = {75.0, 50.0, 12.0};
  this->Marks->AddBall(behind, 10.0, 1.0, red, 0.5);
  EXPECT_EQ(this->drawn(0, 99), 0);
  this->Marks->AddBall(behind, 10.0, 5.0, red, 0.5); // its front is before the wall
  EXPECT_GT(this->drawn(0, 99), 100);
}

TEST_F(ImageMarks, LabelsStandAboveOrBelow)
{
  const double place[2] = {50.0, 50.0};
  this->Marks->AddLabel(place, "1.25", red, false);
  const auto rowsOf = [&]
  {
    this->Marks->Update();
    int low = Size, high = 0;
    for (int y = 0; y < Size; ++y)
      for (int x = 0; x < Size; ++x)
        if (this->Marks->GetOutput()->GetScalarComponentAsDouble(x, y, 0, 1) < 0.9)
          low = std::min(low, y), high = std::max(high, y);
    return std::make_pair(low, high);
  };
  EXPECT_GE(rowsOf().first, 50);
  EXPECT_GT(rowsOf().second, 58);
  this->Marks->RemoveAll();
  this->Marks->AddLabel(place, "1.25", red, true);
  EXPECT_LT(rowsOf().second, 50);
}

} // namespace
