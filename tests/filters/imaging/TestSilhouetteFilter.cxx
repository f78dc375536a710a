// The filter agrees with the kernel however the image is divided, takes any type of array, draws
// over colours, and refuses what it cannot take in a sentence.

#include "ImagingTestTools.h"

#include <vtkMoteSilhouetteFilter.h>
#include <vtkMoteSilhouettes.h>

#include <kernels/imaging/Silhouettes.h>

#include <vtkDoubleArray.h>
#include <vtkImageTranslateExtent.h>
#include <vtkIntArray.h>
#include <vtkTrivialProducer.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace
{

constexpr int Width = 203, Height = 151;

/// Random discs at random depths before nothing, as depths along the view axis; discs are numbered.
vtkSmartPointer<vtkImageData> discs()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Width, Height, 1);
  vtkNew<vtkFloatArray> depth;
  vtkNew<vtkIntArray> object;
  depth->SetName("depth");
  object->SetName("object");
  depth->SetNumberOfValues(image->GetNumberOfPoints());
  object->SetNumberOfValues(image->GetNumberOfPoints());
  depth->Fill(std::numeric_limits<float>::infinity());
  object->Fill(-1);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  for (int k = 0; k < 60; ++k)
  {
    const float x = uniform(random) * Width, y = uniform(random) * Height;
    const float radius = 5.0f + 15.0f * uniform(random), z = 50.0f + 20.0f * uniform(random);
    for (int j = 0; j < Height; ++j)
    {
      for (int i = 0; i < Width; ++i)
      {
        const vtkIdType at = static_cast<vtkIdType>(j) * Width + i;
        if (std::hypot(i - x, j - y) < radius && z < depth->GetValue(at))
        {
          depth->SetValue(at, z);
          object->SetValue(at, k);
        }
      }
    }
  }
  image->GetPointData()->AddArray(depth);
  image->GetPointData()->AddArray(object);
  return image;
}

std::vector<float> valuesOf(vtkImageData* image, const char* name)
{
  auto* array = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray(name));
  if (!array)
    return {};
  return {array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues()};
}

vtkSmartPointer<vtkMoteSilhouetteFilter> filterOf(vtkImageData* image)
{
  auto filter = vtkSmartPointer<vtkMoteSilhouetteFilter>::New();
  filter->SetInputData(image);
  filter->GetSilhouettes()->SetThresholdModeToWorld();
  filter->GetSilhouettes()->SetThreshold(1.5);
  filter->GetSilhouettes()->SetThickness(1.0);
  return filter;
}

std::vector<float> silhouettesOf(vtkMoteSilhouetteFilter* filter)
{
  filter->Update();
  EXPECT_EQ(filter->GetErrorMessage(), "");
  return valuesOf(filter->GetOutput(), "silhouettes");
}

} // namespace

class SilhouetteFilter : public ImagingTest
{
};

TEST_F(SilhouetteFilter, AgreesWithTheKernel)
{
  const auto image = discs();
  const auto depth = valuesOf(image, "depth");
  mote::DepthImage kernel;
  kernel.width = Width;
  kernel.height = Height;
  kernel.depth = depth.data();
  kernel.dx = kernel.dy = 2.0 * std::tan(20.0 * M_PI / 180.0) / Height;
  kernel.x0 = -0.5 * Width * kernel.dx;
  kernel.y0 = -0.5 * Height * kernel.dy;
  mote::SilhouetteOptions options;
  options.step = 1.5;
  std::vector<float> expected(depth.size(), 0.0f);
  mote::findSilhouettes(kernel, options, expected.data());
  const auto filter = filterOf(image);
  filter->SetViewAngle(40.0);
  EXPECT_EQ(silhouettesOf(filter), expected);
  EXPECT_STREQ(filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "silhouettes");
  EXPECT_EQ(filter->GetStep(), 1.5);
}

