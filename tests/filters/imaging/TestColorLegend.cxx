// What vtkMoteColorLegend draws, and where.

#include "ImagingTestTools.h"
#include "vtkMoteColorLegend.h"

#include <vtkColorTransferFunction.h>
#include <vtkIntArray.h>
#include <vtkLookupTable.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVariant.h>

#include <cmath>
#include <cstdlib>

namespace
{

class ColorLegend : public ImagingTest
{
protected:
  void SetUp() override
  {
    unsetenv("DISPLAY");
    ImagingTest::SetUp();
    this->Table->SetRange(0.0, 12.7);
    this->Table->SetUseBelowRangeColor(1);
    this->Table->Build();
    this->Legend->SetLookupTable(this->Table);
  }

  vtkImageData* draw(vtkImageData* image)
  {
    this->Legend->SetInputData(image);
    this->Legend->Update();
    return this->Legend->GetOutput();
  }

  void useRange(double low, double high, bool isLogarithmic = false)
  {
    this->Table->SetRange(low, high);
    this->Table->SetScale(isLogarithmic ? VTK_SCALE_LOG10 : VTK_SCALE_LINEAR);
    this->draw(makeImage(512, 512, 4));
  }

  std::string labels() const
  {
    std::string text;
    for (int i = 0; i < this->Legend->GetNumberOfTicks(); ++i)
      text += (i > 0 ? " " : "") + this->Legend->GetTickLabel(i);
    return text;
  }

