// Images of a periodic box: what is drawn is what a mapper draws that was given copies of all
// particles, though only those of one image are held.
#include "VTKTestSupport.h"

#include "vtkCamera.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkMoteAreaLight.h"
#include "vtkMoteShading.h"
#include "vtkPointData.h"

#include <cmath>
#include <cstdlib>

using namespace mote::testing;

namespace
{

struct Images : ::testing::Test
{
  static constexpr int counts[3] = {3, 2, 2};
  static constexpr double vectors[9] = {1.9, 0.1, 0.0, -0.3, 2.2, 0.2, 0.1, 0.4, 2.6};
  static constexpr int many = 200;
  std::vector<Ball> balls = someBalls(many), copies;
  vtkSmartPointer<vtkPolyData> data = makeParticles(balls), all;
  Stage few{data}, full;

  Images()
  {
    for (int c = 0; c < counts[2]; ++c)
      for (int b = 0; b < counts[1]; ++b)
        for (int a = 0; a < counts[0]; ++a)
          for (const Ball& ball : balls)
            copies.push_back({ball.x + a * vectors[0] + b * vectors[3] + c * vectors[6],
              ball.y + a * vectors[1] + b * vectors[4] + c * vectors[7],
              ball.z + a * vectors[2] + b * vectors[5] + c * vectors[8], ball.r});
    all = makeParticles(copies);
    addValues(data, "value", valuesOf(balls.size()));
    addValues(all, "value", valuesOf(copies.size()));
    full.mapper->SetInputData(all);
    few.mapper->SetReplication(counts[0], counts[1], counts[2]);
    few.mapper->SetReplicationVectors(vectors);
    for (Stage* stage : {&few, &full})
    {
      stage->mapper->SetScalarRange(0, many);
      vtkCamera* camera = stage->renderer->GetActiveCamera();
      camera->SetPosition(9, -7, 11);
      camera->SetFocalPoint(2, 1, 1);
      stage->renderer->ResetCameraClippingRange();
    }
  }

  static std::vector<double> valuesOf(std::size_t count)
  {
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i)
      values.push_back(static_cast<double>(i % many));
    return values;
  }

  /// Pixels whose particle or colour differs.
  int wrongPixels()
  {
    const Picture got = few.trace(128, 128), expected = full.trace(128, 128);
    EXPECT_GT(expected.covered(), 4000);
    int wrong = 0;
    for (int i = 0; i < got.count(); ++i)
    {
      const long long id = expected.particle(i);
      bool same = got.particle(i) == (id < 0 ? id : id % many);
      for (int k = 0; k < 4; ++k)
        same = same && std::abs(got.color(i)[k] - expected.color(i)[k]) < 0.02f;
      wrong += same ? 0 : 1;
    }
    return wrong;
  }
};

} // namespace

TEST_F(Images, LookLikeCopies)
{
  EXPECT_LE(wrongPixels(), 4); // float coordinates about other origins
  EXPECT_EQ(few.mapper->GetNumberOfParticles(), many);
}

TEST_F(Images, ThrowShadowsOnOneAnother)
{
  for (Stage* stage : {&few, &full})
  {
    vtkNew<vtkMoteAreaLight> light;
    light->SetPosition(20, 3, 6);
    light->SetFocalPoint(2, 1, 1);
    light->ShadowsOn();
    stage->renderer->AddLight(light);
  }
  const int shadowed = wrongPixels();
  EXPECT_LE(shadowed, 20); // and the edges of shadows
}

TEST_F(Images, HaveBoundsOfTheirOwn)
{
  double got[6], expected[6];
  few.mapper->GetBounds(got);
  full.mapper->GetBounds(expected);
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(got[i], expected[i], 1e-5);
  for (Stage* stage : {&few, &full})
  {
    stage->mapper->AddRange("value", 0.0, 20.0);
    stage->mapper->Update();
  }
  few.mapper->GetVisibleBounds(got);
  full.mapper->GetVisibleBounds(expected);
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(got[i], expected[i], 1e-5);
  EXPECT_LE(wrongPixels(), 4);
}

TEST_F(Images, BuildNothingAnew)
{
  few.trace(16, 16);
  const int builds = few.mapper->GetNumberOfBuilds();
  const vtkTypeInt64 bytes = few.mapper->GetStructureBytes();
  few.mapper->SetReplication(4, 4, 4);
  EXPECT_GT(few.trace(64, 64).covered(), 0);
  EXPECT_EQ(few.mapper->GetNumberOfBuilds(), builds);
  EXPECT_EQ(few.mapper->GetStructureBytes(), bytes);
}