TEST_F(SilhouetteFilter, TakesWhatPassesTake)
{
  const auto image = discs();
  vtkNew<vtkMoteSilhouettes> shared;
  EXPECT_FALSE(shared->GetEnabled());
  shared->SetThresholdModeToWorld();
  shared->SetThreshold(1.5);
  shared->SetThickness(4.0);
  shared->SetLeastThickness(0.5); // a share, as in a pass
  const auto filter = filterOf(image);
  const auto own = silhouettesOf(filter);
  const std::vector<float> none(own.size(), 0.0f);
  filter->SetSilhouettes(shared);
  EXPECT_EQ(silhouettesOf(filter), none);
  shared->EnabledOn();
  const auto graded = silhouettesOf(filter);
  const auto sum = [](const std::vector<float>& all)
  { return std::accumulate(all.begin(), all.end(), 0.0); };
  EXPECT_GT(sum(graded), 2.0 * sum(own));
  shared->SetLeastThickness(1.0);
  EXPECT_LT(sum(graded), sum(silhouettesOf(filter)));
  filter->SetSilhouettes(nullptr);
  EXPECT_EQ(silhouettesOf(filter), none);
  EXPECT_EQ(filter->GetStep(), 0.0);
  filter->SetOutputModeToOverlay();
  filter->Update();
  EXPECT_EQ(filter->GetErrorMessage(), "");
}

TEST_F(SilhouetteFilter, ThreadsAndPiecesMakeNoDifference)
{
  const auto filter = filterOf(discs());
  filter->GetSilhouettes()->SetThickness(4.0);
  filter->GetSilhouettes()->SetLeastThickness(0.25);
  filter->GetSilhouettes()->SetLeastOpacity(0.1);
  filter->GetSilhouettes()->SetGroupArrayName("object");
  for (const int factor : {1, 3})
  {
    filter->SetReductionFactor(factor);
    filter->SetNumberOfThreads(1);
    const auto expected = silhouettesOf(filter);
    ASSERT_FALSE(expected.empty());
    for (const int threads : {2, 7})
    {
      filter->SetNumberOfThreads(threads);
      filter->SetSplitModeToBlock();
      EXPECT_EQ(silhouettesOf(filter), expected) << threads;
    }
    filter->SetEnableSMP(true);
    filter->Modified();
    EXPECT_EQ(silhouettesOf(filter), expected);
    filter->SetEnableSMP(false);
    // A piece of the image, out of no more of the input than it asks for.
    vtkNew<vtkMoteSilhouetteFilter> part;
    const int width = (Width + factor - 1) / factor, height = (Height + factor - 1) / factor;
    int piece[6] = {width / 3, width / 2, height / 4, height / 2, 0, 0};
    filter->Modified();
    filter->UpdateExtent(piece);
    vtkImageData* output = filter->GetOutput();
    ASSERT_EQ(output->GetExtent()[0], piece[0]);
    for (int y = piece[2]; y <= piece[3]; ++y)
      for (int x = piece[0]; x <= piece[1]; ++x)
        ASSERT_EQ(output->GetScalarComponentAsFloat(x, y, 0, 0), expected[y * width + x]);
  }
}

TEST_F(SilhouetteFilter, ExtentsMayBeginAnywhere)
{
  const auto image = discs();
  const auto filter = filterOf(image);
  filter->SetReductionFactor(2);
  const auto expected = silhouettesOf(filter);
  vtkNew<vtkImageTranslateExtent> moved;
  moved->SetInputData(image);
  moved->SetTranslation(-7, 11, 3);
  filter->SetInputConnection(moved->GetOutputPort());
  EXPECT_EQ(silhouettesOf(filter), expected);
  EXPECT_EQ(filter->GetOutput()->GetExtent()[0], -7);
  EXPECT_EQ(filter->GetOutput()->GetExtent()[5], 3);
}