  vtkNew<vtkLookupTable> Table;
  vtkNew<vtkMoteColorLegend> Legend;
};

bool isIn(const int r[4], int x, int y)
{
  return x >= r[0] && x <= r[1] && y >= r[2] && y <= r[3];
}

TEST_F(ColorLegend, ChangesOnlyItsRectangles)
{
  this->Legend->SetTitle("a title of many words that has to wrap (km s\u207b\u00b9)");
  this->Legend->SetCaption("a caption");
  this->Legend->SetPanelToOn();
  for (const int size : {64, 256, 700})
  {
    for (const int side : {0, 1})
    {
      this->Legend->SetSide(side);
      auto image = makeImage(size, size, 4);
      auto* before = image->GetPointData()->GetScalars();
      auto* after = this->draw(image)->GetPointData()->GetScalars();
      ASSERT_NE(before, after);
      int changed = 0;
      for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
      {
        const int x = static_cast<int>(i % size);
        const int y = static_cast<int>(i / size);
        bool isSame = true;
        for (int c = 0; c < 4; ++c)
        {
          isSame = isSame && before->GetComponent(i, c) == after->GetComponent(i, c);
          ASSERT_EQ(before->GetComponent(i, c), 1.0); // the input stays
        }
        changed += !isSame;
        ASSERT_TRUE(isSame || isIn(this->Legend->GetLegendRectangle(), x, y) ||
                    isIn(this->Legend->GetCaptionRectangle(), x, y))
          << x << " " << y << " of " << size;
      }
      EXPECT_GT(changed, size);
      const int* r = this->Legend->GetLegendRectangle();
      EXPECT_EQ(r[0] + r[1] > size, side == vtkMoteColorLegend::RIGHT);
    }
  }
}

TEST_F(ColorLegend, BarHasTheTablesColors)
{
  for (const bool isLogarithmic : {false, true})
  {
    this->Table->SetRange(0.5, 500.0);
    this->Table->SetScale(isLogarithmic ? VTK_SCALE_LOG10 : VTK_SCALE_LINEAR);
    auto* output = this->draw(makeImage(512, 512, 4));
    const int* bar = this->Legend->GetBarRectangle();
    ASSERT_GT(bar[3] - bar[2], 200);
    for (int y = bar[2]; y <= bar[3]; ++y)
    {
      const double share = (y - bar[2] + 0.5) / (bar[3] - bar[2] + 1);
      const double value =
        isLogarithmic ? 0.5 * std::pow(1000.0, share) : 0.5 + share * (500.0 - 0.5);
      const unsigned char* rgb = this->Table->MapValue(value);
      for (const int x : {bar[0], bar[1]})
        for (int c = 0; c < 3; ++c)
          ASSERT_NEAR(output->GetScalarComponentAsDouble(x, y, 0, c), rgb[c] / 255.0, 1e-6) << y;
    }
  }
}

TEST_F(ColorLegend, LinearTicksAreRound)
{
  this->useRange(0.0, 12.7);
  EXPECT_EQ(this->labels(), "0 2 4 6 8 10 12");
  this->useRange(0.9991, 1.0008);
  EXPECT_EQ(this->labels(), "0.9995 1.0000 1.0005");
  this->useRange(-2.1e6, 3.4e6);
  EXPECT_EQ(this->labels(), "\u22122 \u22121 0 1 2 3"); // times 10^6
  this->useRange(3.0, 3.0);
  EXPECT_EQ(this->labels(), "3");
  for (const double low : {-1e5, -0.3, 0.0, 1e-9, 17.0})
  {
    for (const double width : {1e-7, 0.7, 33.3, 1.23e8})
    {
      this->useRange(low, low + width);
      const int count = this->Legend->GetNumberOfTicks();
      ASSERT_GE(count, 2) << low << " " << width;
      ASSERT_LE(count, 8);
      const double step = this->Legend->GetTickValue(1) - this->Legend->GetTickValue(0);
      const double mantissa = step / std::pow(10.0, std::floor(std::log10(step) + 1e-3));
      EXPECT_LT(
        std::min({std::abs(mantissa - 1), std::abs(mantissa - 2), std::abs(mantissa - 5)}), 1e-3);
      for (int i = 0; i < count; ++i)
      {
        EXPECT_GE(this->Legend->GetTickValue(i), low);
        EXPECT_LE(this->Legend->GetTickValue(i), low + width);
        EXPECT_TRUE(i == 0 || this->Legend->GetTickLabel(i) != this->Legend->GetTickLabel(i - 1));
      }
    }
  }
}

TEST_F(ColorLegend, LogarithmicTicksArePowers)
{
  this->useRange(0.3, 4000.0, true);
  EXPECT_EQ(this->labels(), "0.3 1 10 100 1000 4000"); // and both ends
  this->useRange(1.0, 60.0, true);
  EXPECT_EQ(this->labels(), "1 2 5 10 20 60"); // 50 is too near to the end
  this->useRange(0.127, 83.83, true);
  EXPECT_EQ(this->labels(), "0.127 1 10 83.8");
  this->useRange(3.25e-5, 4e3, true);
  EXPECT_EQ(this->labels(), "3.25\u00d710\u207b\u2075 10\u207b\u2074 10\u207b\u00b2 10\u2070 "
                            "10\u00b2 4\u00d710\u00b3");
  this->useRange(4.1, 4.9, true); // no power in it
  EXPECT_GE(this->Legend->GetNumberOfTicks(), 3);
  this->useRange(1e-300, 1e300, true);
  EXPECT_GE(this->Legend->GetNumberOfTicks(), 2);
}

TEST_F(ColorLegend, LabelFormat)
{
  this->Legend->SetLabelFormat("%.1f K");
  this->useRange(-1.0, 1.0);
  EXPECT_EQ(this->labels(), "\u22121.0 K \u22120.5 K 0.0 K 0.5 K 1.0 K");
  for (const char* format : {"%s", "%d", "%f %f", "none", "%", "%*f", "%n", "%999999f"})
  {
    this->Messages->Text.clear();
    this->Legend->SetLabelFormat(format);
    this->useRange(0.0, 1.0);
    EXPECT_NE(this->labels().find("0.2"), std::string::npos);
    EXPECT_NE(this->Messages->Text.find("not a format"), std::string::npos) << format;
  }
}

TEST_F(ColorLegend, BadRangesAreReported)
{
  auto* unchanged = this->draw(makeImage(64, 64, 4));
  vtkNew<vtkColorTransferFunction> function;
  function->AddRGBPoint(-1.0, 0, 0, 0);
  function->AddRGBPoint(1.0, 1, 1, 1);
  function->SetScaleToLog10();
  this->Legend->SetLookupTable(function);
  auto image = makeImage(64, 64, 4);
  unchanged = this->draw(image);
  EXPECT_NE(this->Messages->Text.find("logarithmic"), std::string::npos);
  EXPECT_LT(this->Legend->GetLegendRectangle()[1], this->Legend->GetLegendRectangle()[0]);
  EXPECT_EQ(unchanged->GetScalarComponentAsDouble(50, 32, 0, 0), 1.0);
}

TEST_F(ColorLegend, Categories)
{
  this->Table->SetNumberOfTableValues(3);
  for (int i = 0; i < 3; ++i)
  {
    this->Table->SetTableValue(i, 0.2 * i, 0.4, 0.6, 0.5);
    this->Table->SetAnnotation(vtkVariant(10 * i), i == 1 ? "" : i == 0 ? "water" : "ice");
  }
  this->Table->IndexedLookupOn();
  auto* output = this->draw(makeImage(512, 512, 4));
  EXPECT_EQ(this->labels(), "water 10 ice");
  EXPECT_EQ(this->Legend->GetTickValue(2), 20.0);
  const int* bar = this->Legend->GetBarRectangle();
  for (const int top : {0, 1})
  {
    const int x = (bar[0] + bar[1]) / 2;
    const int y = top ? bar[3] : bar[2];
    EXPECT_NEAR(output->GetScalarComponentAsDouble(x, y, 0, 0), top ? 0.0 : 0.4, 0.003);
    EXPECT_NEAR(output->GetScalarComponentAsDouble(x, y, 0, 2), 0.6, 0.003);
  }
}

TEST_F(ColorLegend, PassesOtherArraysAndKinds)
{
  auto image = makeImage(300, 200, 4);
  vtkNew<vtkIntArray> ids;
  ids->SetName("particle");
  ids->SetNumberOfTuples(300 * 200);
  ids->Fill(7);
  image->GetPointData()->AddArray(ids);
  auto* output = this->draw(image);
  EXPECT_EQ(output->GetPointData()->GetArray("particle"), ids.Get());
  EXPECT_STREQ(output->GetPointData()->GetScalars()->GetName(), "color");
  this->Legend->SetLookupTable(nullptr);
  EXPECT_EQ(this->draw(image)->GetPointData()->GetScalars(), image->GetPointData()->GetScalars());
  this->Legend->SetLookupTable(this->Table);
  vtkNew<vtkImageData> bytes;
  bytes->SetDimensions(256, 256, 1);
  bytes->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  bytes->GetPointData()->GetScalars()->Fill(255);
  output = this->draw(bytes);
  EXPECT_EQ(output->GetScalarType(), VTK_UNSIGNED_CHAR);
  const int* bar = this->Legend->GetBarRectangle();
  const unsigned char* rgb = this->Table->MapValue(0.001);
  EXPECT_EQ(output->GetScalarComponentAsDouble(bar[0], bar[2], 0, 0), rgb[0]);
}

TEST_F(ColorLegend, TextStandsOut)
{
  for (const float behind : {0.0f, 0.5f, 1.0f})
  {
    auto image = makeImage(512, 512, 4);
    for (int c = 0; c < 3; ++c)
      image->GetPointData()->GetScalars()->FillComponent(c, behind);
    this->Legend->SetTitle("title");
    auto* output = this->draw(image);
    const int* r = this->Legend->GetLegendRectangle();
    double darkest = 1.0;
    double lightest = 0.0;
    for (int y = this->Legend->GetBarRectangle()[3] + 5; y <= r[3]; ++y) // the title
    {
      for (int x = r[0]; x <= r[1]; ++x)
      {
        const double value = output->GetScalarComponentAsDouble(x, y, 0, 1);
        darkest = std::min(darkest, value);
        lightest = std::max(lightest, value);
      }
    }
    EXPECT_GT(lightest - darkest, 0.4) << behind;
  }
}

TEST_F(ColorLegend, TransparentPixelsBecomeOpaqueUnderTheBar)
{
  auto image = makeImage(256, 256, 4);
  image->GetPointData()->GetScalars()->Fill(0.0);
  auto* output = this->draw(image);
  const int* bar = this->Legend->GetBarRectangle();
  EXPECT_EQ(output->GetScalarComponentAsDouble(bar[0], bar[2], 0, 3), 1.0);
  EXPECT_EQ(output->GetScalarComponentAsDouble(0, 0, 0, 3), 0.0);
}

TEST_F(ColorLegend, FollowsItsTableAndCountsMissingCharacters)
{
  this->draw(makeImage(256, 256, 4));
  this->Table->SetRange(0.0, 1.0);
  this->Legend->Update();
  EXPECT_EQ(this->Legend->GetTickValue(this->Legend->GetNumberOfTicks() - 1), 1.0);
  this->Legend->SetTitle("\U00012345 \xff");
  this->Legend->Update();
  EXPECT_NE(this->Messages->Text.find("No font has"), std::string::npos);
}

TEST_F(ColorLegend, TinyImagesAndLongTexts)
{
  this->Legend->SetTitle(std::string(2000, 'w') + " (m)");
  this->Legend->SetCaption(std::string(3000, 'x') + "\n\n\n\nlast");
  for (const int size : {1, 2, 7, 31})
  {
    this->draw(makeImage(size, size, 4));
    this->draw(makeImage(size, 3 * size, 3));
    this->draw(makeImage(50 * size, size, 4));
  }
  EXPECT_EQ(this->Messages->Text, "");
}

} // namespace
