// Ghosts: copies of what another rank has. Two ranks draw, together, the picture of one.
#include "VTKTestSupport.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkMoteAreaLight.h"
#include "vtkMoteMeshMapper.h"
#include "vtkMoteShading.h"
#include "vtkMoteSilhouettes.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
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

/// Triangles of spheres, of which a rank has those on one side; those of the others are ghosts.
vtkSmartPointer<vtkPolyData> trianglesOf(const std::vector<Ball>& balls)
{
  vtkNew<vtkAppendPolyData> append;
  for (const Ball& ball : balls)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetCenter(ball.x, ball.y, ball.z);
    sphere->SetRadius(ball.r);
    sphere->Update();
    append->AddInputData(sphere->GetOutput());
  }
  append->Update();
  return append->GetOutput();
}

enum Side
{
  Left,
  Right,
  Both
};

vtkSmartPointer<vtkPolyData> markedCells(vtkPolyData* triangles, Side side)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->ShallowCopy(triangles);
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    double bounds[6];
    data->GetCellBounds(i, bounds);
    marks->InsertNextValue(
      (bounds[0] + bounds[1] < 0) == (side == Left) ? 0 : vtkDataSetAttributes::DUPLICATECELL);
  }
  data->GetCellData()->AddArray(marks);
  return data;
}

struct Look
{
  const char* name;
  int samples;
  bool lit, lines;
  bool ofTriangles = false;

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

  /// What a rank has of one side, and with ghosts also of the other.
  vtkSmartPointer<vtkPolyData> dataOf(Side shown, bool hasGhosts) const
  {
    const std::vector<Ball>&own = shown == Left ? left : right,
          &other = shown == Left ? right : left;
    if (!GetParam().ofTriangles)
      return shown == Both ? makeParticles(all)
                           : withGhosts(own, hasGhosts ? other : decltype(own){});
    const auto triangles = trianglesOf(all);
    return shown == Both ? triangles : markedCells(triangles, shown);
  }

  vtkSmartPointer<vtkImageData> picture(Side shown, bool hasGhosts = true) const
  {
    const auto data = this->dataOf(shown, hasGhosts);
    Stage stage(makeParticles(all));
    stage.mapper->SetInputData(data);
    vtkNew<vtkMoteMeshMapper> triangles;
    triangles->SetInputData(data);
    triangles->SetMeetsGhosts(hasGhosts);
    stage.mapper->SetMeetsGhosts(hasGhosts);
    if (GetParam().ofTriangles)
      stage.actor->SetMapper(triangles);
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
  const auto one = picture(Both), first = picture(Left), second = picture(Right);
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
  const auto one = picture(Both), alone = picture(Left, false), with = picture(Left);
  int wrong = 0;
  for (int i = 0; i < side * side; ++i)
    wrong += colorOf(with, i)[3] > 0 &&
             !std::equal(colorOf(one, i), colorOf(one, i) + 4, colorOf(alone, i));
  EXPECT_GT(wrong, 100);
}

TEST(GhostsOfOneFile, CopiesInThePlaceOfParticlesAreHidden)
{
  // As where the pieces of a file were joined, the copies first.
  const std::vector<Ball> balls = someBalls(40);
  std::vector<Ball> all = balls;
  all.insert(all.end(), balls.begin(), balls.end());
  const auto data = makeParticles(all);
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  for (std::size_t i = 0; i < all.size(); ++i)
    marks->InsertNextValue(i < balls.size() ? vtkDataSetAttributes::DUPLICATEPOINT : 0);
  data->GetPointData()->AddArray(marks);
  const auto pictureOf = [](vtkPolyData* particles, vtkIdType shown)
  {
    Stage stage(particles);
    vtkNew<vtkMoteRendererSource> source;
    source->SetRenderer(stage.renderer);
    source->SetSize(64, 64);
    source->Update();
    EXPECT_EQ(stage.mapper->GetNumberOfVisibleParticles(), shown);
    const float* colors = colorOf(source->GetOutput(), 0);
    return std::vector<float>(colors, colors + 4 * 64 * 64);
  };
  const auto expected = pictureOf(makeParticles(balls), 40);
  const auto expectSame = [&](const std::vector<float>& found)
  {
    for (std::size_t i = 0; i < expected.size(); ++i)
      ASSERT_NEAR(found[i], expected[i], 1e-4F) << i; // other particles make another grid
  };
  expectSame(pictureOf(data, 40));
  // Points that are marked as hidden are so in any case.
  for (vtkIdType i = 0; i < 40; ++i)
    marks->SetValue(i, vtkDataSetAttributes::HIDDENPOINT);
  marks->Modified();
  expectSame(pictureOf(data, 40));
  Stage stage(data);
  stage.mapper->MeetsGhostsOn();
  stage.mapper->Update();
  EXPECT_EQ(stage.mapper->GetNumberOfVisibleParticles(), 40);
}

const Look plain{"Plain", 1, false, false}, lit{"Lit", 1, true, false},
  lined{"Lines", 1, false, true}, every{"LitLinesAndRays", 4, true, true},
  plainMesh{"PlainTriangles", 1, false, false, true}, litMesh{"LitTriangles", 1, true, false, true},
  linedMesh{"LinesOfTriangles", 1, false, true, true},
  everyMesh{"LitLinesAndRaysOfTriangles", 4, true, true, true};
const auto nameOf = [](const auto& info) { return info.param.name; };

INSTANTIATE_TEST_SUITE_P(Looks, Ghosts,
  ::testing::Values(plain, lit, lined, every, plainMesh, litMesh, linedMesh, everyMesh), nameOf);
INSTANTIATE_TEST_SUITE_P(
  Looks, GhostsNeeded, ::testing::Values(lit, lined, every, litMesh, linedMesh, everyMesh), nameOf);