TEST_F(SilhouetteFilter, ReducedPixelsLieInTheMiddleOfThoseTheyStandFor)
{
  const auto image = discs();
  image->SetSpacing(2.0, 3.0, 1.0);
  image->SetOrigin(10.0, 20.0, 5.0);
  const auto filter = filterOf(image);
  filter->SetReductionFactor(4);
  filter->Update();
  double first[3], second[3];
  filter->GetOutput()->GetPoint(0, first);
  filter->GetOutput()->GetPoint(1, second);
  EXPECT_DOUBLE_EQ(first[0], 10.0 + 1.5 * 2.0);
  EXPECT_DOUBLE_EQ(first[1], 20.0 + 1.5 * 3.0);
  EXPECT_DOUBLE_EQ(second[0] - first[0], 8.0);
  EXPECT_EQ(filter->GetOutput()->GetDimensions()[0], 51);
  EXPECT_EQ(filter->GetOutput()->GetDimensions()[1], 38);
}

TEST_F(SilhouetteFilter, DepthsMayBeOfAnyTypeAndName)
{
  const auto image = discs();
  const auto expected = silhouettesOf(filterOf(image));
  vtkDataArray* depth = image->GetPointData()->GetArray("depth");
  vtkNew<vtkDoubleArray> wide;
  wide->DeepCopy(depth);
  wide->SetName("range");
  image->GetPointData()->AddArray(wide);
  const auto named = filterOf(image);
  named->SetDepthArrayName("range");
  EXPECT_EQ(silhouettesOf(named), expected);
  // Without the array "depth": the scalars. Whole numbers have no infinity.
  vtkNew<vtkIntArray> whole;
  whole->SetNumberOfValues(wide->GetNumberOfValues());
  for (vtkIdType i = 0; i < wide->GetNumberOfValues(); ++i)
  {
    const double v = wide->GetValue(i);
    whole->SetValue(i, std::isfinite(v) ? static_cast<int>(v * 10.0) : 1000000);
    wide->SetValue(i, whole->GetValue(i));
  }
  image->GetPointData()->RemoveArray("depth");
  image->GetPointData()->SetScalars(whole);
  const auto scalars = filterOf(image);
  scalars->GetSilhouettes()->SetThreshold(15.0);
  scalars->SetBackgroundDepth(1e6);
  named->GetSilhouettes()->SetThreshold(15.0);
  named->SetBackgroundDepth(1e6);
  named->Modified();
  const auto found = silhouettesOf(scalars);
  EXPECT_EQ(found, silhouettesOf(named));
  EXPECT_NE(found, std::vector<float>(found.size(), 0.0f));
}

TEST_F(SilhouetteFilter, ThresholdsInEveryUnit)
{
  // A square of 100 x 100 pixels of 0.5 units at two depths 30 units apart: box 49.5, 49.5, 30.
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(120, 100, 1);
  vtkNew<vtkFloatArray> depth;
  depth->SetName("depth");
  depth->SetNumberOfValues(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < depth->GetNumberOfValues(); ++i)
  {
    const int x = static_cast<int>(i % 120);
    depth->SetValue(i, x < 50 ? 10.0f : x < 100 ? 40.0f : std::nanf(""));
  }
  image->GetPointData()->AddArray(depth);
  const auto filter = filterOf(image);
  filter->SetDepthModeToOrthographic();
  filter->SetParallelScale(25.0);
  filter->GetSilhouettes()->SetThresholdModeToSceneSize();
  filter->GetSilhouettes()->SetThreshold(0.1);
  filter->Update();
  EXPECT_NEAR(filter->GetStep(), 0.1 * std::sqrt(2 * 49.5 * 49.5 + 900.0), 1e-6);
  filter->SetSceneSize(70.0);
  filter->Update();
  EXPECT_DOUBLE_EQ(filter->GetStep(), 7.0);
  filter->GetSilhouettes()->SetThresholdModeToRadii();
  filter->SetParticleRadius(3.0);
  filter->Update();
  EXPECT_DOUBLE_EQ(filter->GetStep(), 0.1 * 3.0);
  // The step between the depths is drawn up to its height; hulls always are.
  filter->GetSilhouettes()->SetThresholdModeToWorld();
  filter->GetSilhouettes()->SetCentered(false);
  const auto count = [&](double threshold)
  {
    filter->GetSilhouettes()->SetThreshold(threshold);
    const auto coverage = silhouettesOf(filter);
    return std::count(coverage.begin(), coverage.end(), 1.0f);
  };
  EXPECT_EQ(count(29.9), 200);
  EXPECT_EQ(count(30.1), 100);
  filter->GetSilhouettes()->SetHulls(false);
  EXPECT_EQ(count(29.9), 100);
  // 30 units are 60 pixels.
  filter->GetSilhouettes()->SetStepInPixels(61.0);
  EXPECT_EQ(count(1.0), 0);
}

