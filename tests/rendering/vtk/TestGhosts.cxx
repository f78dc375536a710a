// Ghosts: copies of what another rank has. Two ranks draw, together, the picture of one.
#include "VTKTestSupport.h"

#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkMoteAreaLight.h"
#include "vtkMoteShading.h"
#include "vtkMoteSilhouettes.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <ostream>

using namespace mote::testing;

namespace
{

/// The particles of a rank, and those of another as ghosts behind them.
vtkSmartPointer<vtkPolyData> withGhosts(std::vector<Ball> own, const std::vector<Ball>& ghosts)
{
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  for (std::size_t i = 0; i < own.size() + ghosts.size(); ++i)
    marks->InsertNextValue(i < own.size() ? 0 : vtkDataSetAttributes::DUPLICATEPOINT);
  own.insert(own.end(), ghosts.begin(), ghosts.end());
  vtkSmartPointer<vtkPolyData> data = makeParticles(own);
  data->GetPointData()->AddArray(marks);
  return data;
}

struct Look
{
  const char* name;
  int samples;
  bool lit, lines;

  friend std::ostream& operator<<(std::ostream& out, const Look& look) { return out << look.name; }
};

struct Ghosts : ::testing::TestWithParam<Look>
{
  static constexpr int side = 96;
  std::vector<Ball> all = someBalls(150), left, right;

  Ghosts()
  {
    for (const Ball& ball : all)
      (ball.x < 0 ? left : right).push_back(ball);
  }

  vtkSmartPointer<vtkImageData> picture(vtkPolyData* data) const
  {
    Stage stage(data);
    vtkNew<vtkMoteAreaLight> light;
    light->SetLightTypeToCameraLight();
    light->SetPosition(-1, 1, 1);
    vtkNew<vtkMoteRendererSource> source;
    source->SetRenderer(stage.renderer);
    source->SetSize(side, side);
    source->SetSamplesPerPixel(GetParam().samples);
    source->TransparentBackgroundOn();
    if (GetParam().lit)
    {
      stage.renderer->AddLight(light);
      stage.actor->GetProperty()->SetAmbient(0.5);
      source->GetShading()->SetAmbientOcclusion(vtkMoteShading::OCCLUSION_LIVE);
    }
    source->GetSilhouettes()->SetEnabled(GetParam().lines);
    source->GetSilhouettes()->SetColor(1, 0, 0);
    source->Update();
    vtkSmartPointer<vtkImageData> image = source->GetOutput();
    return image;
  }
};

const float* colorOf(vtkImageData* image, int pixel)
{
  return static_cast<float*>(image->GetPointData()->GetScalars()->GetVoidPointer(4 * pixel));
}

} // namespace

TEST_P(Ghosts, TwoRanksDrawThePictureOfOne)
{
  const auto one = picture(makeParticles(all));
  const auto first = picture(withGhosts(left, right));
  const auto second = picture(withGhosts(right, left));
  int ofFirst = 0, ofSecond = 0, ofBoth = 0, unlike = 0, differ = 0;
  for (int i = 0; i < side * side; ++i)
  {
    const float *a = colorOf(first, i), *b = colorOf(second, i), *truth = colorOf(one, i);
    ofFirst += a[3] > 0;
    ofSecond += b[3] > 0;
    ofBoth += a[3] > 0 && b[3] > 0;
    unlike += a[3] > 0 && b[3] > 0 && !std::equal(a, a + 4, b);
    const float* shown = a[3] > 0 ? a : b;
    differ += !std::equal(shown, shown + 4, truth);
  }
  EXPECT_EQ(differ, 0);
  EXPECT_EQ(unlike, 0);
  // Lines, and edges that the ray through the middle of a pixel misses, may be of either.
  EXPECT_LE(ofBoth, GetParam().lines ? ofFirst / 3 : 0);
  EXPECT_GT(ofFirst, 500);
  EXPECT_GT(ofSecond, 500);
}

/// One ray a pixel, lit evenly, needs no ghosts.
struct GhostsNeeded : Ghosts
{
};

TEST_P(GhostsNeeded, WithoutThemEdgesAndLightAreOthers)
{
  const auto one = picture(makeParticles(all)), alone = picture(makeParticles(left));
  const auto with = picture(withGhosts(left, right));
  int wrong = 0;
  for (int i = 0; i < side * side; ++i)
    wrong += colorOf(with, i)[3] > 0 &&
             !std::equal(colorOf(one, i), colorOf(one, i) + 4, colorOf(alone, i));
  EXPECT_GT(wrong, 100);
}

const Look plain{"Plain", 1, false, false}, lit{"Lit", 1, true, false},
  lined{"Lines", 1, false, true}, every{"LitLinesAndRays", 4, true, true};
const auto nameOf = [](const auto& info) { return info.param.name; };

INSTANTIATE_TEST_SUITE_P(Looks, Ghosts, ::testing::Values(plain, lit, lined, every), nameOf);
INSTANTIATE_TEST_SUITE_P(Looks, GhostsNeeded, ::testing::Values(lit, lined, every), nameOf);