TEST_F(SilhouetteFilter, OverlayDrawsOverColors)
{
  const auto image = discs();
  const auto coverage = silhouettesOf(filterOf(image));
  const auto filter = filterOf(image);
  filter->SetOutputModeToOverlay();
  filter->GetSilhouettes()->SetColor(1.0, 0.5, 0.0);
  filter->Update();
  auto over = valuesOf(filter->GetOutput(), "color");
  ASSERT_EQ(over.size(), 4 * coverage.size());
  for (std::size_t i = 0; i < coverage.size(); ++i)
  {
    ASSERT_FLOAT_EQ(over[4 * i], coverage[i]);
    ASSERT_FLOAT_EQ(over[4 * i + 1], 0.5f * coverage[i]);
    ASSERT_FLOAT_EQ(over[4 * i + 3], coverage[i]);
  }
  vtkNew<vtkUnsignedCharArray> bytes;
  bytes->SetName("color");
  bytes->SetNumberOfComponents(4);
  bytes->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < bytes->GetNumberOfTuples(); ++i)
  {
    const unsigned char color[4] = {204, 102, 0, 51};
    bytes->SetTypedTuple(i, color);
  }
  image->GetPointData()->AddArray(bytes);
  filter->Modified();
  filter->Update();
  over = valuesOf(filter->GetOutput(), "color");
  for (std::size_t i = 0; i < coverage.size(); ++i)
  {
    ASSERT_NEAR(over[4 * i], (1.0f - coverage[i]) * 0.8f * 0.2f + coverage[i], 1e-6f);
    ASSERT_NEAR(over[4 * i + 3], (1.0f - coverage[i]) * 0.2f + coverage[i], 1e-6f);
  }
}

TEST_F(SilhouetteFilter, WhatItCannotTakeIsASentence)
{
  const auto image = discs();
  vtkNew<vtkFloatArray> triples;
  triples->SetName("triples");
  triples->SetNumberOfComponents(3);
  triples->SetNumberOfTuples(image->GetNumberOfPoints());
  image->GetPointData()->AddArray(triples);
  const auto fails = [&](vtkMoteSilhouetteFilter* filter, const std::string& sentence)
  {
    this->Messages->Text.clear();
    filter->Update();
    EXPECT_EQ(filter->GetErrorMessage(), sentence);
    EXPECT_NE(this->Messages->Text.find(sentence), std::string::npos);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  };
  const auto filter = filterOf(image);
  filter->SetDepthArrayName("none");
  fails(filter, "The image has no array \"none\" of numbers; it has depth, object, triples.");
  filter->SetDepthArrayName("triples");
  fails(filter, "The array \"triples\" has 3 numbers a pixel, and must have one.");
  filter->SetDepthArrayName("");
  filter->GetSilhouettes()->SetGroupArrayName("colour");
  fails(filter, "The image has no array \"colour\" of numbers; it has depth, object, triples.");
  filter->GetSilhouettes()->SetGroupArrayName("");
  EXPECT_FALSE(silhouettesOf(filter).empty());
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(4, 4, 1);
  fails(filterOf(bare), "The image has no array \"depth\" of numbers; it has no arrays.");
}
